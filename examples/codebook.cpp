// codebook.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of the
// compiled program, each launched kernel word for word as it was proved.
//
// class      codebook: the rule reads `book`, 4 rows of any shape
// slots      32 of 1000 us, 32000 us in all
// lowering   edges; encoding: one register for each shutter
// digital    R1 shutter 0; R2 shutter 1; R3 shutter 2; R4 shutter 3
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      36 stored in 6 kernels, 152 a frame; 16 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 32002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    2 x exposure - full well: all codes for 0 to 30000 e, 117.647 e each
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 29f90a7c00b47883c929d9e1ec592e1399e32267ba0f9ae1a32c6829c32a92c1

#include <scamp5.hpp>

#include <cstdint>

using namespace SCAMP5_PE;

#ifdef __LPC43XX__
#define SLOW_CLOCK allow_highspeed(false);      // analog words do not keep up with the fast one
#else
#define SLOW_CLOCK
#endif

namespace {

// 8 words, 2.6 us; launched at boundary 0
// writes A: codebook.nsl:15: open when book[id]
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix(B);                          // rpix; rpix; nop; bus NEWS, PIX; bus B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 1..29/4
// writes A: codebook.nsl:15: open when book[id]
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R1, R2);                      // WHERE R1, R2
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 2..30/4
// writes A: codebook.nsl:15: open when book[id]
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R3);                          // WHERE R3
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        WHERE(R2);                          // WHERE R2
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 5 words, 1.9 us; launched at boundary 3..31/4
// writes A: codebook.nsl:15: open when book[id]
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        WHERE(R1);                          // WHERE R1
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 4..28/4
// writes A: codebook.nsl:15: open when book[id]
void k4() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R2, R3);                      // WHERE R2, R3
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 11 words, 2.3 us; launched at boundary 32
// writes A: codebook.nsl:15: open when book[id]
void k5() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R1, R4);                      // WHERE R1, R4
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        REFRESH(R1);                        // REFRESH.read R1; REFRESH.write R1
        REFRESH(R2);                        // REFRESH.read R2; REFRESH.write R2
        REFRESH(R3);                        // REFRESH.read R3; REFRESH.write R3
        REFRESH(R4);                        // REFRESH.read R4; REFRESH.write R4
    scamp5_kernel_end();
}

// codebook.nsl:6: frame 32 slots of 1ms
void (*const kernels[])() = {
    k0, k1, k2, k3, k4, k5,
};

#ifdef __LPC43XX__
const uint32_t late_us = 8;         // a launch that comes later: the clock may tick every 7 us
uint32_t late;                      // so many did in this frame

// Waits until so many microseconds have passed since the frame's first word.
void await(const vs_stopwatch &clock, uint32_t us) {
#ifdef REST_US                      // for instance -DREST_US=1000: longer waits save power
    if (int32_t(us - clock.get_usec()) > REST_US) {
        vs_vision_chip_rest();
    }
#endif
    const int32_t left = int32_t(us - clock.get_usec());
    if (left > 32) {
        vs_wait(uint32_t(left - 16));
    }
    while (int32_t(clock.get_usec() - us) < 0) {
    }
    late += int32_t(clock.get_usec() - us) > int32_t(late_us);
}
#else
// In the devkit's simulator light falls when it is told to: the share of the frame that has passed
// since the moment before. Shares are counted from the frame's beginning, so that none gets lost.
double passed_us;
uint32_t last_us;
uint16_t fallen;

void await(const vs_stopwatch &, uint32_t us) {
    passed_us += uint32_t(us - last_us);
    last_us = us;
    const double share = (passed_us - 2) / (32002.0 - 2);
    const uint16_t until = uint16_t(65535 * (share < 1 ? share : 1) + 0.5);
    vs_sim::pix_integrate(uint16_t(until - fallen), 65535);
    fallen = until;
}
#endif

struct Step {
    uint32_t at_us;                 // this long after the frame's first word
    uint32_t every_us;              // and again and again after so long,
    uint16_t kernel;                // this one of `kernels` runs,
    uint16_t times;                 // so many times in all
};

const Step schedule[] = {
    {0, 0, 0, 1},                   // boundary 0
    {1002, 0, 1, 1},                // boundary 1
    {2002, 0, 2, 1},                // boundary 2
    {3002, 0, 3, 1},                // boundary 3
    {4002, 0, 4, 1},                // boundary 4
    {5002, 0, 1, 1},                // boundary 5
    {6002, 0, 2, 1},                // boundary 6
    {7002, 0, 3, 1},                // boundary 7
    {8002, 0, 4, 1},                // boundary 8
    {9002, 0, 1, 1},                // boundary 9
    {10002, 0, 2, 1},               // boundary 10
    {11002, 0, 3, 1},               // boundary 11
    {12002, 0, 4, 1},               // boundary 12
    {13002, 0, 1, 1},               // boundary 13
    {14002, 0, 2, 1},               // boundary 14
    {15002, 0, 3, 1},               // boundary 15
    {16002, 0, 4, 1},               // boundary 16
    {17002, 0, 1, 1},               // boundary 17
    {18002, 0, 2, 1},               // boundary 18
    {19002, 0, 3, 1},               // boundary 19
    {20002, 0, 4, 1},               // boundary 20
    {21002, 0, 1, 1},               // boundary 21
    {22002, 0, 2, 1},               // boundary 22
    {23002, 0, 3, 1},               // boundary 23
    {24002, 0, 4, 1},               // boundary 24
    {25002, 0, 1, 1},               // boundary 25
    {26002, 0, 2, 1},               // boundary 26
    {27002, 0, 3, 1},               // boundary 27
    {28002, 0, 4, 1},               // boundary 28
    {29002, 0, 1, 1},               // boundary 29
    {30002, 0, 2, 1},               // boundary 30
    {31002, 0, 3, 1},               // boundary 31
    {32002, 0, 5, 1},               // boundary 32
};

void expose() {
    vs_stopwatch clock;
    clock.reset();
    uint32_t before = 0;
#ifdef __LPC43XX__
    late = 0;
#else
    passed_us = 0;
    last_us = 0;
    fallen = 0;
#endif
    for (const Step &step : schedule) {
        uint32_t us = step.at_us;
        for (uint16_t i = 0; i < step.times; ++i) {
            // What a boundary launches beside its first kernel follows at once.
            if (us != before) {
                await(clock, us);
                before = us;
            }
            kernels[step.kernel]();
            us += step.every_us;
        }
    }
}

// codebook.nsl:17: pixels id = tile [[0, 1],
// Digital memory fades when it is not written for a while: all codes are written back after each
// plane, and again and again during what takes long.
void refresh_codes() {
    scamp5_kernel_begin();
        REFRESH(R1);
        REFRESH(R2);
        REFRESH(R3);
        REFRESH(R4);
    scamp5_kernel_end();
}

void load_r1() {
    scamp5_kernel_begin();
        CLR(R1);
    scamp5_kernel_end();
    scamp5_load_pattern(R1, 1, 0, 254, 254);
}

void load_r2() {
    scamp5_kernel_begin();
        CLR(R2);
    scamp5_kernel_end();
    scamp5_load_pattern(R2, 0, 0, 254, 254);
}

void load_r3() {
    scamp5_kernel_begin();
        CLR(R3);
    scamp5_kernel_end();
    scamp5_load_pattern(R3, 1, 1, 254, 254);
}

void load_r4() {
    scamp5_kernel_begin();
        CLR(R4);
    scamp5_kernel_end();
    scamp5_load_pattern(R4, 0, 1, 254, 254);
}

void load_codes() {
    load_r1();
    refresh_codes();
    load_r2();
    refresh_codes();
    load_r3();
    refresh_codes();
    load_r4();
    refresh_codes();
}

}  // namespace

int main() {
    vs_init();
    const auto display_0 = vs_gui_add_display("frame", 0, 0, 2);

#ifdef __LPC43XX__
    // A kernel is recorded when it first runs, which takes time: here, where none is lost.
    for (void (*kernel)() : kernels) {
        kernel();
    }
#endif
    load_codes();

    while (true) {
        // No frame waits for the next: codes fade meanwhile.
        vs_disable_frame_trigger();
        vs_frame_loop_control();
        expose();
#ifdef __LPC43XX__
        if (late) {
            vs_post_text("%u launches came late\n", unsigned(late));
        }
#endif
        // Pixels that FLAG leaves out would be left out of readout.
        // A converter that is symmetric around 0 has all of its codes for 2 x exposure - full well.
        scamp5_load_in(-127);
#ifdef __LPC43XX__
        vs_wait(5);
#endif
        scamp5_kernel_begin();
            all();
            bus(F, A, IN);
            bus(NEWS, A, IN);
            bus(A, NEWS, F, IN);
        scamp5_kernel_end();
        scamp5_output_image(A, display_0);
    }
}
