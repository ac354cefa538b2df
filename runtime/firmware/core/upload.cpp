// The loader's requests about a program: announced, declared, received, checked.

#include "loader.hpp"

namespace nscc {

Verdict Loader::begin(const Packet &packet) {
    if (packet.size != begin_size) {
        return refused(MALFORMED);
    }
    const uint32_t objects = get16(packet.body + begin_objects);
    // The last two bytes are free: they do not count.
    if (announced_ && equal(packet.body, begin_, begin_size - 2)) {
        return refusal_.good() ? progress(packet) : refusal_;
    }
    if (exposing()) {
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
    forget_frame();
    forget_loading();
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
    bool again = false;
    return entry_length(0) == 0 ? commit(again) : fine;
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

// Accepts the object that is whole now, and those behind it that have no bytes; `again` where its
// bytes have to come again.
Verdict Loader::commit(bool &again) {
    do {
        const uint8_t *at = entry(object_);
        const uint32_t length = entry_length(object_);
        uint8_t digest[Sha256::size];
        digest_.finish(digest);
        digest_.reset();
        part_ = 0;
        if (!equal(digest, at + 6, Sha256::size)) {
            position_ -= length;
            ++failures_;
            again = true;
            return length > 0 ? fine : refuse(refused(DIGEST));
        }
        const Verdict verdict = program_.accept(at[0], at[1], length);
        if (!verdict.good()) {
            return refuse(verdict);
        }
        refresh();
        ++object_;
    } while (object_ < declared_ && entry_length(object_) == 0);
    if (object_ < declared_) {
        return fine;
    }
    const Verdict whole = program_.complete();
    state_ = State::COMPLETE;
    return whole.good() ? fine : refuse(whole);
}

// Another plane for a register that the program has one for. Its bytes come into the memory of
// frames, and the first of them begin it anew.
Verdict Loader::load(const Packet &packet) {
    constexpr size_t head = 8;
    if (packet.size <= head || packet.size - head > most_data) {
        return refused(MALFORMED);
    }
    if (!announced_ || !refusal_.good() || state_ != State::READY) {
        return refused(NO_PROGRAM);
    }
    if (exposing()) {
        return refused(BUSY_NOW);
    }
    const uint8_t reg = packet.body[0];
    const uint32_t position = get32(packet.body + 4);
    if (position == 0) {
        forget_frame();
        loading_ = reg;
        loaded_ = 0;
    }
    if (reg == loading_ && position == loaded_) {
        const uint32_t size = uint32_t(packet.size - head);
        if (size > Program::plane_bytes - loaded_) {
            return refused(PLANE, reg);
        }
        copy(shared_ + loaded_, packet.body + head, size);
        loaded_ += size;
        if (loaded_ == Program::plane_bytes) {
            const Verdict verdict = program_.load(reg);
            if (!verdict.good()) {
                forget_loading();
                return verdict;
            }
            refresh();
        }
    }
    uint8_t body[4];
    put32(body, reg == loading_ ? loaded_ : 0);
    reply(packet, body, sizeof body);
    return fine;
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

}  // namespace nscc
