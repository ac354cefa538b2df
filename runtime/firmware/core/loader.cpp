#include "loader.hpp"

namespace nscc {

namespace {

constexpr size_t info_fixed = 144;      // bytes of HELLO's reply before its texts

size_t put_text(uint8_t *at, const char *text) {
    size_t length = 0;
    while (text[length] != 0 && length < 60) {
        at[1 + length] = uint8_t(text[length]);
        ++length;
    }
    at[0] = uint8_t(length);
    return 1 + length;
}

}  // namespace

void Loader::start() {
    unpacker_.reset();
    program_.forget();
    state_ = State::EMPTY;
    announced_ = hurries_ = false;
    refusal_ = fine;
    session_ = boot_ = packets_ = 0;
    now_us_ = started_us_ = refreshed_us_ = 0;
    declared_ = object_ = 0;
    position_ = part_ = failures_ = 0;
    frame_ = Frame{};
    forget_loading();
    reads_ = waiting_ = 0;
    send(BOOTED, 0, 0, nullptr, 0);
}

void Loader::receive(const uint8_t *data, size_t count, uint64_t now_us) {
    now_us_ = now_us;
    started_us_ = started_us_ ? started_us_ : now_us;
    Packet packet;
    for (size_t i = 0; i < count; ++i) {
        if (unpacker_.take(data[i], packet)) {
            ++packets_;
            handle(packet);
        }
    }
}

void Loader::glance(const uint8_t *data, size_t count, uint64_t now_us) {
    now_us_ = now_us;
    Packet packet;
    for (size_t i = 0; i < count; ++i) {
        if (unpacker_.take(data[i], packet)) {
            ++packets_;
            if (packet.kind == CANCEL && spoken_to(packet)) {
                handle(packet);
            }
        }
    }
    expose();
}

size_t Loader::poll(uint8_t *out, size_t room, uint64_t now_us) {
    now_us_ = now_us;
    const bool fading = now_us - refreshed_us_ > uint64_t(target::retention_us / 4);
    if (program_.holds_planes() && frame_.stage != Stage::LAUNCHING && fading) {
        refresh();
    }
    expose();
    make_columns();
    while (reads_ > 0 && waiting_ < room && waiting_ + most_wire <= sizeof out_ && send_piece()) {
    }
    const size_t count = waiting_ < room ? waiting_ : room;
    copy(out, out_, count);
    waiting_ -= count;
    for (size_t i = 0; i < waiting_; ++i) {
        out_[i] = out_[i + count];
    }
    return count;
}

void Loader::refresh() {
    program_.refresh();
    refreshed_us_ = now_us_;
}

void Loader::handle(const Packet &packet) {
    Verdict verdict = refused(NO_SESSION);
    if (spoken_to(packet)) {
        verdict = answer(packet);
    }
    if (!verdict.good()) {
        uint8_t body[8] = {packet.kind, verdict.fault, 0, 0};
        put32(body + 4, verdict.detail);
        send(FAILED, packet.sequence, packet.session, body, sizeof body);
    }
}

Verdict Loader::answer(const Packet &packet) {
    switch (packet.kind) {
        case HELLO: return hello(packet);
        case STATUS: return status(packet);
        case BEGIN: return begin(packet);
        case DECLARE: return declare(packet);
        case DATA: return data(packet);
        case FINISH: return finish(packet);
        case CAPTURE:
        case CAPTURE_WITH: return capture(packet);
        case LOAD: return load(packet);
        case READ: return read(packet);
        case CANCEL: return cancel(packet);
        default: return refused(UNKNOWN);
    }
}

void Loader::reply(const Packet &packet, const uint8_t *body, size_t size) {
    send(packet.kind | reply_bit, packet.sequence, packet.session, body, size);
}

// A packet that finds no room is not sent: the host asks again.
void Loader::send(uint8_t kind, uint16_t sequence, uint32_t session, const uint8_t *body,
                  size_t size) {
    if (waiting_ + most_wire <= sizeof out_) {
        Packer packer(out_ + waiting_, kind, sequence, session);
        packer.add(body, size);
        waiting_ += packer.finish();
    }
}

Verdict Loader::hello(const Packet &packet) {
    if (packet.size != 4 || packet.session == 0) {
        return refused(MALFORMED);
    }
    if (packet.body[0] > protocol_version || packet.body[1] < protocol_version) {
        return refused(VERSION, protocol_version);
    }
    session_ = packet.session;
    boot_ = boot_ ? boot_ : packet.session;
    reads_ = 0;
    uint8_t body[info_fixed + 2 * 61] = {protocol_version, shown_state()};
    put16(body + 2, most_data);
    const uint32_t numbers[] = {
        limits::window, boot_,
        uint32_t(limits::exact ? 1 : 0) | uint32_t(limits::gains ? 2 : 0) | 60u,
        target::store_words, limits::most_kernels, limits::most_rows, limits::most_runs,
        limits::most_frame, hold, longest_us / 1000,
    };
    uint8_t *at = body + 4;
    for (uint32_t number : numbers) {
        put32(at, number);
        at += 4;
    }
    put16(at, target::rows);
    put16(at + 2, target::cols);
    copy(at + 4, target::digest, 32);
    if (announced_ && state_ != State::REFUSED) {
        copy(at + 36, begin_ + begin_program, 32);
        copy(at + 68, begin_ + begin_label, 32);
    }
    at += 100;
    at += put_text(at, target::name);
    at += put_text(at, limits::firmware);
    reply(packet, body, size_t(at - body));
    return fine;
}

Verdict Loader::status(const Packet &packet) {
    if (packet.size != 0) {
        return refused(MALFORMED);
    }
    uint8_t body[28] = {shown_state()};
    put32(body + 4, boot_);
    put64(body + 8, now_us_ - started_us_);
    put32(body + 16, announced_ ? position_ : 0);
    put32(body + 20, packets_);
    put32(body + 24, unpacker_.damaged());
    reply(packet, body, sizeof body);
    return fine;
}

Verdict Loader::progress(const Packet &packet) {
    uint8_t body[8] = {shown_state(), uint8_t(failures_ < 255 ? failures_ : 255)};
    put16(body + 2, uint16_t(announced_ ? declared_ : 0));
    put32(body + 4, announced_ ? position_ : 0);
    reply(packet, body, sizeof body);
    return fine;
}

// Back to where a new program or a new frame can begin; what was uploaded stays.
Verdict Loader::cancel(const Packet &packet) {
    if (packet.size != 0) {
        return refused(MALFORMED);
    }
    forget_frame();
    if (state_ == State::REFUSED) {
        state_ = State::EMPTY;
        announced_ = false;
        refusal_ = fine;
    }
    return progress(packet);
}

}  // namespace nscc
