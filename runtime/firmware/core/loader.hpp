// The loader: bytes and the time go in, bytes come out, the board does what they say.
#ifndef NSCC_LOADER_HPP
#define NSCC_LOADER_HPP

#include "packets.hpp"
#include "program.hpp"

namespace nscc {

enum class State : uint8_t { EMPTY, RECEIVING, COMPLETE, READY, EXPOSING, REFUSED };

class Loader {
public:
    explicit Loader(Board &board) : board_(board), program_(board, shared_) { start(); }

    // Forget everything, as after power on, and say so to the host.
    void start();
    void receive(const uint8_t *data, size_t count, uint64_t now_us);
    // Go on with what is being done. How many bytes to send were written to `out`, at most `room`.
    size_t poll(uint8_t *out, size_t room, uint64_t now_us);
    // Whether a frame's next boundary is too near for anything but a look at the line.
    bool hurries() const { return hurries_; }
    // What was seen there: CANCEL is heard, and everything else lost, so that the host asks again.
    // Goes on with the frame.
    void glance(const uint8_t *data, size_t count, uint64_t now_us);
    bool exposing() const {
        return frame_.stage >= Stage::ASKED && frame_.stage <= Stage::READING_OUT;
    }
    // Whether poll has something to do without new bytes.
    bool busy() const { return waiting_ > 0 || reads_ > 0 || exposing(); }

private:
    static constexpr size_t entry_size = 38, most_reads = 8, most_objects = 64;
    // Where the body of BEGIN has what.
    static constexpr size_t begin_size = 104, begin_program = 32, begin_label = 64;
    static constexpr size_t begin_length = 96, begin_objects = 100;

    // Bytes of a frame are made a column at a time, and kept until the host has them. Planes are
    // gone from that memory before frames come.
    static constexpr uint32_t column = target::rows;
    static constexpr uint32_t ring = limits::most_kept / column * column;
    static constexpr uint32_t hold = ring - column;
    static_assert(ring >= 2 * column, "a column is kept while the next one is made");
    static constexpr uint32_t shared_bytes =
        ring > Program::plane_bytes ? ring : Program::plane_bytes;

    enum class Stage : uint8_t { NONE, ASKED, LAUNCHING, READING_OUT, READY, FAILED };
    struct Frame {
        Stage stage;
        Fault fault;
        uint64_t number;
        uint8_t channels;
        uint32_t length, made, released;    // bytes: of all, made so far, needed no more
        uint64_t started_us;
        uint32_t readout_ticks;
        FrameSum sum;
    };
    struct Reading {
        uint16_t sequence;
        uint64_t number;
        uint32_t offset, length, kept;
        uint16_t chunk;
    };

    void refresh();
    bool spoken_to(const Packet &packet) const {
        return packet.kind == HELLO || (session_ != 0 && packet.session == session_);
    }
    void handle(const Packet &packet);
    Verdict answer(const Packet &packet);
    Verdict hello(const Packet &packet);
    Verdict status(const Packet &packet);
    Verdict begin(const Packet &packet);
    Verdict declare(const Packet &packet);
    Verdict data(const Packet &packet);
    Verdict finish(const Packet &packet);
    Verdict capture(const Packet &packet);
    Verdict read(const Packet &packet);
    Verdict cancel(const Packet &packet);
    Verdict load(const Packet &packet);

    void reply(const Packet &packet, const uint8_t *body, size_t size);
    Verdict progress(const Packet &packet);
    void send(uint8_t kind, uint16_t sequence, uint32_t session, const uint8_t *body, size_t size);
    Verdict declared_all();
    Verdict take(const uint8_t *data, size_t size);
    Verdict commit(bool &again);
    Verdict refuse(Verdict verdict);
    uint8_t shown_state() const { return uint8_t(exposing() ? State::EXPOSING : state_); }
    const uint8_t *entry(size_t number) const { return entries_ + entry_size * number; }
    uint32_t entry_length(size_t number) const { return get32(entry(number) + 2); }
    void forget_frame();
    // Makes room for a frame, or for a plane.
    void forget_loading() { loading_ = loaded_ = 0; }
    void expose();
    void make_columns();
    bool send_piece();
    void end_reading();

    Board &board_;
    Program program_;
    Unpacker unpacker_;
    State state_;
    bool announced_, hurries_;
    Verdict refusal_;
    uint32_t session_, boot_, packets_;
    uint64_t now_us_, started_us_, refreshed_us_;
    uint8_t begin_[begin_size];
    uint8_t entries_[entry_size * most_objects];
    size_t declared_, object_;
    uint32_t position_, part_, failures_;
    uint32_t loading_, loaded_;         // the register of the plane that LOAD brings, its bytes so far
    Sha256 digest_;
    Frame frame_;
    Reading reading_[most_reads];
    size_t reads_, waiting_;
    uint8_t out_[limits::most_out];
    uint8_t shared_[shared_bytes];
};

}  // namespace nscc

#endif
