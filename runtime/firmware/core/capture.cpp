// The loader's requests about frames: exposed, made column by column, and sent piece by piece.

#include "loader.hpp"

namespace nscc {

namespace {

constexpr uint16_t smallest_chunk = 16;

template <size_t count>
void put_all(uint8_t *at, const uint32_t (&values)[count]) {
    for (size_t i = 0; i < count; ++i) {
        put32(at + 4 * i, values[i]);
    }
}

}  // namespace

void Loader::forget_frame() {
    frame_ = Frame{};
    reads_ = 0;
}

Verdict Loader::capture(const Packet &packet) {
    const bool sets = packet.kind == CAPTURE_WITH;
    if (sets ? packet.size < 12 : packet.size != 12) {
        return refused(MALFORMED);
    }
    if (!announced_) {
        return refused(NO_PROGRAM);
    }
    if (!refusal_.good()) {
        return refusal_;
    }
    if (state_ != State::READY) {
        return refused(NO_PROGRAM);
    }
    Params &params = program_.schedule().params();
    if (sets && packet.size != 12 + 4 * params.count()) {
        return refused(MALFORMED, params.count());
    }
    const uint64_t number = get64(packet.body);
    if (frame_.stage == Stage::NONE || frame_.number != number) {
        if (exposing()) {
            return refused(BUSY_NOW);
        }
        const uint8_t channels = packet.body[8];
        const uint8_t possible =
            uint8_t(codes_channel | states_channel | reports_channel |
                    (limits::exact ? exposure_channel : 0));
        const uint32_t length = program_.frame_bytes(channels);
        if (length == 0 || (channels & ~possible) != 0) {
            return refused(MALFORMED, channels);
        }
        if (length > limits::most_frame) {
            return refused(TOO_LARGE, length);
        }
        const Verdict verdict = sets ? params.set(packet.body + 12) : fine;
        if (!verdict.good()) {
            return verdict;
        }
        forget_frame();
        forget_loading();
        frame_.stage = Stage::ASKED;
        frame_.number = number;
        frame_.channels = channels;
        frame_.length = length;
        frame_.started_us = now_us_;
        frame_.sum.reset();
        program_.schedule().forget_frame();
    }
    const Schedule &schedule = program_.schedule();
    if (frame_.stage == Stage::FAILED) {
        return refused(frame_.fault, frame_.fault == LATE ? schedule.late() : 0);
    }
    const bool whole = frame_.stage == Stage::READY && frame_.made == frame_.length;
    uint8_t body[60] = {};
    put64(body, frame_.number);
    body[8] = frame_.stage == Stage::READY;
    body[9] = frame_.channels;
    put16(body + 10, uint16_t(program_.readouts()));
    put64(body + 24, frame_.started_us);
    const uint32_t at_12[] = {program_.estimate_ms(), frame_.length, frame_.released};
    const uint32_t at_32[] = {
        schedule.lasted_ticks() / limits::ticks_per_us,
        frame_.readout_ticks / limits::ticks_per_us,
        schedule.late(),
        schedule.latest_ticks() / limits::ticks_per_us,
        whole,
        whole ? frame_.sum.crc() : 0,
        whole ? frame_.sum.adler() : 0,
    };
    put_all(body + 12, at_12);
    put_all(body + 32, at_32);
    reply(packet, body, sizeof body);
    return fine;
}

// Goes on with an exposure as far as it goes without waiting for long.
void Loader::expose() {
    hurries_ = false;
    // The answer goes first: a host that hears nothing asks again, and that would come meanwhile.
    if (frame_.stage == Stage::ASKED && waiting_ == 0) {
        frame_.stage = Stage::LAUNCHING;
        refresh();
        program_.schedule().begin_frame();
    }
    if (frame_.stage == Stage::LAUNCHING) {
        const Schedule::Now now = program_.schedule().go_on();
        hurries_ = now == Schedule::Now::GLANCE;
        if (now == Schedule::Now::TOO_LATE) {
            frame_.stage = Stage::FAILED;
            frame_.fault = LATE;
        } else if (now == Schedule::Now::ENDED) {
            frame_.stage = Stage::READING_OUT;
            program_.read_out(frame_.channels);
        }
    }
    if (frame_.stage == Stage::READING_OUT) {
        const Exposing state = board_.exposing();
        if (state == Exposing::DONE) {
            frame_.stage = Stage::READY;
        } else if (state == Exposing::BROKEN) {
            frame_.stage = Stage::FAILED;
            frame_.fault = HARDWARE;
        }
    }
}

// Makes bytes of the frame, as many as are kept beside those that the host may still ask for.
void Loader::make_columns() {
    while (frame_.stage == Stage::READY && frame_.made < frame_.length &&
           frame_.made - frame_.released < hold) {
        uint8_t *bytes = shared_ + frame_.made % ring;
        const uint32_t begin = board_.ticks();
        const uint32_t left = frame_.length - frame_.made;
        const uint32_t some = left < column ? left : column;
        const bool there = program_.convert(frame_.made, bytes, some);
        frame_.readout_ticks += board_.ticks() - begin;
        if (!there) {
            frame_.stage = Stage::FAILED;
            frame_.fault = HARDWARE;
            reads_ = 0;
            return;
        }
        frame_.sum.add(bytes, some);
        frame_.made += some;
    }
}

Verdict Loader::read(const Packet &packet) {
    if (packet.size != 24) {
        return refused(MALFORMED);
    }
    const Reading wanted = {packet.sequence, get64(packet.body), get32(packet.body + 8),
                            get32(packet.body + 12), get32(packet.body + 16),
                            get16(packet.body + 20)};
    if (frame_.stage != Stage::READY || frame_.number != wanted.number) {
        return refused(NO_FRAME);
    }
    const uint32_t released = wanted.kept > frame_.released ? wanted.kept : frame_.released;
    if (wanted.length == 0 || wanted.offset > frame_.length ||
        wanted.length > frame_.length - wanted.offset || wanted.chunk < smallest_chunk ||
        wanted.chunk > most_data || wanted.kept > frame_.made || wanted.offset < wanted.kept) {
        return refused(MALFORMED);
    }
    if (wanted.offset < released) {
        return refused(NO_FRAME, released);
    }
    if (wanted.offset + wanted.length - released > hold) {
        return refused(TOO_LARGE, released);
    }
    if (reads_ == most_reads) {
        return refused(BUSY_NOW);
    }
    frame_.released = released;
    reading_[reads_++] = wanted;
    return fine;
}

// Sends the next packet of the READ that came first; false where its bytes are not made yet.
bool Loader::send_piece() {
    Reading &first = reading_[0];
    const uint32_t size = first.length < first.chunk ? first.length : first.chunk;
    if (first.offset < frame_.released) {
        end_reading();                  // what came after it needs these bytes no more
        return true;
    }
    if (first.offset + size > frame_.made) {
        return false;
    }
    uint8_t head[12];
    put64(head, first.number);
    put32(head + 8, first.offset);
    const uint32_t start = first.offset % ring;
    const uint32_t some = size < ring - start ? size : ring - start;
    Packer packer(out_ + waiting_, READ | reply_bit, first.sequence, session_);
    packer.add(head, sizeof head);
    packer.add(shared_ + start, some);
    packer.add(shared_, size - some);
    waiting_ += packer.finish();
    first.offset += size;
    first.length -= size;
    if (first.length == 0) {
        end_reading();
    }
    return true;
}

void Loader::end_reading() {
    --reads_;
    for (size_t i = 0; i < reads_; ++i) {
        reading_[i] = reading_[i + 1];
    }
}

}  // namespace nscc
