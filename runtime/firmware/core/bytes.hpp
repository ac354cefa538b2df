// Little-endian integers in byte buffers, checksums, and byte stuffing.
#ifndef NSCC_BYTES_HPP
#define NSCC_BYTES_HPP

#include <cstddef>
#include <cstdint>

namespace nscc {

inline uint16_t get16(const uint8_t *at) { return uint16_t(at[0] | at[1] << 8); }
inline uint32_t get32(const uint8_t *at) {
    return uint32_t(get16(at)) | uint32_t(get16(at + 2)) << 16;
}
inline uint64_t get64(const uint8_t *at) {
    return uint64_t(get32(at)) | uint64_t(get32(at + 4)) << 32;
}
inline void put16(uint8_t *at, uint16_t value) {
    at[0] = uint8_t(value);
    at[1] = uint8_t(value >> 8);
}
inline void put32(uint8_t *at, uint32_t value) {
    put16(at, uint16_t(value));
    put16(at + 2, uint16_t(value >> 16));
}
inline void put64(uint8_t *at, uint64_t value) {
    put32(at, uint32_t(value));
    put32(at + 4, uint32_t(value >> 32));
}

bool equal(const uint8_t *a, const uint8_t *b, size_t count);
void copy(uint8_t *to, const uint8_t *from, size_t count);
void clear(uint8_t *at, size_t count);

// CRC-32 as in Ethernet and zlib, a byte at a time, from crc_start on; its complement is the
// checksum. A message and its checksum behind it leave crc_whole.
constexpr uint32_t crc_start = 0xffffffff, crc_whole = 0xdebb20e3;
extern const uint32_t crc_table[16];
inline uint32_t crc_with(uint32_t crc, uint8_t byte) {
    // Four bits at a time: sixteen entries are enough for a slow memory.
    crc ^= byte;
    crc = crc >> 4 ^ crc_table[crc & 15];
    return crc >> 4 ^ crc_table[crc & 15];
}

// CRC-32 and Adler-32, both as in zlib, of bytes as they come: what a frame's bytes are checked by.
class FrameSum {
public:
    void reset();
    void add(const uint8_t *data, size_t count);
    uint32_t crc() const { return ~crc_; }
    uint32_t adler() const { return b_ << 16 | a_; }

private:
    uint32_t crc_, a_, b_;
};

class Sha256 {
public:
    static constexpr size_t size = 32;

    Sha256() { reset(); }
    void reset();
    void add(const uint8_t *data, size_t count);
    void finish(uint8_t (&digest)[size]);

private:
    void block(const uint8_t *at);

    uint32_t state_[8];
    uint64_t length_;
    uint8_t pending_[64];
    size_t held_;
};

}  // namespace nscc

#endif
