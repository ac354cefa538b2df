// Packets on the wire: byte stuffing between zero bytes, a header of eight bytes, a CRC-32.
#ifndef NSCC_PACKETS_HPP
#define NSCC_PACKETS_HPP

#include "bytes.hpp"

namespace nscc {

constexpr uint8_t protocol_version = 2;
constexpr size_t most_data = 1024;
constexpr size_t header_size = 8, crc_size = 4;
constexpr size_t most_body = most_data + 16;
constexpr size_t most_packet = header_size + most_body + crc_size;
constexpr size_t most_wire = most_packet + most_packet / 254 + 4;

enum Kind : uint8_t {
    HELLO = 0x01, STATUS, BEGIN, DECLARE, DATA, FINISH, CAPTURE, READ, CANCEL, CAPTURE_WITH,
    LOAD,
    BOOTED = 0xf0,
    FAILED = 0xff,
};
constexpr uint8_t reply_bit = 0x80;

struct Packet {
    uint8_t kind;
    uint16_t sequence;
    uint32_t session;
    const uint8_t *body;
    size_t size;
};

// Finds packets in a stream, a byte at a time, and never holds more than one of them.
class Unpacker {
public:
    void reset();
    // True where this byte ends a packet whose checksum holds; it stays valid until the next byte.
    bool take(uint8_t byte, Packet &packet);
    uint32_t damaged() const { return damaged_; }

private:
    void begin();
    bool keep(uint8_t byte);
    bool finish(Packet &packet);

    uint8_t data_[most_packet];
    size_t size_ = 0;
    uint32_t crc_ = crc_start;
    uint8_t code_ = 0, left_ = 0;   // of the run that is being read: its first byte, and what is left
    bool started_ = false, broken_ = false;
    uint32_t damaged_ = 0;
};

// Writes a packet as its body comes; `out` has room for most_wire bytes.
class Packer {
public:
    Packer(uint8_t *out, uint8_t kind, uint16_t sequence, uint32_t session);
    void add(const uint8_t *body, size_t count);
    // How many bytes it is.
    size_t finish();

private:
    void stuff(uint8_t byte);

    uint8_t *out_;
    size_t run_ = 1, size_ = 2;         // where the run began, and what is written
    uint32_t crc_ = crc_start;
};

}  // namespace nscc

#endif
