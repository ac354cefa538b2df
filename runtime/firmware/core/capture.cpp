// The loader's requests about frames: exposed, and sent piece by piece.

#include "loader.hpp"

namespace nscc {

namespace {

constexpr uint16_t smallest_chunk = 16;

}  // namespace

Verdict Loader::capture(const Packet &packet) {
    if (packet.size != 12) {
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
    const uint64_t number = get64(packet.body);
    if (!frame_.there || frame_.number != number) {
        if (exposing_) {
            return refused(BUSY_NOW);
        }
        const uint8_t channels = packet.body[8];
        const uint8_t possible =
            codes_channel | states_channel | (limits::exact ? exposure_channel : 0);
        const uint32_t length = program_.frame_bytes(channels);
        if (length == 0 || (channels & ~possible) != 0) {
            return refused(MALFORMED, channels);
        }
        if (length > limits::most_frame) {
            return refused(TOO_LARGE, length);
        }
        reads_ = 0;
        frame_ = Frame{true, false, false, number, channels, length, now_us_, {}};
        exposing_ = true;
        program_.expose(channels, pixels_);
    }
    if (frame_.broken) {
        return refused(HARDWARE);
    }
    uint8_t body[60] = {};
    put64(body, frame_.number);
    body[8] = frame_.ready;
    body[9] = frame_.channels;
    put16(body + 10, uint16_t(program_.readouts()));
    put32(body + 12, program_.estimate_ms());
    put32(body + 16, frame_.length);
    put64(body + 20, frame_.started_us);
    copy(body + 28, frame_.digest, sizeof frame_.digest);
    reply(packet, body, sizeof body);
    return fine;
}

void Loader::watch_exposure() {
    if (!exposing_) {
        return;
    }
    const Exposing state = board_.exposing();
    if (state == Exposing::BUSY) {
        return;
    }
    exposing_ = false;
    frame_.broken = frame_.there && state == Exposing::BROKEN;
    if (frame_.there && state == Exposing::DONE) {
        frame_.ready = true;
        Sha256 sum;
        sum.add(pixels_, frame_.length);
        sum.finish(frame_.digest);
    }
}

Verdict Loader::read(const Packet &packet) {
    if (packet.size != 20) {
        return refused(MALFORMED);
    }
    const Reading wanted = {packet.sequence, get64(packet.body), get32(packet.body + 8),
                            get32(packet.body + 12), get16(packet.body + 16)};
    if (!frame_.there || !frame_.ready || frame_.number != wanted.number) {
        return refused(NO_FRAME);
    }
    if (wanted.length == 0 || wanted.offset > frame_.length ||
        wanted.length > frame_.length - wanted.offset || wanted.chunk < smallest_chunk ||
        wanted.chunk > most_data) {
        return refused(MALFORMED);
    }
    if (reads_ == most_reads) {
        return refused(BUSY_NOW);
    }
    reading_[reads_++] = wanted;
    return fine;
}

void Loader::send_piece() {
    Reading &first = reading_[0];
    const uint32_t size = first.length < first.chunk ? first.length : first.chunk;
    uint8_t body[12 + most_data];
    put64(body, first.number);
    put32(body + 8, first.offset);
    copy(body + 12, pixels_ + first.offset, size);
    send(READ | reply_bit, first.sequence, session_, body, 12 + size);
    first.offset += size;
    first.length -= size;
    if (first.length == 0) {
        --reads_;
        for (size_t i = 0; i < reads_; ++i) {
            reading_[i] = reading_[i + 1];
        }
    }
}

}  // namespace nscc
