#include "program.hpp"

namespace nscc {

#ifdef __BYTE_ORDER__
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "words are run from where they arrive");
#endif

namespace {

// The role of a register in READOUTS, a bit each; what is kept only is not read out.
constexpr uint8_t IS_IMAGE = 1, IS_KEPT = 2;

constexpr uint64_t gain_of_one = uint64_t(1023) << 52;

bool finite(uint64_t bits) { return (bits >> 52 & 0x7ff) != 0x7ff; }

}  // namespace

void Program::forget() {
    has_readouts_ = has_kernels_ = has_schedule_ = false;
    readout_count_ = state_count_ = kernels_.count = held_ = kept_ = 0;
    schedule_.forget();
    reports_.forget();
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
        case SCHEDULE_ROWS: at = schedule_.bytes(), room = Schedule::most_bytes; break;
        case CODE_PLANE: at = plane_raw_, room = plane_bytes; break;
        case LEVELS: at = schedule_.levels(), room = Schedule::levels_bytes; break;
        case STATES: at = states_raw_, room = sizeof states_raw_; break;
        case REPORTS: at = reports_.bytes(), room = Reports::most_bytes; break;
        case PARAMS: at = schedule_.params().bytes(), room = Params::most_bytes; break;
        default: verdict = refused(MALFORMED, kind); return nullptr;
    }
    verdict = length <= room ? fine : refused(TOO_LARGE, length);
    return verdict.good() ? at : nullptr;
}

Verdict Program::accept(uint8_t kind, uint8_t reg, uint32_t length) {
    Verdict verdict = fine;
    switch (kind) {
        case READOUTS: return accept_readouts(length);
        case KERNELS: return accept_kernels(length);
        case SCHEDULE_ROWS:
            has_schedule_ = false;
            verdict = has_kernels_ ? schedule_.accept(length) : refused(SCHEDULE, 0);
            has_schedule_ = verdict.good();
            return verdict;
        case CODE_PLANE: return accept_plane(reg, length);
        case LEVELS:
            has_schedule_ = false;
            return schedule_.accept_levels(length);
        case STATES: return accept_states(length);
        case REPORTS: return accept_reports(length);
        case PARAMS: return has_schedule_ ? schedule_.accept_params(length) : refused(SCHEDULE, 0);
        default: return refused(MALFORMED, kind);
    }
}

Verdict Program::complete() {
    if (!has_readouts_ || !has_kernels_ || !has_schedule_) {
        return refused(NO_PROGRAM);
    }
    return schedule_.check(held_);
}

Verdict Program::accept_readouts(uint32_t length) {
    has_readouts_ = false;
    Reader reader(readouts_raw_, length);
    uint32_t count;
    if (!reader.take_count(count)) {
        return refused(READOUT, reader.at());
    }
    if (count > target::analog_count) {
        return refused(READOUT, count);
    }
    uint32_t converted = 0, kept = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const uint8_t *at = reader.take(16);
        if (!at) {
            return refused(READOUT, reader.at());
        }
        if (at[0] >= target::analog_count || at[1] > (IS_IMAGE | IS_KEPT)) {
            return refused(READOUT, at[0]);
        }
        kept |= at[1] & IS_KEPT ? 1u << at[0] : 0;
        if (at[1] != IS_KEPT) {
            readout_[converted++] = {at[0], (at[1] & IS_IMAGE) != 0, get64(at + 8)};
        }
    }
    if (!reader.ended()) {
        return refused(READOUT, reader.at());
    }
    for (uint32_t i = 0; i < converted; ++i) {
        const bool scaled = readout_[i].gain != gain_of_one && !limits::gains;
        if (!finite(readout_[i].gain) || scaled) {
            return refused(READOUT, readout_[i].reg);
        }
    }
    readout_count_ = converted;
    kept_ = kept;
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
    for (uint32_t k = 0; k < count; ++k) {
        uint32_t words;
        if (!reader.take_count(words)) {
            return refused(MALFORMED, reader.at());
        }
        kernels_.kernel[k] = {uint32_t(total), 0, 0, 0};
        total += words;
    }
    kernels_.kernel[count] = {uint32_t(total), 0, 0, 0};
    if (total > target::store_words) {
        return refused(TOO_LARGE, uint32_t(total));
    }
    kernels_.words = reinterpret_cast<const uint32_t(*)[5]>(kernels_raw_ + 1 + count);
    uint32_t number = 0;
    for (uint32_t k = 0; k < count; ++k) {
        const Verdict verdict = accept_words(reader, k, number);
        if (!verdict.good()) {
            return verdict;
        }
    }
    if (!reader.ended()) {
        return refused(MALFORMED, reader.at());
    }
    kernels_.count = count;
    has_kernels_ = true;
    board_.take_words(kernels_raw_ + 1 + count, uint32_t(total));
    return fine;
}

// The words of a kernel; `number` is that of the word in the store.
Verdict Program::accept_words(Reader &reader, uint32_t k, uint32_t &number) {
    Kernel &kernel = kernels_.kernel[k];
    const uint32_t end = kernels_.kernel[k + 1].first;
    Meaning before = {true, NOTHING, WHOLE, 0, false, 0};
    bool split = false;
    for (; number < end; ++number) {
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
        kernel.analog += now.analog;
        kernel.written |= now.written;
        kernel.to_reset = now.effect == RESET_PIX ? number + 1 - kernel.first : kernel.to_reset;
    }
    return split || before.phase == FIRST_HALF ? refused(WORD, number) : fine;
}

Verdict Program::accept_reports(uint32_t length) {
    uint32_t sent = 0;
    for (uint32_t i = 0; i < state_count_; ++i) {
        sent |= 1u << states_raw_[4 + i];
    }
    return reports_.accept(length, sent);
}

Verdict Program::accept_states(uint32_t length) {
    state_count_ = 0;
    reports_.forget();
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
    if (reg >= target::digital_count || (held_ >> reg & 1) != 0 || length != plane_bytes) {
        return refused(PLANE, reg);
    }
    const Verdict verdict = draw(reg);
    held_ |= verdict.good() ? 1u << reg : 0;
    return verdict;
}

Verdict Program::load(uint8_t reg) {
    return reg < target::digital_count && (held_ >> reg & 1) != 0 ? draw(reg) : refused(PLANE, reg);
}

Verdict Program::draw(uint8_t reg) {
    constexpr uint32_t odd = uint32_t(target::rows) * target::cols % 8;
    constexpr uint32_t mask = target::mask_register < 0 ? 0 : 1u << (target::mask_register & 31);
    if (odd != 0 && plane_raw_[plane_bytes - 1] >> odd != 0) {
        return refused(PLANE, reg);
    }
    if (int(reg) == target::masked_register) {
        // It takes a write only where the mask is 1, so the mask's own code has to come later.
        if ((held_ & mask) != 0) {
            return refused(PLANE, reg);
        }
        board_.run(target::set_mask, 1);
    }
    return board_.load_plane(reg, plane_raw_, *this) ? fine : refused(HARDWARE, reg);
}

void Program::refresh() {
    for (uint32_t reg = 0; reg < target::digital_count; ++reg) {
        if ((held_ >> reg & 1) != 0) {
            const auto &words = target::refresh[reg];
            board_.run(words.word, words.count);
        }
    }
}

uint32_t Program::frame_bytes(uint8_t channels) const {
    return board_bytes(channels) + (channels & reports_channel ? reports_.length() : 0);
}

// The board reads the planes of reports like those of states, behind them.
void Program::read_out(uint8_t channels) {
    uint32_t count = 0;
    for (uint32_t i = 0; (channels & states_channel) != 0 && i < state_count_; ++i) {
        planes_[count++] = states_raw_[4 + i];
    }
    for (uint32_t i = 0; (channels & reports_channel) != 0 && i < reports_.count(); ++i) {
        planes_[count++] = reports_.reg(i);
    }
    reports_at_ = board_bytes(channels);
    reports_.begin(reports_at_);
    const uint8_t read = uint8_t(channels & ~reports_channel) | (count > 0 ? states_channel : 0);
    board_.read_out({readout_, readout_count_, planes_, count, read, kept_});
}

bool Program::convert(uint32_t offset, uint8_t *bytes, uint32_t count) {
    const uint32_t left = offset < reports_at_ ? reports_at_ - offset : 0;
    const uint32_t first = count < left ? count : left;
    return (first == 0 || board_.convert(offset, bytes, first)) &&
           reports_.make(bytes + first, count - first);
}

uint32_t Program::board_bytes(uint8_t channels) const {
    const uint32_t each = (channels & codes_channel ? 1 : 0) + (channels & exposure_channel ? 8 : 0);
    const uint32_t states = channels & states_channel ? state_count_ * plane_bytes : 0;
    return readout_count_ * each * target::rows * target::cols + states;
}

uint32_t Program::estimate_ms() const {
    constexpr uint32_t readout_us =
        uint32_t(target::readout_us < longest_us ? target::readout_us : longest_us);
    return schedule_.length_us() / 1000 + readout_count_ * (readout_us / 1000 + 1) + 1;
}

}  // namespace nscc
