#include "packets.hpp"

namespace nscc {

void Unpacker::reset() {
    size_ = 0;
    code_ = left_ = 0;
    started_ = broken_ = false;
    damaged_ = 0;
}

bool Unpacker::take(uint8_t byte, Packet &packet) {
    if (byte == 0) {
        const bool whole = started_ && !broken_ && left_ == 0 && finish(packet);
        damaged_ += started_ && !whole;
        size_ = 0;
        code_ = left_ = 0;
        started_ = broken_ = false;
        return whole;
    }
    if (broken_) {
        return false;
    }
    if (left_ == 0) {
        // A run begins: the one before it ended with a zero, unless it was a longest one.
        if (started_ && code_ != 0xff) {
            if (size_ == most_packet) {
                broken_ = true;
                return false;
            }
            data_[size_++] = 0;
        }
        started_ = true;
        code_ = byte;
        left_ = uint8_t(byte - 1);
        return false;
    }
    if (size_ == most_packet) {
        broken_ = true;
        return false;
    }
    data_[size_++] = byte;
    --left_;
    return false;
}

bool Unpacker::finish(Packet &packet) {
    if (size_ < header_size + crc_size) {
        return false;
    }
    const size_t plain = size_ - crc_size;
    if (crc32(data_, plain) != get32(data_ + plain) || data_[1] != 0) {
        return false;
    }
    packet = {data_[0], get16(data_ + 2), get32(data_ + 4), data_ + header_size,
              plain - header_size};
    return true;
}

namespace {

// Stuffs bytes as they come: each run's first byte is filled in when the run ends.
class Stuffer {
public:
    explicit Stuffer(uint8_t *out) : out_(out), run_(0), size_(1) {}

    void add(const uint8_t *data, size_t count) {
        for (size_t i = 0; i < count; ++i) {
            if (data[i] != 0) {
                out_[size_++] = data[i];
            }
            const size_t length = size_ - run_;
            if (data[i] == 0 || length == 0xff) {
                end(length);
            }
        }
    }

    size_t finish() {
        out_[run_] = uint8_t(size_ - run_);
        return size_;
    }

private:
    void end(size_t length) {
        out_[run_] = uint8_t(length);
        run_ = size_++;
    }

    uint8_t *out_;
    size_t run_, size_;
};

}  // namespace

size_t packed(uint8_t *out, uint8_t kind, uint16_t sequence, uint32_t session,
              const uint8_t *body, size_t size) {
    uint8_t plain[most_packet];
    plain[0] = kind;
    plain[1] = 0;
    put16(plain + 2, sequence);
    put32(plain + 4, session);
    copy(plain + header_size, body, size);
    const size_t length = header_size + size;
    put32(plain + length, crc32(plain, length));
    out[0] = 0;
    Stuffer stuffer(out + 1);
    stuffer.add(plain, length + crc_size);
    const size_t wire = 1 + stuffer.finish();
    out[wire] = 0;
    return wire + 1;
}

}  // namespace nscc
