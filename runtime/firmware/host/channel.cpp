#include "channel.hpp"

#include <cerrno>
#include <cstdlib>

#include <unistd.h>

#include "bytes.hpp"

namespace nscc {

namespace {

constexpr int channel_out = 1;
constexpr size_t head = 5;
constexpr size_t most_read = 1 << 16;
constexpr size_t most_record = 1 << 25;
constexpr size_t most_waiting = 1 << 16;

std::vector<uint8_t> waiting;

}  // namespace

void begin_record(uint8_t type, size_t size) {
    uint8_t start[head] = {type};
    put32(start + 1, uint32_t(size));
    put_bytes(start, head);
}

void put_bytes(const uint8_t *data, size_t size) {
    waiting.insert(waiting.end(), data, data + size);
    if (waiting.size() > most_waiting) {
        flush_records();
    }
}

void flush_records() {
    const uint8_t *data = waiting.data();
    size_t size = waiting.size();
    while (size > 0) {
        const ssize_t some = write(channel_out, data, size);
        if (some < 0 && errno == EINTR) {
            continue;
        }
        if (some <= 0) {
            std::exit(1);       // the emulator is gone
        }
        data += some;
        size -= size_t(some);
    }
    waiting.clear();
}

bool Records::fill() {
    const size_t before = held_.size();
    held_.resize(before + most_read);
    ssize_t some = read(channel_in, held_.data() + before, most_read);
    if (some < 0 && (errno == EINTR || errno == EAGAIN)) {
        some = 0;
    } else if (some <= 0) {
        return false;
    }
    held_.resize(before + size_t(some));
    return true;
}

bool Records::next(uint8_t &type, std::vector<uint8_t> &data) {
    if (held_.size() < head) {
        return false;
    }
    const size_t size = get32(held_.data() + 1);
    if (size > most_record) {
        std::exit(1);
    }
    if (held_.size() < head + size) {
        return false;
    }
    type = held_[0];
    const auto begin = held_.begin() + head;
    data.assign(begin, begin + std::ptrdiff_t(size));
    held_.erase(held_.begin(), begin + std::ptrdiff_t(size));
    return true;
}

}  // namespace nscc
