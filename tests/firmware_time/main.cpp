// The frame's loop with a clock that moves as it is told: what it launches, and when.
//
// Reads from standard input: how many ticks a launch takes, how often it is told that a boundary is
// far away; then the SCHEDULE and KERNELS objects as lengths and bytes. Prints for each launch the
// tick at which it began, then how the frame ended, and the most ticks without a look at the line.

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "program.hpp"

namespace {

using namespace nscc;

uint32_t from_input() {
    uint8_t bytes[4];
    if (std::fread(bytes, 1, 4, stdin) != 4) {
        std::exit(2);
    }
    return get32(bytes);
}

class Clock final : public Board {
public:
    uint32_t now = 0xfffffff0, each = 0;        // the clock goes round in every frame
    void forget() override {}
    bool load_plane(uint8_t, const uint8_t *, Refresher &) override { return true; }
    void take_words(const uint32_t *, uint32_t) override {}
    void take_slots(const uint8_t *, uint32_t) override {}
    uint32_t ticks() override { return now; }
    void begin_frame() override {}
    void pass(uint32_t) override {}
    int32_t past(uint32_t deadline, uint32_t left) override {
        const int32_t late = int32_t(now - deadline);
        if (late < -int32_t(left) && !told_) {
            told_ = true;
            return late;
        }
        told_ = false;
        now = late < 0 ? deadline : now;
        return late < 0 ? 0 : late;
    }
    void run(const uint32_t (*)[5], uint32_t) override {
        std::printf("%u\n", unsigned(now - 0xfffffff0));
        now += each;
    }
    void set_in(int16_t) override {}
    void read_out(const Contents &) override {}
    Exposing exposing() override { return Exposing::DONE; }
    bool convert(uint32_t, uint8_t *, uint32_t) override { return true; }

private:
    bool told_ = false;
};

Clock board;
uint8_t plane[Program::plane_bytes];
Program program(board, plane);

void take(uint8_t kind) {
    const uint32_t length = from_input();
    Verdict verdict = fine;
    uint8_t *room = program.room_for(kind, length, verdict);
    if (!room || std::fread(room, 1, length, stdin) != length) {
        std::exit(2);
    }
    verdict = program.accept(kind, 0, length);
    if (!verdict.good()) {
        std::printf("refused %u %u\n", unsigned(verdict.fault), unsigned(verdict.detail));
        std::exit(0);
    }
}

}  // namespace

int main() {
    board.each = from_input();
    take(KERNELS);
    take(SCHEDULE_ROWS);
    Schedule &schedule = program.schedule();
    const Verdict verdict = schedule.check(0);
    if (!verdict.good()) {
        std::printf("refused %u %u\n", unsigned(verdict.fault), unsigned(verdict.detail));
        return 0;
    }
    schedule.begin_frame();
    unsigned turns = 1;
    Schedule::Now now;
    uint32_t looked = board.now, longest = 0;
    while ((now = schedule.go_on()) == Schedule::Now::WAITING || now == Schedule::Now::GLANCE) {
        turns += now == Schedule::Now::WAITING;
        longest = board.now - looked > longest ? board.now - looked : longest;
        looked = board.now;
    }
    std::printf("%s %u %u %u %u %u\n", now == Schedule::Now::ENDED ? "ended" : "late", turns,
                unsigned(schedule.lasted_ticks()), unsigned(schedule.late()),
                unsigned(schedule.latest_ticks()), unsigned(longest));
}
