#include "schedule.hpp"

#include "reader.hpp"

namespace nscc {

namespace {

constexpr uint32_t most_slots = 1u << 20, most_launches = 1u << 20;
constexpr int16_t as_it_is = -32768;    // a level that leaves IN alone

constexpr Time us_time(uint32_t us) { return Time(us) * limits::ticks_per_us << 32; }

constexpr Time longest = us_time(longest_us), longest_stretch = us_time(longest_stretch_us);
constexpr Time analog_word = time_of(target::analog_word_us);
constexpr Time digital_word = time_of(target::digital_word_us);
constexpr Time launch = time_of(target::launch_us);
constexpr Time settling = time_of(target::in_settle_us);
constexpr Time retention = time_of(target::retention_us);
constexpr Time breath = us_time(breath_us);

// What is longer than the longest frame is as good as any other such time.
Time bounded(Time time) { return time > longest ? longest + 1 : time; }

Time times(uint32_t count, Time each) {
    Time product;
    const bool overflow = __builtin_mul_overflow(Time(count), each, &product);
    return overflow ? longest + 1 : bounded(product);
}

// A double above 0 as microseconds with 32 bits of fraction, rounded; false for any other, and for
// 2^31 and more. Without arithmetic of doubles, which a small chip does in software.
bool fixed_point(const uint8_t *at, Time &us) {
    const Time bits = get64(at), fraction = bits & ((Time(1) << 52) - 1);
    const uint32_t exponent = uint32_t(bits >> 52);         // with the sign above it
    if (bits == 0 || exponent > 1053) {
        return false;
    }
    const Time mantissa = exponent > 0 ? fraction | Time(1) << 52 : fraction;
    const uint32_t down = 1043 - (exponent > 0 ? exponent : 1);
    if (exponent >= 1043) {
        us = mantissa << (exponent - 1043);
    } else {
        us = down > 63 ? 0 : ((mantissa >> (down - 1)) + 1) >> 1;
    }
    return true;
}

// A launch of so many words.
Time words_time(uint32_t analog, uint32_t digital) {
    return bounded(launch + times(analog, analog_word) + times(digital, digital_word));
}

void store(uint32_t *at, Time value) {
    at[0] = uint32_t(value);
    at[1] = uint32_t(value >> 32);
}

}  // namespace

void Slots::begin(const uint32_t *runs) {
    run_ = runs;
    left_ = runs[0];
    each_ = runs[1] | Time(runs[2]) << 32;
}

Verdict Schedule::accept_levels(uint32_t length) {
    level_count_ = 0;
    Reader reader(levels_raw_, length);
    uint32_t count;
    if (!reader.take_count(count)) {
        return refused(SCHEDULE, reader.at());
    }
    if (count > limits::most_rows) {
        return refused(TOO_LARGE, count);
    }
    const uint8_t *first = reader.take(2 * count);
    if (!first || !reader.ended()) {
        return refused(SCHEDULE, reader.at());
    }
    for (uint32_t i = 0; i < count; ++i) {
        const int16_t level = int16_t(get16(first + 2 * i));
        if (level != as_it_is && (level < target::in_low || level > target::in_high)) {
            return refused(SCHEDULE, 6);
        }
    }
    level_count_ = count;
    return fine;
}

int16_t Schedule::level(uint32_t row) const {
    return level_count_ > 0 ? int16_t(get16(levels_raw_ + 4 + 2 * row)) : as_it_is;
}

// Changes come in the order of their rows, so that a walk over the rows meets them. Rows with light
// before them are executed once, whatever the values are.
Verdict Schedule::accept_params(uint32_t length) {
    const Verdict verdict = params_.accept(length);
    if (!verdict.good()) {
        return verdict;
    }
    uint32_t row = 0;
    for (uint32_t i = 0; i < params_.changes(); ++i) {
        const Change change = params_.change(i);
        const bool sets_level = change.what == Change::LEVEL;
        const bool has_param = change.what == Change::START || change.param < params_.count();
        if (change.row < row || change.row >= row_count_ || !has_param ||
            change.what > Change::START || (sets_level && level_count_ == 0) ||
            (!sets_level && rows()[2 * change.row] > 0)) {
            params_.forget();
            return refused(SCHEDULE, 10);
        }
        for (int high = 0; sets_level && high < 2; ++high) {
            const int64_t level = Params::result(change, params_.end(change.param, high != 0));
            if (level < target::in_low || level > target::in_high) {
                params_.forget();
                return refused(SCHEDULE, 6);
            }
        }
        row = change.row;
        most_times_[i] = uint16_t(rows()[2 * row + 1] >> 16);
    }
    return fine;
}

// Makes the rows what the values of the parameters say.
void Schedule::apply_params() {
    uint32_t *row = raw_ + 5 + 3 * raw_[3];
    for (uint32_t i = 0; i < params_.changes(); ++i) {
        const Change change = params_.change(i);
        const bool starts = change.what == Change::START;
        const int64_t result = starts ? is_first_ * most_times_[i] : params_.result(change);
        if (change.what == Change::LEVEL) {
            put16(levels_raw_ + 4 + 2 * change.row, uint16_t(int16_t(result)));
        } else {
            const int64_t some = result < 0 ? 0 : result;
            const uint32_t times = some > most_times_[i] ? most_times_[i] : uint32_t(some);
            row[2 * change.row + 1] = (row[2 * change.row + 1] & 0xffff) | times << 16;
        }
    }
}

Verdict Schedule::accept(uint32_t length) {
    params_.forget();
    Reader reader(bytes(), length);
    uint32_t slots, grace_ns, most_late, runs, rows;
    if (!reader.take_count(slots) || !reader.take_count(grace_ns) ||
        !reader.take_count(most_late)) {
        return refused(SCHEDULE, reader.at());
    }
    if (slots < 1 || slots > most_slots) {
        return refused(SCHEDULE, 1);
    }
    if (!reader.take_count(runs)) {
        return refused(SCHEDULE, reader.at());
    }
    if (runs > limits::most_runs) {
        return refused(TOO_LARGE, runs);
    }
    const uint8_t *first_run = reader.take(12 * runs);
    if (!first_run) {
        return refused(SCHEDULE, reader.at());
    }
    uint64_t total = 0;
    Time exposure = 0;
    bool void_run = false, odd_length = false;
    for (uint32_t i = 0; i < runs; ++i) {
        const uint8_t *at = first_run + 12 * i;
        Time us = 0;
        total += get32(at);
        void_run = void_run || get32(at) == 0;
        odd_length = odd_length || !fixed_point(at + 4, us);
        exposure = bounded(exposure + times(get32(at), times(limits::ticks_per_us, us)));
    }
    if (total != slots || void_run) {
        return refused(SCHEDULE, 2);
    }
    if (odd_length) {
        return refused(SCHEDULE, 3);
    }
    if (exposure > longest) {
        return refused(SCHEDULE, 7);
    }
    if (!reader.take_count(rows)) {
        return refused(SCHEDULE, reader.at());
    }
    if (rows > limits::most_rows) {
        return refused(TOO_LARGE, rows);
    }
    const uint8_t *first_row = reader.take(8 * rows);
    if (!first_row || !reader.ended()) {
        return refused(SCHEDULE, reader.at());
    }
    uint64_t boundary = 0, launches = 0;
    for (uint32_t i = 0; i < rows; ++i) {
        const uint8_t *at = first_row + 8 * i;
        const uint32_t repeated = get16(at + 6);
        boundary += uint64_t(get32(at)) * repeated;
        launches += repeated;
        if (repeated == 0 || boundary > slots || launches > most_launches ||
            get16(at + 4) >= kernels_.count) {
            return refused(SCHEDULE, 4);
        }
    }
    if (level_count_ > 0 && level_count_ != rows) {
        return refused(SCHEDULE, 5);
    }
    board_.take_slots(first_run, runs);
    for (uint32_t i = 0; i < runs; ++i) {
        Time us = 0;
        fixed_point(first_run + 12 * i + 4, us);
        store(raw_ + 5 + 3 * i, us * limits::ticks_per_us);
    }
    row_count_ = rows;
    rest_ = slots - uint32_t(boundary);
    grace_ticks_ = grace_ns / 1000 * limits::ticks_per_us +
                   grace_ns % 1000 * limits::ticks_per_us / 1000;
    return fine;
}

// What launching a kernel takes, by the target's figures.
Time Schedule::busy(uint32_t kernel) const {
    const uint32_t analog = kernels_.kernel[kernel].analog;
    const uint32_t digital = kernels_.length(kernel) - analog;
    return words_time(analog, digital);
}

// From the frame's first word to the end of the reset that begins the exposure.
Time Schedule::setup() const {
    const uint32_t *row = rows();
    Time elapsed = 0, setup = 0;
    for (uint32_t i = 0; i < row_count_ && row[0] == 0 && elapsed <= longest; ++i, row += 2) {
        const uint32_t k = row[1] & 0xffff, repeated = row[1] >> 16;
        const Kernel &kernel = kernels_.kernel[k];
        const Time each = busy(k);
        if (kernel.to_reset > 0) {
            uint32_t analog = 0;
            for (uint32_t n = 0; n < kernel.to_reset; ++n) {
                analog += is_analog(kernels_.words[kernel.first + n]);
            }
            setup = bounded(elapsed + times(repeated - 1, each) +
                            words_time(analog, kernel.to_reset - analog));
        }
        elapsed = bounded(elapsed + times(repeated, each));
    }
    return setup;
}

Verdict Schedule::check(uint32_t held) {
    setup_ = setup();
    Time now = 0, boundary = setup_, stretch_from = 0;
    Time written[target::digital_count] = {};
    bool cramped = false, faded = false;
    Slots slots;
    slots.begin(runs());
    const auto wait_for = [&](uint32_t passing) {
        boundary += slots.pass(passing);
        if (boundary > now + breath) {
            stretch_from = boundary;
        }
        now = boundary > now ? boundary : now;
    };
    const auto see = [&](uint32_t registers) {
        for (uint32_t reg = 0; reg < target::digital_count; ++reg) {
            if (registers & held & 1u << reg) {
                faded = faded || now > written[reg] + retention;
                written[reg] = now;
            }
        }
        cramped = cramped || now > stretch_from + longest_stretch;
    };
    const uint32_t *row = rows();
    int16_t in = as_it_is;
    uint32_t change = 0;
    for (uint32_t i = 0; i < row_count_ && now <= longest; ++i, row += 2) {
        const uint32_t k = row[1] & 0xffff;
        const Time each = busy(k);
        bool is_changed = false;        // by a parameter, which takes the time to settle
        for (; change < params_.changes() && params_.change(change).row == i; ++change) {
            is_changed = is_changed || params_.change(change).what == Change::LEVEL;
        }
        for (uint32_t left = row[1] >> 16; left > 0 && now <= longest; --left) {
            if (row[0] > 0) {
                wait_for(row[0]);
            }
            if (is_changed || (level(i) != as_it_is && level(i) != in)) {
                now += settling;
                in = is_changed ? as_it_is : level(i);
            }
            now += each;
            see(kernels_.kernel[k].written);
        }
    }
    if (rest_ > 0 && now <= longest) {
        wait_for(rest_);
    }
    see(held);
    if (now > longest) {
        return refused(SCHEDULE, 7);
    }
    length_us_ = uint32_t(now >> 32) / limits::ticks_per_us + 1;
    return cramped ? refused(SCHEDULE, 8) : faded ? refused(SCHEDULE, 9) : fine;
}

void Schedule::begin_frame() {
    forget_frame();
    apply_params();
    slots_.begin(runs());
    row_ = rows();
    end_ = row_ + 2 * row_count_;
    times_ = 0;
    waiting_ = false;
    level_ = in_ = as_it_is;
    board_.begin_frame();
    began_ = board_.ticks();
    due_ = (Time(began_) << 32) + setup_ + tick / 2;
}

// The next row that is executed at all; what follows the rows is one, with slots and no words.
bool Schedule::next_row() {
    const uint32_t *row;
    do {
        row = row_;
        row_ = row + 2;
        if (row >= end_) {
            advance_ = rest_;
            times_ = 1;
            words_ = nullptr;
            return row == end_;
        }
        times_ = row[1] >> 16;
    } while (times_ == 0);
    const uint32_t k = row[1] & 0xffff;
    advance_ = row[0];
    if (level_count_ > 0) {
        const int16_t wanted = level(uint32_t(row - rows()) / 2);
        level_ = wanted == as_it_is ? level_ : wanted;
    }
    words_ = kernels_.words + kernels_.kernel[k].first;
    kernel_words_ = kernels_.length(k);
    return true;
}

Schedule::Now Schedule::go_on() {
    constexpr uint32_t deaf = deaf_us * limits::ticks_per_us;
    constexpr uint32_t glance = glance_us * limits::ticks_per_us;
    constexpr uint32_t breath_ticks = breath_us * limits::ticks_per_us;
    const uint32_t deaf_from = board_.ticks() + deaf;
    uint32_t left = breath_ticks;
    while (true) {
        if (!waiting_) {
            if (times_ == 0 && !next_row()) {
                lasted_ = board_.ticks() - began_;
                is_first_ = false;
                return Now::ENDED;
            }
            if (advance_ > 0) {
                board_.pass(advance_);
                due_ += slots_.pass(advance_);
                waiting_ = true;
            } else if (int32_t(board_.ticks() - deaf_from) > int32_t(deaf)) {
                return Now::GLANCE;
            }
        }
        if (waiting_) {
            const uint32_t deadline = uint32_t(due_ >> 32);
            const int32_t past = board_.past(deadline, left);
            if (past < 0) {
                return past < -int32_t(breath_ticks) ? Now::WAITING : Now::GLANCE;
            }
            const int32_t deaf_for = int32_t(deadline + uint32_t(past) - deaf_from);
            if (deaf_for > 0) {
                if (deaf_for > int32_t(deaf)) {
                    return Now::GLANCE;
                }
                left = glance;
            }
            waiting_ = false;
            latest_ = uint32_t(past) > latest_ ? uint32_t(past) : latest_;
            if (uint32_t(past) > grace_ticks_ && ++late_ > raw_[2]) {
                return Now::TOO_LATE;
            }
        }
        --times_;
        if (level_ != in_) {
            board_.set_in(level_);
            in_ = level_;
        }
        if (words_) {
            board_.run(words_, kernel_words_);
        }
    }
}

}  // namespace nscc
