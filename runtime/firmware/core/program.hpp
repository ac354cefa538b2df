// The objects of an uploaded program: checked in their buffers, and run from there.
#ifndef NSCC_PROGRAM_HPP
#define NSCC_PROGRAM_HPP

#include "reader.hpp"
#include "reports.hpp"
#include "schedule.hpp"

namespace nscc {

enum ObjectKind : uint8_t { READOUTS = 1, KERNELS, SCHEDULE_ROWS, CODE_PLANE, LEVELS, STATES,
                            REPORTS, PARAMS };

class Program : public Refresher {
public:
    static constexpr uint32_t plane_bytes = Reports::plane_bytes;

    // `plane`: plane_bytes for a plane that arrives; free again as soon as it is accepted.
    Program(Board &board, uint8_t *plane)
        : board_(board), schedule_(board, kernels_), reports_(board), plane_raw_(plane) {}

    void forget();
    // Where the bytes of an object go; null where there is no such object, or no room for it.
    uint8_t *room_for(uint8_t kind, uint32_t length, Verdict &verdict);
    // Check an object that is whole, and from then on use it.
    Verdict accept(uint8_t kind, uint8_t reg, uint32_t length);
    // Load another plane in place of one that the program has, from the same buffer.
    Verdict load(uint8_t reg);
    // Check what only all objects together tell.
    Verdict complete();

    Schedule &schedule() { return schedule_; }
    uint32_t readouts() const { return readout_count_; }
    uint32_t frame_bytes(uint8_t channels) const;
    uint32_t estimate_ms() const;
    void read_out(uint8_t channels);
    // The next bytes of a frame that is read out, from `offset` on; false where the board cannot.
    bool convert(uint32_t offset, uint8_t *bytes, uint32_t count);
    bool holds_planes() const { return held_ != 0; }
    void refresh() override;

private:
    static constexpr uint32_t readouts_bytes = 4 + 16 * target::analog_count;
    static constexpr uint32_t kernels_words =
        1 + limits::most_kernels + 5 * target::store_words;
    static constexpr uint32_t states_bytes = 4 + target::digital_count;
    static_assert(target::digital_count <= 32, "registers are bits of a mask");

    Verdict accept_readouts(uint32_t length);
    Verdict accept_kernels(uint32_t length);
    Verdict accept_words(Reader &reader, uint32_t k, uint32_t &number);
    Verdict accept_states(uint32_t length);
    Verdict accept_reports(uint32_t length);
    Verdict accept_plane(uint8_t reg, uint32_t length);
    Verdict draw(uint8_t reg);
    // Bytes of a frame before its reports.
    uint32_t board_bytes(uint8_t channels) const;

    Board &board_;
    bool has_readouts_ = false, has_kernels_ = false, has_schedule_ = false;
    uint32_t readout_count_ = 0, state_count_ = 0;
    uint32_t kept_ = 0;                 // the analog registers that are kept, a bit each
    uint32_t held_ = 0;                 // the registers that hold planes, a bit each
    uint32_t reports_at_ = 0;           // the offset of the reports in the frame that is read out
    uint8_t planes_[2 * target::digital_count]; // what the board reads: states, then reports
    Readout readout_[target::analog_count];
    Kernels kernels_;
    Schedule schedule_;
    Reports reports_;
    uint8_t *plane_raw_;
    uint8_t readouts_raw_[readouts_bytes];
    uint8_t states_raw_[states_bytes];
    uint32_t kernels_raw_[kernels_words];
};

}  // namespace nscc

#endif
