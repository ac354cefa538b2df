#include "program.hpp"

namespace nscc {

#ifdef __BYTE_ORDER__
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "words are run from where they arrive");
#endif

namespace {

constexpr uint32_t most_slots = 1u << 20, most_launches = 1u << 20;
constexpr double longest_slot_us = 1e15;
constexpr int16_t as_it_is = -32768;    // a level that leaves IN alone

bool finite(double value) { return value - value == 0; }

// Takes a buffer apart, never reading behind its end.
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

}  // namespace

void Program::forget() {
    has_readouts_ = has_kernels_ = has_schedule_ = false;
    readout_count_ = kernel_count_ = slots_ = run_count_ = row_count_ = planes_ = 0;
    level_count_ = state_count_ = 0;
    for (bool &held : held_) {
        held = false;
    }
    board_.forget();
}

uint8_t *Program::room_for(uint8_t kind, uint32_t length, Verdict &verdict) {
    uint32_t room = 0;
    uint8_t *at = nullptr;
    switch (kind) {
        case READOUTS: at = readouts_raw_, room = sizeof readouts_raw_; break;
        case KERNELS:
            at = reinterpret_cast<uint8_t *>(kernels_raw_), room = sizeof kernels_raw_;
            break;
        case SCHEDULE_ROWS: at = schedule_raw_, room = sizeof schedule_raw_; break;
        case CODE_PLANE: at = plane_raw_, room = sizeof plane_raw_; break;
        case LEVELS: at = levels_raw_, room = sizeof levels_raw_; break;
        case STATES: at = states_raw_, room = sizeof states_raw_; break;
        default: verdict = refused(MALFORMED, kind); return nullptr;
    }
    verdict = length <= room ? fine : refused(TOO_LARGE, length);
    return verdict.good() ? at : nullptr;
}

Verdict Program::accept(uint8_t kind, uint8_t reg, uint32_t length) {
    switch (kind) {
        case READOUTS: return accept_readouts(length);
        case KERNELS: return accept_kernels(length);
        case SCHEDULE_ROWS: return accept_schedule(length);
        case CODE_PLANE: return accept_plane(reg, length);
        case LEVELS: return accept_levels(length);
        case STATES: return accept_states(length);
        default: return refused(MALFORMED, kind);
    }
}

Verdict Program::accept_readouts(uint32_t length) {
    has_readouts_ = false;
    Reader reader(readouts_raw_, length);
    uint32_t count;
    if (!reader.take_count(count)) {
        return refused(READOUT, reader.at());
    }
    if (count < 1 || count > target::analog_count) {
        return refused(READOUT, count);
    }
    for (uint32_t i = 0; i < count; ++i) {
        const uint8_t *at = reader.take(16);
        if (!at) {
            return refused(READOUT, reader.at());
        }
        readout_[i] = {at[0], get_double(at + 8)};
    }
    if (!reader.ended()) {
        return refused(READOUT, reader.at());
    }
    for (uint32_t i = 0; i < count; ++i) {
        const bool scaled = readout_[i].gain != 1 && !limits::gains;
        if (readout_[i].reg >= target::analog_count || !finite(readout_[i].gain) || scaled) {
            return refused(READOUT, readout_[i].reg);
        }
    }
    readout_count_ = count;
    has_readouts_ = true;
    return fine;
}

Verdict Program::accept_kernels(uint32_t length) {
    has_kernels_ = has_schedule_ = false;
    Reader reader(reinterpret_cast<const uint8_t *>(kernels_raw_), length);
    uint32_t count;
    if (!reader.take_count(count)) {
        return refused(MALFORMED, reader.at());
    }
    if (count > limits::most_kernels) {
        return refused(TOO_LARGE, count);
    }
    uint64_t total = 0;
    first_word_[0] = 0;
    for (uint32_t i = 0; i < count; ++i) {
        uint32_t words;
        if (!reader.take_count(words)) {
            return refused(MALFORMED, reader.at());
        }
        total += words;
        first_word_[i + 1] = uint32_t(total);
    }
    if (total > target::store_words) {
        return refused(TOO_LARGE, uint32_t(total));
    }
    uint32_t number = 0;
    for (uint32_t i = 0; i < count; ++i) {
        Meaning before = {true, NOTHING, WHOLE, 0, false};
        bool split = false;
        for (; number < first_word_[i + 1]; ++number) {
            const uint8_t *at = reader.take(20);
            if (!at) {
                return refused(MALFORMED, reader.at());
            }
            Word word;
            for (int part = 0; part < 5; ++part) {
                word.part[part] = get32(at + 4 * part);
            }
            const Meaning now = meaning_of(word);
            if (!now.legal) {
                return refused(WORD, number);
            }
            const bool second = now.phase == SECOND_HALF;
            const bool awaited = before.phase == FIRST_HALF;
            split = split || second != awaited || (second && now.pair != before.pair);
            before = now;
        }
        if (split || before.phase == FIRST_HALF) {
            return refused(WORD, number);
        }
    }
    if (!reader.ended()) {
        return refused(MALFORMED, reader.at());
    }
    kernel_count_ = count;
    has_kernels_ = true;
    time_kernels();
    return fine;
}

void Program::time_kernels() {
    const uint32_t *words = kernels_raw_ + 1 + kernel_count_;
    for (uint32_t k = 0; k < kernel_count_; ++k) {
        double us = target::launch_us;
        for (uint32_t n = first_word_[k]; n < first_word_[k + 1]; ++n) {
            us += (words[5 * n] >> 19 & 7) == 0 ? target::analog_word_us : target::digital_word_us;
        }
        busy_us_[k] = float(us);
    }
}

Verdict Program::accept_schedule(uint32_t length) {
    has_schedule_ = false;
    if (!has_kernels_) {
        return refused(SCHEDULE, 0);
    }
    Reader reader(schedule_raw_, length);
    uint32_t slots, runs, rows;
    if (!reader.take_count(slots)) {
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
    uint64_t total = 0;
    bool void_run = false, odd_length = false;
    for (uint32_t i = 0; i < runs; ++i) {
        const uint8_t *at = reader.take(12);
        if (!at) {
            return refused(SCHEDULE, reader.at());
        }
        const double us = get_double(at + 4);
        total += get32(at);
        void_run = void_run || get32(at) == 0;
        odd_length = odd_length || !(us > 0 && us <= longest_slot_us);
    }
    if (total != slots || void_run) {
        return refused(SCHEDULE, 2);
    }
    if (odd_length) {
        return refused(SCHEDULE, 3);
    }
    if (!reader.take_count(rows)) {
        return refused(SCHEDULE, reader.at());
    }
    if (rows > limits::most_rows) {
        return refused(TOO_LARGE, rows);
    }
    const uint8_t *first = reader.take(8 * rows);
    if (!first || !reader.ended()) {
        return refused(SCHEDULE, reader.at());
    }
    uint64_t boundary = 0, launches = 0;
    for (uint32_t i = 0; i < rows; ++i) {
        const uint8_t *at = first + 8 * i;
        const uint32_t times = get16(at + 6);
        boundary += uint64_t(get32(at)) * times;
        launches += times;
        if (times == 0 || boundary > slots || launches > most_launches ||
            get16(at + 4) >= kernel_count_) {
            return refused(SCHEDULE, 4);
        }
    }
    if (level_count_ > 0 && level_count_ != rows) {
        return refused(SCHEDULE, 5);
    }
    slots_ = slots;
    run_count_ = runs;
    row_count_ = rows;
    has_schedule_ = true;
    return fine;
}

// A level for each row of the schedule that is to come.
Verdict Program::accept_levels(uint32_t length) {
    has_schedule_ = false;
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

Verdict Program::accept_states(uint32_t length) {
    state_count_ = 0;
    Reader reader(states_raw_, length);
    uint32_t count;
    if (!reader.take_count(count)) {
        return refused(READOUT, reader.at());
    }
    if (count > target::digital_count) {
        return refused(READOUT, count);
    }
    const uint8_t *first = reader.take(count);
    if (!first || !reader.ended()) {
        return refused(READOUT, reader.at());
    }
    for (uint32_t i = 0; i < count; ++i) {
        if (first[i] >= target::digital_count) {
            return refused(READOUT, first[i]);
        }
    }
    state_count_ = count;
    return fine;
}

Verdict Program::accept_plane(uint8_t reg, uint32_t length) {
    constexpr uint32_t odd = uint32_t(target::rows) * target::cols % 8;
    if (reg >= target::digital_count || held_[reg] || length != plane_bytes ||
        (odd != 0 && plane_raw_[plane_bytes - 1] >> odd != 0)) {
        return refused(PLANE, reg);
    }
    if (int(reg) == target::masked_register) {
        // It takes a write only where the mask is 1, so the mask's own code has to come later.
        if (held_[target::mask_register]) {
            return refused(PLANE, reg);
        }
        board_.run(target::set_mask, 1);
    }
    if (!board_.load_plane(reg, plane_raw_, *this)) {
        return refused(HARDWARE, reg);
    }
    held_[reg] = true;
    ++planes_;
    return fine;
}

void Program::refresh() {
    for (uint32_t reg = 0; reg < target::digital_count; ++reg) {
        if (held_[reg]) {
            const auto &words = target::refresh[reg];
            board_.run(words.word, words.count);
        }
    }
}

uint32_t Program::frame_bytes(uint8_t channels) const {
    const uint32_t each = (channels & codes_channel ? 1 : 0) + (channels & exposure_channel ? 8 : 0);
    const uint32_t states = channels & states_channel ? state_count_ * plane_bytes : 0;
    return readout_count_ * each * target::rows * target::cols + states;
}

uint32_t Program::estimate_ms() const {
    double us = readout_count_ * target::readout_us;
    for (uint32_t i = 0; i < run_count_; ++i) {
        const uint8_t *at = schedule_raw_ + 8 + 12 * i;
        us += get32(at) * get_double(at + 4);
    }
    return us < 4e12 ? uint32_t(us / 1000) + 1 : 0xffffffffu;
}

// Time from the first word to the end of the reset that begins the exposure.
double Program::setup_us() const {
    const uint8_t *row = schedule_raw_ + 12 + 12 * run_count_;
    const uint32_t *words = kernels_raw_ + 1 + kernel_count_;
    double elapsed = 0, setup = 0;
    for (uint32_t i = 0; i < row_count_ && get32(row) == 0; ++i, row += 8) {
        const uint32_t kernel = get16(row + 4);
        for (uint32_t times = get16(row + 6); times > 0; --times) {
            double us = elapsed + target::launch_us;
            for (uint32_t n = first_word_[kernel]; n < first_word_[kernel + 1]; ++n) {
                Word word;
                for (int part = 0; part < 5; ++part) {
                    word.part[part] = words[5 * n + part];
                }
                const Meaning what = meaning_of(word);
                us += what.analog ? target::analog_word_us : target::digital_word_us;
                setup = what.effect == RESET_PIX ? us : setup;
            }
            elapsed += double(busy_us_[kernel]);
        }
    }
    return setup;
}

void Program::launch(uint32_t kernel) {
    const uint32_t first = first_word_[kernel];
    const uint32_t *words = kernels_raw_ + 1 + kernel_count_ + 5 * first;
    board_.run(reinterpret_cast<const uint32_t(*)[5]>(words), first_word_[kernel + 1] - first);
}

void Program::expose(uint8_t channels, uint8_t *frame) {
    // Boundaries in time, as the runs of slots give them; words take time out of the slots.
    uint32_t run = 0, left = get32(schedule_raw_ + 8), at = 0;
    double boundary_us = 0, now_us = -setup_us();
    const auto advance = [&](uint32_t slots) {
        at += slots;
        while (slots > 0) {
            const uint8_t *entry = schedule_raw_ + 8 + 12 * run;
            const uint32_t some = slots < left ? slots : left;
            boundary_us += some * get_double(entry + 4);
            slots -= some;
            left -= some;
            if (left == 0 && ++run < run_count_) {
                left = get32(schedule_raw_ + 8 + 12 * run);
            }
        }
    };
    const auto pass = [&](uint32_t slots) {
        advance(slots);
        const double wait_us = boundary_us > now_us ? boundary_us - now_us : 0;
        board_.pass(slots, wait_us);
        now_us += wait_us;
    };
    board_.begin_frame(schedule_raw_ + 8, run_count_);
    const uint8_t *row = schedule_raw_ + 12 + 12 * run_count_;
    int16_t in = as_it_is;
    for (uint32_t i = 0; i < row_count_; ++i, row += 8) {
        const uint32_t slots = get32(row), kernel = get16(row + 4);
        const int16_t level = level_count_ ? int16_t(get16(levels_raw_ + 4 + 2 * i)) : as_it_is;
        for (uint32_t times = get16(row + 6); times > 0; --times) {
            if (slots > 0) {
                pass(slots);
            }
            if (level != as_it_is && level != in) {
                board_.set_in(level);
                in = level;
                now_us += target::in_settle_us;
            }
            launch(kernel);
            now_us += double(busy_us_[kernel]);
        }
    }
    if (at < slots_) {
        pass(slots_ - at);
    }
    const Contents contents = {readout_, readout_count_, states_raw_ + 4, state_count_, channels};
    board_.read_out(contents, frame, frame_bytes(channels));
}

}  // namespace nscc
