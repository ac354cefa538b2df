#include "emulated_board.hpp"

#include "records.hpp"

namespace nscc {

namespace {

void put_number(uint32_t value) {
    uint8_t bytes[4];
    put32(bytes, value);
    put_bytes(bytes, sizeof bytes);
}

void put_event(uint32_t what, uint32_t count) {
    begin_record(EVENT, 8);
    put_number(what);
    put_number(count);
}

}  // namespace

void EmulatedBoard::forget() {
    begin_record(FORGOTTEN, 0);
    recording_ = false;
}

bool EmulatedBoard::load_plane(uint8_t reg, const uint8_t *bits, Refresher &others) {
    constexpr size_t size = (size_t(target::rows) * target::cols + 7) / 8;
    begin_record(DRAWN, 1 + size);
    put_bytes(&reg, 1);
    put_bytes(bits, size);
    others.refresh();
    return true;
}

void EmulatedBoard::take_words(const uint32_t *words, uint32_t count) {
    words_ = reinterpret_cast<const uint8_t *>(words);
    begin_record(WORDS, 20 * size_t(count));
    put_bytes(words_, 20 * size_t(count));
}

void EmulatedBoard::take_slots(const uint8_t *runs, uint32_t count) {
    begin_record(SLOTS, 12 * size_t(count));
    put_bytes(runs, 12 * size_t(count));
}

void EmulatedBoard::begin_frame() {
    begin_record(BEGUN, 0);
    recording_ = true;
}

void EmulatedBoard::pass(uint32_t slots) { put_event(light_falls, slots); }

void EmulatedBoard::run(const uint32_t (*words)[5], uint32_t count) {
    if (recording_) {                   // else a refresh: what is emulated does not fade
        put_event(uint32_t(reinterpret_cast<const uint8_t *>(words) - words_), count);
    }
}

void EmulatedBoard::set_in(int16_t steps) { put_event(in_is_set, uint32_t(int32_t(steps))); }

void EmulatedBoard::read_out(const Contents &contents) {
    recording_ = false;
    state_ = Exposing::BUSY;
    begin_record(JOB, 20 + 12 * size_t(contents.readout_count) + contents.state_count);
    put_number(++job_);
    put_number(contents.channels);
    put_number(contents.readout_count);
    put_number(contents.state_count);
    put_number(contents.kept);
    for (uint32_t i = 0; i < contents.readout_count; ++i) {
        uint8_t gain[8];
        put64(gain, contents.readouts[i].gain);
        put_number(contents.readouts[i].reg | uint32_t(contents.readouts[i].direct) << 8);
        put_bytes(gain, sizeof gain);
    }
    put_bytes(contents.states, contents.state_count);
}

void EmulatedBoard::answered(uint32_t job, bool there) {
    if (job == job_ && state_ == Exposing::BUSY) {
        state_ = there ? Exposing::DONE : Exposing::BROKEN;
    }
}

}  // namespace nscc
