// The loader on an emulated Cortex-M: its line is the first serial port; behind the second one a
// process emulates the pixels.

#include "emulated_board.hpp"
#include "mps2.hpp"
#include "records.hpp"
#include "turn.hpp"

namespace nscc {

void begin_record(uint8_t type, size_t size) {
    uint8_t start[5] = {type};
    put32(start + 1, uint32_t(size));
    put_bytes(start, sizeof start);
}

void put_bytes(const uint8_t *data, size_t size) {
    for (size_t i = 0; i < size; ++i) {
        while (!mps2::records.has_room()) {
        }
        mps2::records.put(data[i]);
    }
}

size_t port_read(uint8_t *data, size_t room) {
    size_t count = 0;
    while (count < room && mps2::line.has_byte()) {
        data[count++] = mps2::line.get();
    }
    return count;
}

size_t port_write(const uint8_t *data, size_t count) {
    size_t sent = 0;
    while (sent < count && mps2::line.has_room()) {
        mps2::line.put(data[sent++]);
    }
    return sent;
}

uint64_t port_micros() {
    static uint64_t micros = 0;
    static uint32_t seen = 0;
    const uint32_t passed = (mps2::ticks() - seen) / limits::ticks_per_us;
    seen += passed * limits::ticks_per_us;
    micros += passed;
    return micros;
}

void port_feed_watchdog() { mps2::feed_watchdog(); }

namespace {

constexpr uint32_t patience_ticks = 1500000 * limits::ticks_per_us;

// The target's figures in parts of a tick.
constexpr uint32_t part_bits = 8;
constexpr uint32_t parts(double us) { return uint32_t(time_of(us) >> (32 - part_bits)); }
constexpr uint32_t launch = parts(target::launch_us), settling = parts(target::in_settle_us);
constexpr uint32_t analog_word = parts(target::analog_word_us);
constexpr uint32_t digital_word = parts(target::digital_word_us);

// Launches, words and IN take what the target's figures say, telling the emulator of them included.
class Chip final : public EmulatedBoard {
public:
    uint32_t ticks() override { return mps2::ticks(); }

    void run(const uint32_t (*words)[5], uint32_t count) override {
        const uint32_t begin = ticks();
        EmulatedBoard::run(words, count);
        uint32_t time = launch;
        for (uint32_t i = 0; i < count; ++i) {
            time += is_analog(words[i]) ? analog_word : digital_word;
        }
        wait(begin, time);
    }

    void set_in(int16_t steps) override {
        const uint32_t begin = ticks();
        EmulatedBoard::set_in(steps);
        wait(begin, settling);
    }

    int32_t past(uint32_t deadline, uint32_t left) override {
        int32_t late = int32_t(ticks() - deadline);
        if (late < -int32_t(left)) {
            return late;
        }
        while (late < 0) {
            late = int32_t(ticks() - deadline);
        }
        return late;
    }

    bool convert(uint32_t offset, uint8_t *bytes, uint32_t count) override {
        uint8_t wanted[12];
        put32(wanted, job_);
        put32(wanted + 4, offset);
        put32(wanted + 8, count);
        begin_record(WANTED, sizeof wanted);
        put_bytes(wanted, sizeof wanted);
        const uint32_t begin = ticks();
        while (ticks() - begin < patience_ticks) {
            uint8_t type;
            if (!next(type)) {
                continue;
            }
            if (type != BYTES) {
                take(type);
            } else if (size_ == count) {
                copy(bytes, body_, count);
                return true;
            }
        }
        return false;
    }

    // The next record from the emulator, once it is whole.
    bool next(uint8_t &type) {
        while (mps2::records.has_byte()) {
            const uint8_t byte = mps2::records.get();
            if (got_ < sizeof head_) {
                head_[got_++] = byte;
            } else if (got_ - sizeof head_ < sizeof body_) {
                body_[got_++ - sizeof head_] = byte;
            }
            if (got_ >= sizeof head_ && got_ - sizeof head_ == get32(head_ + 1)) {
                type = head_[0];
                size_ = get32(head_ + 1);
                got_ = 0;
                return true;
            }
        }
        return false;
    }

    void take(uint8_t type) {
        if (type == RESULT) {
            answered(get32(body_), body_[4] != 0);
        }
        restart_ = restart_ || type == RESTART;
    }

    bool restarts() {
        const bool restart = restart_;
        restart_ = false;
        return restart;
    }

private:
    void wait(uint32_t begin, uint32_t time) {
        while (ticks() - begin < time >> part_bits) {
        }
    }

    uint8_t head_[5], body_[target::rows > 8 ? target::rows : 8];
    size_t got_ = 0, size_ = 0;
    bool restart_ = false;
};

Chip chip;
NSCC_SHARED_RAM Loader loader(chip);

}  // namespace

[[noreturn]] void serve() {
    static Turns turns(loader);
    while (true) {
        uint8_t type;
        if (chip.next(type)) {
            chip.take(type);
        }
        if (chip.restarts()) {
            loader.start();
        }
        turns.take();
    }
}

}  // namespace nscc

int main() { nscc::serve(); }
