// The loader on the SCAMP-5d: its board by the library's public names, and the main loop.

#include <scamp5.hpp>

#include "loader.hpp"
#include "port.hpp"

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
constexpr double longest_wait_us = 4e9;

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

    void begin_frame(const uint8_t *, uint32_t) override {}

    void pass(uint32_t, double wait_us) override { wait(wait_us); }

    void run(const uint32_t (*words)[5], uint32_t count) override {
        if (count > 0) {
            scamp5_kernel(words, count), Run{};
        }
    }

    void set_in(int16_t steps) override {
        scamp5_load_in(int8_t(steps));
        wait(target::in_settle_us);
    }

    void read_out(const Contents &contents, uint8_t *frame, uint32_t) override {
        // Pixels that FLAG leaves out would be left out of readout.
        run(target::flag_all, 1);
        done_ = true;
        if (contents.channels & codes_channel) {
            for (uint32_t i = 0; i < contents.readout_count; ++i, frame += pixels) {
                done_ = port_scan(*analog[contents.readouts[i].reg], frame) && done_;
            }
        }
        if (contents.channels & states_channel) {
            for (uint32_t i = 0; i < contents.state_count; ++i, frame += plane_bytes) {
                done_ = port_scan_bits(*digital[contents.states[i]], frame) && done_;
            }
        }
    }

    Exposing exposing() override { return done_ ? Exposing::DONE : Exposing::BROKEN; }

private:
    static constexpr uint32_t pixels = uint32_t(target::rows) * target::cols;
    static constexpr uint32_t plane_bytes = (pixels + 7) / 8;

    static void wait(double wait_us) {
        while (wait_us > longest_wait_us) {
            vs_wait(uint32_t(longest_wait_us));
            wait_us -= longest_wait_us;
        }
        const uint32_t whole = uint32_t(wait_us);
        const uint32_t rounded_up = whole + (double(whole) < wait_us);
        if (rounded_up > 0) {
            vs_wait(rounded_up);
        }
    }

    bool done_ = false;
};

static_assert(sizeof(Loader) <= 120 * 1024, "it has to leave room in the memory");

Chip chip;
Loader loader(chip);

}  // namespace

void serve() {
    uint8_t in[256], out[256];
    size_t waiting = 0, sent = 0;
    while (true) {
        vs_frame_loop_control();
        for (size_t count; (count = port_read(in, sizeof in)) > 0;) {
            loader.receive(in, count, port_micros());
        }
        do {
            if (sent == waiting) {
                waiting = loader.poll(out, sizeof out, port_micros());
                sent = 0;
            }
            const size_t some = port_write(out + sent, waiting - sent);
            sent += some;
        } while (sent == waiting && waiting > 0);
    }
}

}  // namespace nscc

int main() {
    vs_init();
    vs_configure_frame_trigger(VS_FRAME_TRIGGER_CONST_LOOP, 1000);
    nscc::serve();
}
