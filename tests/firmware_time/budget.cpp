// How many instructions the loader takes where time counts, on a board whose emulator takes a
// nanosecond for each: prints them, for a launch of the frame's loop and for a byte of a frame.

#include "mps2.hpp"
#include "schedule.hpp"

namespace {

using namespace nscc;

constexpr uint32_t launches = 1000, instructions_a_tick = 40;

// Never waits: every boundary is past.
class Chip final : public Board {
public:
    void forget() override {}
    bool load_plane(uint8_t, const uint8_t *, Refresher &) override { return true; }
    void take_words(const uint32_t *, uint32_t) override {}
    void take_slots(const uint8_t *, uint32_t) override {}
    uint32_t ticks() override { return mps2::ticks(); }
    void begin_frame() override {}
    void pass(uint32_t) override {}
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
    void run(const uint32_t (*)[5], uint32_t count) override { words += count; }
    void set_in(int16_t) override {}
    void read_out(const Contents &) override {}
    Exposing exposing() override { return Exposing::DONE; }
    bool convert(uint32_t, uint8_t *, uint32_t) override { return true; }

    uint32_t words = 0;
};

void print(uint32_t value) {
    char digits[12];
    int count = 0;
    do {
        digits[count++] = char('0' + value % 10);
        value /= 10;
    } while (value > 0);
    while (count > 0) {
        while (!mps2::line.has_room()) {
        }
        mps2::line.put(uint8_t(digits[--count]));
    }
    mps2::line.put('\n');
}

Chip chip;
Kernels kernels;
Schedule schedule(chip, kernels);
const uint32_t word[1][5] = {};

// Slots that take no time, `alike` of them in a run, launched `times` times a row.
uint32_t launch_instructions(uint32_t alike, uint32_t times) {
    constexpr uint64_t nanosecond = 0x3f50624dd2f1a9fc;     // 0.001 as a double
    uint8_t *at = schedule.bytes();
    const auto put = [&](uint32_t value) {
        put32(at, value);
        at += 4;
    };
    put(launches);
    put(0xffffffff);
    put(0xffffffff);
    put(launches / alike);
    for (uint32_t i = 0; i < launches / alike; ++i) {
        put(alike);
        put64(at, nanosecond);
        at += 8;
    }
    put(launches / times);
    for (uint32_t i = 0; i < launches / times; ++i) {
        put(1);
        put(times << 16);
    }
    if (!schedule.accept(uint32_t(at - schedule.bytes())).good() || !schedule.check(0).good()) {
        return 0;
    }
    schedule.begin_frame();
    const Schedule::Now now = schedule.go_on();
    const uint32_t took = schedule.lasted_ticks() * instructions_a_tick;
    return now == Schedule::Now::ENDED ? took / launches : 0;
}

uint32_t sum_instructions() {
    static uint8_t bytes[4096];
    FrameSum sum;
    sum.reset();
    const uint32_t begin = mps2::ticks();
    sum.add(bytes, sizeof bytes);
    const uint32_t took = (mps2::ticks() - begin) * instructions_a_tick;
    return sum.crc() != 0 ? took / uint32_t(sizeof bytes) : 0;
}

}  // namespace

int main() {
    kernels.count = 1;
    kernels.kernel[1] = {1, 0, 0, 0};
    kernels.words = word;
    print(launch_instructions(launches, launches));
    print(launch_instructions(launches / 50, 1));
    print(sum_instructions());
}
