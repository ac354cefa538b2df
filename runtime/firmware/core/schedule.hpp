// When what runs: a SCHEDULE object, with its times as whole numbers, and the loop that keeps them.
#ifndef NSCC_SCHEDULE_HPP
#define NSCC_SCHEDULE_HPP

#include "board.hpp"
#include "limits.hpp"
#include "params.hpp"
#include "target.hpp"
#include "verdict.hpp"

namespace nscc {

// A boundary that is further away than this lets the main loop go round before it.
constexpr uint32_t breath_us = 200;
// No frame keeps the main loop from its work for longer than this.
constexpr uint32_t longest_stretch_us = 2000000;
// After so long without a look at the line one is taken in any wait that is longer than a glance,
// and after twice that time without a wait.
constexpr uint32_t deaf_us = 5000, glance_us = 20;
// From the first word of a frame to its last: well inside half of the clock's range.
constexpr uint32_t longest_us = 1200000000u / limits::ticks_per_us;

// Ticks of the clock with 32 bits of fraction: what 2^20 slots add up to is exact to 2^-12 ticks.
using Time = uint64_t;
constexpr Time tick = Time(1) << 32;

// A time of the target's, at most that of the longest frame, which no frame can take then.
constexpr Time time_of(double us) {
    return Time((us < longest_us ? us : double(longest_us)) * limits::ticks_per_us * double(tick));
}

// What a kernel's words are to a schedule: where they begin, how many are analog, which digital
// registers they write (a bit each), and how many of them end with its last reset of PIX.
struct Kernel {
    uint32_t first, analog, written, to_reset;
};

// The words that were accepted: kernel k is words[kernel[k].first] to words[kernel[k + 1].first].
struct Kernels {
    uint32_t count;
    Kernel kernel[limits::most_kernels + 1];
    const uint32_t (*words)[5];

    uint32_t length(uint32_t k) const { return kernel[k + 1].first - kernel[k].first; }
};

// The lengths of slots, one after the other.
class Slots {
public:
    void begin(const uint32_t *runs);
    // How long so many slots are together.
    Time pass(uint32_t slots) {
        Time sum = 0;
        while (slots > left_) {
            sum += left_ * each_;
            slots -= left_;
            begin(run_ + 3);
        }
        left_ -= slots;
        return sum + (slots == 1 ? each_ : slots * each_);
    }

private:
    const uint32_t *run_;
    uint32_t left_;
    Time each_;
};

class Schedule {
public:
    static constexpr uint32_t most_bytes =
        4 * (5 + 3 * limits::most_runs + 2 * limits::most_rows);

    static constexpr uint32_t levels_bytes = 4 + 2 * limits::most_rows;

    Schedule(Board &board, const Kernels &kernels) : board_(board), kernels_(kernels) {}

    void forget() {
        is_first_ = true;
        level_count_ = 0;
        params_.forget();
    }
    // Where the bytes of the objects go.
    uint8_t *bytes() { return reinterpret_cast<uint8_t *>(raw_); }
    uint8_t *levels() { return levels_raw_; }
    // A level of IN for each row of the schedule that is to come.
    Verdict accept_levels(uint32_t length);
    // Checks an object that is whole; from then on its times are whole numbers.
    Verdict accept(uint32_t length);
    // Checks the parameters of the schedule that is here.
    Verdict accept_params(uint32_t length);
    Params &params() { return params_; }
    // Whether every frame ends in time, leaves the main loop room, and lets none of the registers
    // in the bit mask `held` fade.
    Verdict check(uint32_t held);
    // A frame's time from its first word to its last, at most.
    uint32_t length_us() const { return length_us_; }

    // WAITING: there is time for everything; GLANCE: for a look at the line, whether the frame is
    // wanted no more.
    enum class Now : uint8_t { WAITING, GLANCE, ENDED, TOO_LATE };
    // Nothing is known of a frame's times any more; another one comes.
    void forget_frame() { lasted_ = late_ = latest_ = 0; }
    void begin_frame();
    // Goes on with the frame until it has ended, or there is time, or is later than it may be.
    Now go_on();
    // Launches that came later than they may, and by how many ticks the latest one did.
    uint32_t late() const { return late_; }
    uint32_t latest_ticks() const { return latest_; }
    // How long the frame took, once it has ended.
    uint32_t lasted_ticks() const { return lasted_; }

private:
    const uint32_t *runs() const { return raw_ + 4; }
    const uint32_t *rows() const { return raw_ + 5 + 3 * raw_[3]; }
    Time busy(uint32_t kernel) const;
    Time setup() const;
    int16_t level(uint32_t row) const;
    void apply_params();
    [[gnu::always_inline]] inline bool next_row();

    Board &board_;
    const Kernels &kernels_;
    uint32_t row_count_ = 0, level_count_ = 0, rest_ = 0, grace_ticks_ = 0, length_us_ = 0;
    Time setup_ = 0;
    // The frame that is being exposed.
    Slots slots_;
    Time due_;
    const uint32_t *row_, *end_;
    uint32_t times_, advance_, kernel_words_;
    uint32_t began_, lasted_ = 0, late_ = 0, latest_ = 0;
    const uint32_t (*words_)[5];
    int16_t level_, in_;
    bool waiting_;
    bool is_first_ = true;              // no frame of the program has ended yet
    // Slots, grace in ns, most late launches, runs; then for each run: slots, microseconds of each
    // (a double, then a Time); rows; then for each: advance, kernel and times.
    uint32_t raw_[most_bytes / 4];
    uint8_t levels_raw_[levels_bytes];
    Params params_;
    uint16_t most_times_[Params::most_changes];     // what the row of a change says
};

}  // namespace nscc

#endif
