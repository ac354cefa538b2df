// The objects of an uploaded program: checked in their buffers, and run from there.
#ifndef NSCC_PROGRAM_HPP
#define NSCC_PROGRAM_HPP

#include "board.hpp"
#include "limits.hpp"
#include "target.hpp"

namespace nscc {

enum Fault : uint8_t {
    NO_FAULT = 0,
    NO_SESSION, VERSION, MALFORMED, WRONG_STATE, TARGET, TOO_LARGE, DIGEST, WORD, SCHEDULE,
    PLANE, READOUT, NO_PROGRAM, HARDWARE, NO_FRAME, UNKNOWN, BUSY_NOW,
};

struct Verdict {
    Fault fault;
    uint32_t detail;
    bool good() const { return fault == NO_FAULT; }
};
constexpr Verdict fine = {NO_FAULT, 0};
inline Verdict refused(Fault fault, uint32_t detail = 0) { return {fault, detail}; }

enum ObjectKind : uint8_t { READOUTS = 1, KERNELS, SCHEDULE_ROWS, CODE_PLANE, LEVELS, STATES };

class Program : public Refresher {
public:
    explicit Program(Board &board) : board_(board) {}

    void forget();
    // Where the bytes of an object go; null where there is no such object, or no room for it.
    uint8_t *room_for(uint8_t kind, uint32_t length, Verdict &verdict);
    // Check an object that is whole, and from then on use it.
    Verdict accept(uint8_t kind, uint8_t reg, uint32_t length);
    bool whole() const { return has_readouts_ && has_kernels_ && has_schedule_; }

    uint32_t readouts() const { return readout_count_; }
    uint32_t frame_bytes(uint8_t channels) const;
    uint32_t estimate_ms() const;
    // Run one frame's words, in time, and begin to read it out.
    void expose(uint8_t channels, uint8_t *frame);
    bool holds_planes() const { return planes_ > 0; }
    void refresh() override;

private:
    static constexpr uint32_t readouts_bytes = 4 + 16 * target::analog_count;
    static constexpr uint32_t kernels_words =
        1 + limits::most_kernels + 5 * target::store_words;
    static constexpr uint32_t schedule_bytes =
        12 + 12 * limits::most_runs + 8 * limits::most_rows;
    static constexpr uint32_t levels_bytes = 4 + 2 * limits::most_rows;
    static constexpr uint32_t states_bytes = 4 + target::digital_count;
    static constexpr uint32_t plane_bytes = (uint32_t(target::rows) * target::cols + 7) / 8;

    Verdict accept_readouts(uint32_t length);
    Verdict accept_kernels(uint32_t length);
    Verdict accept_schedule(uint32_t length);
    Verdict accept_levels(uint32_t length);
    Verdict accept_states(uint32_t length);
    Verdict accept_plane(uint8_t reg, uint32_t length);
    void time_kernels();
    double setup_us() const;
    void launch(uint32_t kernel);

    Board &board_;
    bool has_readouts_ = false, has_kernels_ = false, has_schedule_ = false;
    uint32_t readout_count_ = 0, kernel_count_ = 0, slots_ = 0, run_count_ = 0, row_count_ = 0;
    uint32_t planes_ = 0, level_count_ = 0, state_count_ = 0;
    bool held_[target::digital_count] = {};
    Readout readout_[target::analog_count];
    uint32_t first_word_[limits::most_kernels + 1];
    float busy_us_[limits::most_kernels];
    uint8_t readouts_raw_[readouts_bytes];
    uint32_t kernels_raw_[kernels_words];
    uint8_t schedule_raw_[schedule_bytes];
    uint8_t levels_raw_[levels_bytes];
    uint8_t states_raw_[states_bytes];
    uint8_t plane_raw_[plane_bytes];
};

}  // namespace nscc

#endif
