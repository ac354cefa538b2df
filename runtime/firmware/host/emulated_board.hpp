// A chip that is emulated in another process: what the loader does with it is written down word
// for word, and handed over when the frame is read out.
#ifndef NSCC_EMULATED_BOARD_HPP
#define NSCC_EMULATED_BOARD_HPP

#include <vector>

#include "board.hpp"
#include "target.hpp"

namespace nscc {

class EmulatedBoard : public Board {
public:
    void forget() override;
    bool load_plane(uint8_t reg, const uint8_t *bits, Refresher &others) override;
    void begin_frame(const uint8_t *runs, uint32_t count) override;
    void pass(uint32_t slots, double wait_us) override;
    void run(const uint32_t (*words)[5], uint32_t count) override;
    void set_in(int16_t steps) override;
    void read_out(const Contents &contents, uint8_t *frame, uint32_t size) override;
    Exposing exposing() override;

    // What the emulator answered: 1, the frame and what the code registers hold after it, or 0.
    void answered(const std::vector<uint8_t> &data);

private:
    struct Kernel {
        const uint32_t (*words)[5];
        uint32_t count;
    };
    static constexpr size_t plane_bytes = (size_t(target::rows) * target::cols + 7) / 8;

    std::vector<uint8_t> planes_[target::digital_count];
    std::vector<uint8_t> order_;
    bool recording_ = false;
    std::vector<uint8_t> runs_;
    std::vector<Kernel> kernels_;
    std::vector<uint8_t> events_;
    uint32_t event_count_ = 0;
    uint8_t *frame_ = nullptr;
    uint32_t size_ = 0;
    Exposing state_ = Exposing::BROKEN;
};

}  // namespace nscc

#endif
