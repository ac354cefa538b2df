#include "packets.hpp"

namespace nscc {

void Unpacker::reset() {
    begin();
    damaged_ = 0;
}

void Unpacker::begin() {
    size_ = 0;
    crc_ = crc_start;
    code_ = left_ = 0;
    started_ = broken_ = false;
}

bool Unpacker::keep(uint8_t byte) {
    if (size_ == most_packet) {
        broken_ = true;
        return false;
    }
    data_[size_++] = byte;
    crc_ = crc_with(crc_, byte);
    return true;
}

bool Unpacker::take(uint8_t byte, Packet &packet) {
    if (byte == 0) {
        const bool whole = started_ && !broken_ && left_ == 0 && finish(packet);
        damaged_ += started_ && !whole;
        begin();
        return whole;
    }
    if (broken_) {
        return false;
    }
    if (left_ > 0) {
        left_ -= keep(byte);
        return false;
    }
    // A run begins: the one before it ended with a zero, unless it was a longest one.
    if (started_ && code_ != 0xff && !keep(0)) {
        return false;
    }
    started_ = true;
    code_ = byte;
    left_ = uint8_t(byte - 1);
    return false;
}

bool Unpacker::finish(Packet &packet) {
    if (size_ < header_size + crc_size || crc_ != crc_whole || data_[1] != 0) {
        return false;
    }
    packet = {data_[0], get16(data_ + 2), get32(data_ + 4), data_ + header_size,
              size_ - crc_size - header_size};
    return true;
}

Packer::Packer(uint8_t *out, uint8_t kind, uint16_t sequence, uint32_t session) : out_(out) {
    out_[0] = 0;
    uint8_t header[header_size] = {kind, 0};
    put16(header + 2, sequence);
    put32(header + 4, session);
    add(header, sizeof header);
}

void Packer::add(const uint8_t *body, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        crc_ = crc_with(crc_, body[i]);
        stuff(body[i]);
    }
}

// Each run's first byte is filled in when the run ends.
void Packer::stuff(uint8_t byte) {
    if (byte != 0) {
        out_[size_++] = byte;
    }
    const size_t length = size_ - run_;
    if (byte == 0 || length == 0xff) {
        out_[run_] = uint8_t(length);
        run_ = size_++;
    }
}

size_t Packer::finish() {
    uint8_t crc[crc_size];
    put32(crc, ~crc_);
    for (uint8_t byte : crc) {
        stuff(byte);
    }
    out_[run_] = uint8_t(size_ - run_);
    out_[size_] = 0;
    return size_ + 1;
}

}  // namespace nscc
