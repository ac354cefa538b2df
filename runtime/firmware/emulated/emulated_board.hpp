// A chip that is emulated in another process, which is told what the loader does with it.
#ifndef NSCC_EMULATED_BOARD_HPP
#define NSCC_EMULATED_BOARD_HPP

#include "board.hpp"
#include "target.hpp"

namespace nscc {

// All but the clock, and how the bytes of a frame come here.
class EmulatedBoard : public Board {
public:
    void forget() override;
    bool load_plane(uint8_t reg, const uint8_t *bits, Refresher &others) override;
    void take_words(const uint32_t *words, uint32_t count) override;
    void take_slots(const uint8_t *runs, uint32_t count) override;
    void begin_frame() override;
    void pass(uint32_t slots) override;
    void run(const uint32_t (*words)[5], uint32_t count) override;
    void set_in(int16_t steps) override;
    void read_out(const Contents &contents) override;
    Exposing exposing() override { return state_; }

    // The emulator's answer to a job; one to a job before the last is of no interest.
    void answered(uint32_t job, bool there);

protected:
    ~EmulatedBoard() = default;

    uint32_t job_ = 0;

private:
    const uint8_t *words_ = nullptr;
    bool recording_ = false;
    Exposing state_ = Exposing::BROKEN;
};

}  // namespace nscc

#endif
