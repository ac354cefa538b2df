// Takes a buffer apart, never reading behind its end.
#ifndef NSCC_READER_HPP
#define NSCC_READER_HPP

#include "bytes.hpp"

namespace nscc {

class Reader {
public:
    Reader(const uint8_t *data, uint32_t length) : data_(data), length_(length) {}

    // Null where fewer bytes are left.
    const uint8_t *take(uint32_t count) {
        if (length_ - at_ < count) {
            return nullptr;
        }
        at_ += count;
        return data_ + at_ - count;
    }
    bool take_count(uint32_t &value) {
        const uint8_t *at = take(4);
        value = at ? get32(at) : 0;
        return at != nullptr;
    }
    uint32_t at() const { return at_; }
    bool ended() const { return at_ == length_; }

private:
    const uint8_t *data_;
    uint32_t length_, at_ = 0;
};

}  // namespace nscc

#endif
