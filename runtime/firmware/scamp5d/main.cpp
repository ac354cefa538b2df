// The loader on the SCAMP-5d: its board by the library's public names, and the main loop.

#include <scamp5.hpp>

#include "scan.hpp"
#include "turn.hpp"

namespace nscc {

// Runs a constant table, be scamp5_kernel(table, n) a function that runs it or an object that
// runs when it is called. (In this namespace, for operators are looked up there.)
struct Run {};
template <class Kernel>
auto operator,(Kernel &&kernel, Run) -> decltype(kernel()) {
    return kernel();
}

namespace {

using namespace SCAMP5_PE;

static_assert(target::digital_count == 13 && target::analog_count == 7, "a SCAMP-5d");
static_assert(target::rows <= 256 && target::cols <= 256, "addresses have eight bits");
static_assert(target::in_low >= -128 && target::in_high <= 127, "IN has eight bits");

const areg_t *const analog[] = {&A, &B, &C, &D, &E, &F, &NEWS};
const dreg_t *const digital[] = {&R0, &R1, &R2, &R3, &R4, &R5, &R6, &R7, &R8, &R9, &R10, &R11, &R12};

constexpr int rows_between_refreshes = 16;

class Chip : public Board {
public:
    void forget() override {}

    bool load_plane(uint8_t reg, const uint8_t *bits, Refresher &others) override {
        run(target::clear[reg], 1);
        scamp5_draw_begin(*digital[reg]);
        uint32_t pixel = 0;
        for (int row = 0; row < target::rows; ++row) {
            for (int col = 0; col < target::cols; ++col, ++pixel) {
                if (bits[pixel / 8] >> pixel % 8 & 1) {
                    // Address (0, 0) is the top right pixel.
                    scamp5_draw_pixel(uint8_t(row), uint8_t(target::cols - 1 - col));
                }
            }
            if (row % rows_between_refreshes == rows_between_refreshes - 1) {
                others.refresh();
            }
        }
        scamp5_draw_end();
        return true;
    }

    void take_words(const uint32_t *, uint32_t) override {}
    void take_slots(const uint8_t *, uint32_t) override {}
    void begin_frame() override {}
    void pass(uint32_t) override {}

    uint32_t ticks() override { return uint32_t(port_micros()); }

    int32_t past(uint32_t deadline, uint32_t left) override {
        int32_t late = int32_t(ticks() - deadline);
        if (late < -int32_t(left)) {
            return late;
        }
        while (late < 0) {
            late = int32_t(ticks() - deadline);
        }
        return late;
    }

    void run(const uint32_t (*words)[5], uint32_t count) override {
        if (count > 0) {
            scamp5_kernel(words, count), Run{};
        }
    }

    void set_in(int16_t steps) override {
        constexpr uint32_t settle_us = uint32_t(target::in_settle_us) + 1;
        scamp5_load_in(int8_t(steps));
        const uint32_t begin = ticks();
        while (ticks() - begin <= settle_us) {
        }
    }

    void read_out(const Contents &contents) override {
        contents_ = contents;
        if (target::spreads && (contents.channels & codes_channel) != 0) {
            spread();
        }
    }

    Exposing exposing() override { return Exposing::DONE; }

    bool convert(uint32_t offset, uint8_t *bytes, uint32_t) override {
        const bool has_codes = (contents_.channels & codes_channel) != 0;
        const uint32_t codes = has_codes ? contents_.readout_count * pixels : 0;
        if (offset < codes) {
            // Pixels that FLAG leaves out would be left out of readout.
            run(target::flag_all, 1);
            const Readout &readout = contents_.readouts[offset / pixels];
            const int nothing = readout.direct ? 0 : target::code_of_nothing;
            const bool done = port_scan(*analog[readout.reg], offset % pixels / target::rows, bytes);
            for (uint32_t row = 0; nothing > 0 && row < target::rows; ++row) {
                const int code = bytes[row] - nothing;
                bytes[row] = uint8_t(code > 0 ? code : 0);
            }
            return done;
        }
        const uint32_t at = offset - codes;
        const uint8_t reg = contents_.states[at / plane_bytes];
        return port_scan_bits(*digital[reg], at % plane_bytes / row_bytes, piece_rows, bytes);
    }

private:
    static constexpr uint32_t pixels = uint32_t(target::rows) * target::cols;
    static constexpr uint32_t plane_bytes = (pixels + 7) / 8, row_bytes = target::cols / 8;
    static constexpr uint32_t piece_rows = target::rows / row_bytes;
    static_assert(target::cols % 8 == 0 && target::rows % row_bytes == 0, "pieces are whole rows");

    // Replaces every exposure by 2 x exposure - full well, which uses all codes of a converter that
    // is symmetric around 0. Images are not changed. If all registers are read out, exposures are
    // not changed either, which the host takes into account (nscc/words/readout.py).
    void spread() {
        uint32_t copy = target::analog_count;
        for (uint32_t reg = 0; reg < target::analog_count; ++reg) {
            copy = reg == target::analog_scratch || is_read(reg) ? copy : reg;
        }
        if (copy == target::analog_count) {
            return;
        }
        run(target::flag_all, 1);
        set_in(int16_t(target::spread_level));
        for (uint32_t i = 0; i < contents_.readout_count; ++i) {
            if (!contents_.readouts[i].direct) {
                run(target::spread[contents_.readouts[i].reg * target::analog_count + copy], 3);
            }
        }
    }

    // Whether a register is read out, or kept from frame to frame.
    bool is_read(uint32_t reg) const {
        bool read = (contents_.kept >> reg & 1) != 0;
        for (uint32_t i = 0; i < contents_.readout_count; ++i) {
            read = read || contents_.readouts[i].reg == reg;
        }
        return read;
    }

    Contents contents_ = {};
};

static_assert(limits::ticks_per_us == 1, "the port's clock counts microseconds");

Chip chip;
NSCC_SHARED_RAM Loader loader(chip);

}  // namespace

void serve() {
    static Turns turns(loader);
    while (true) {
        // The library's own loop, which no trigger holds up, takes as long as it takes.
        if (!loader.exposing()) {
            vs_disable_frame_trigger();
            vs_frame_loop_control();
        }
        turns.take();
    }
}

}  // namespace nscc

int main() {
    vs_init();
    nscc::serve();
}
