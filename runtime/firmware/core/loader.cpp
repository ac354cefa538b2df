#include "loader.hpp"

namespace nscc {

namespace {

constexpr Verdict fine = {NO_FAULT, 0};
Verdict refused(Fault fault, uint32_t detail = 0) { return {fault, detail}; }

constexpr uint16_t smallest_chunk = 16;
// Where a message has what: offsets in the bodies of HELLO's reply and of BEGIN.
constexpr size_t info_fixed = 136, begin_size = 104;
constexpr size_t begin_program = 32, begin_label = 64, begin_length = 96, begin_objects = 100;

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
    announced_ = exposing_ = false;
    refusal_ = fine;
    session_ = boot_ = packets_ = 0;
    now_us_ = started_us_ = refreshed_us_ = 0;
    declared_ = object_ = 0;
    position_ = part_ = failures_ = 0;
    frame_ = Frame{};
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

size_t Loader::poll(uint8_t *out, size_t room, uint64_t now_us) {
    now_us_ = now_us;
    watch_exposure();
    const bool fading = now_us - refreshed_us_ > uint64_t(target::retention_us / 4);
    if (program_.holds_planes() && !exposing_ && fading) {
        program_.refresh();
        refreshed_us_ = now_us;
    }
    while (reads_ > 0 && waiting_ < room && waiting_ + most_wire <= sizeof out_) {
        send_piece();
    }
    const size_t count = waiting_ < room ? waiting_ : room;
    copy(out, out_, count);
    waiting_ -= count;
    for (size_t i = 0; i < waiting_; ++i) {
        out_[i] = out_[i + count];
    }
    return count;
}

void Loader::handle(const Packet &packet) {
    Verdict verdict = refused(NO_SESSION);
    if (packet.kind == HELLO || (session_ != 0 && packet.session == session_)) {
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
        case CAPTURE: return capture(packet);
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
        waiting_ += packed(out_ + waiting_, kind, sequence, session, body, size);
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
        uint32_t(limits::exact ? 1 : 0) | uint32_t(limits::gains ? 2 : 0),
        target::store_words, limits::most_kernels, limits::most_rows, limits::most_runs,
        limits::most_frame,
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
    uint8_t body[24] = {shown_state()};
    put32(body + 4, boot_);
    put32(body + 8, uint32_t((now_us_ - started_us_) / 1000));
    put32(body + 12, announced_ ? position_ : 0);
    put32(body + 16, packets_);
    put32(body + 20, unpacker_.damaged());
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

Verdict Loader::begin(const Packet &packet) {
    if (packet.size != begin_size) {
        return refused(MALFORMED);
    }
    const uint32_t objects = get16(packet.body + begin_objects);
    // The last two bytes are free: they do not count.
    if (announced_ && equal(packet.body, begin_, begin_size - 2)) {
        return refusal_.good() ? progress(packet) : refusal_;
    }
    if (exposing_) {
        return refused(BUSY_NOW);
    }
    if (!equal(packet.body, target::digest, 32)) {
        return refused(TARGET);
    }
    if (objects > most_objects) {
        return refused(TOO_LARGE, objects);
    }
    copy(begin_, packet.body, begin_size);
    program_.forget();
    state_ = State::RECEIVING;
    announced_ = true;
    refusal_ = fine;
    frame_ = Frame{};
    reads_ = 0;
    declared_ = object_ = 0;
    position_ = part_ = failures_ = 0;
    digest_.reset();
    return progress(packet);
}

Verdict Loader::declare(const Packet &packet) {
    if (packet.size < 4) {
        return refused(MALFORMED);
    }
    const size_t first = get16(packet.body), count = get16(packet.body + 2);
    if (packet.size != 4 + count * entry_size) {
        return refused(MALFORMED);
    }
    if (!announced_) {
        return refused(NO_PROGRAM);
    }
    if (!refusal_.good()) {
        return refusal_;
    }
    const uint8_t *fresh = packet.body + 4;
    if (first > declared_) {
        return refused(WRONG_STATE, uint32_t(declared_));
    }
    const size_t known = declared_ - first < count ? declared_ - first : count;
    const size_t objects = get16(begin_ + begin_objects);
    // What is known already may be said again, and nothing else.
    if (!equal(fresh, entry(first), known * entry_size) ||
        (count > known && first + count > objects)) {
        return refused(WRONG_STATE, uint32_t(declared_));
    }
    for (size_t i = known; i < count; ++i) {
        const uint8_t *at = fresh + i * entry_size;
        Verdict verdict = fine;
        if (!program_.room_for(at[0], get32(at + 2), verdict)) {
            return verdict;
        }
    }
    copy(entries_ + entry_size * declared_, fresh + known * entry_size,
         (count - known) * entry_size);
    declared_ += count - known;
    if (count > known && declared_ == objects) {
        const Verdict verdict = declared_all();
        if (!verdict.good()) {
            return verdict;
        }
    }
    return progress(packet);
}

// The program's digest is that of what was declared, so each object's digest is the program's.
Verdict Loader::declared_all() {
    static const char tag[] = "nscc-program-1";
    Sha256 sum;
    sum.add(reinterpret_cast<const uint8_t *>(tag), sizeof tag - 1);
    sum.add(begin_, 32);
    sum.add(begin_ + begin_label, 32);
    sum.add(entries_, declared_ * entry_size);
    uint8_t digest[Sha256::size];
    sum.finish(digest);
    uint64_t total = 0;
    for (size_t i = 0; i < declared_; ++i) {
        total += entry_length(i);
    }
    if (!equal(digest, begin_ + begin_program, 32) || total != get32(begin_ + begin_length)) {
        return refuse(refused(DIGEST));
    }
    return commit_empty();
}

Verdict Loader::refuse(Verdict verdict) {
    state_ = State::REFUSED;
    refusal_ = verdict;
    return verdict;
}

Verdict Loader::data(const Packet &packet) {
    if (!announced_) {
        return refused(NO_PROGRAM);
    }
    if (!refusal_.good()) {
        return refusal_;
    }
    if (packet.size < 4 || packet.size - 4 > most_data) {
        return refused(MALFORMED);
    }
    if (declared_ < get16(begin_ + begin_objects)) {
        return refused(WRONG_STATE, uint32_t(declared_));
    }
    if (state_ == State::RECEIVING && get32(packet.body) == position_) {
        const Verdict verdict = take(packet.body + 4, packet.size - 4);
        if (!verdict.good()) {
            return verdict;
        }
    }
    return progress(packet);
}

Verdict Loader::take(const uint8_t *data, size_t size) {
    while (size > 0 && object_ < declared_) {
        const uint32_t left = entry_length(object_) - part_;
        const uint32_t some = size < left ? uint32_t(size) : left;
        Verdict verdict = fine;
        uint8_t *room = program_.room_for(entry(object_)[0], entry_length(object_), verdict);
        if (!room) {
            return refuse(verdict);
        }
        copy(room + part_, data, some);
        digest_.add(data, some);
        part_ += some;
        position_ += some;
        data += some;
        size -= some;
        if (some == left) {
            bool again = false;
            verdict = commit(again);
            if (!verdict.good() || again) {
                return verdict;
            }
        }
    }
    return fine;
}

// Accepts the object that is whole now; `again` where its bytes have to come again.
Verdict Loader::commit(bool &again) {
    const uint8_t *at = entry(object_);
    uint8_t digest[Sha256::size];
    digest_.finish(digest);
    digest_.reset();
    part_ = 0;
    if (!equal(digest, at + 6, Sha256::size)) {
        position_ -= entry_length(object_);
        ++failures_;
        again = true;
        return fine;
    }
    const Verdict verdict = program_.accept(at[0], at[1], entry_length(object_));
    if (!verdict.good()) {
        return refuse(verdict);
    }
    program_.refresh();
    refreshed_us_ = now_us_;
    ++object_;
    if (object_ < declared_) {
        return commit_empty();
    }
    if (!program_.whole()) {
        return refuse(refused(NO_PROGRAM));
    }
    state_ = State::COMPLETE;
    return fine;
}

// Objects without bytes are whole as soon as they are declared.
Verdict Loader::commit_empty() {
    if (object_ == declared_ || entry_length(object_) > 0) {
        return fine;
    }
    bool again = false;
    const Verdict verdict = commit(again);
    return again ? refuse(refused(DIGEST)) : verdict;
}

Verdict Loader::finish(const Packet &packet) {
    if (packet.size != 32) {
        return refused(MALFORMED);
    }
    if (!announced_) {
        return refused(NO_PROGRAM);
    }
    if (!refusal_.good()) {
        return refusal_;
    }
    if (!equal(packet.body, begin_ + begin_program, 32)) {
        return refused(DIGEST);
    }
    if (state_ == State::RECEIVING) {
        return refused(WRONG_STATE, position_);
    }
    state_ = State::READY;
    return progress(packet);
}

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
        const uint8_t possible = codes_channel | (limits::exact ? exposure_channel : 0);
        if (channels == 0 || (channels & ~possible) != 0) {
            return refused(MALFORMED, channels);
        }
        const uint32_t length = program_.frame_bytes(channels);
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

// Back to where a new program or a new frame can begin; what was uploaded stays.
Verdict Loader::cancel(const Packet &packet) {
    if (packet.size != 0) {
        return refused(MALFORMED);
    }
    reads_ = 0;
    frame_ = Frame{};
    if (state_ == State::REFUSED) {
        state_ = State::EMPTY;
        announced_ = false;
        refusal_ = fine;
    }
    return progress(packet);
}

}  // namespace nscc
