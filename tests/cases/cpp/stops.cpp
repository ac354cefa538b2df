// stops.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of the
// compiled program, each launched kernel word for word as it was proved.
//
// class      b: every shutter is open from slot 0 up to a stop of its own, in all codes that the
//            fields allow
// slots      16 of 125 us, 2000 us in all
// lowering   edges; encoding: event times in groups and places 1 x 20
// digital    R0 scratch; R1 fall time, place, bit 0; R2 fall time, place, bit 1; R3 fall time,
//            place, bit 2; R4 fall time, place, bit 3; R5 fall time, place, bit 4; R6 fall time,
//            place, bit 5
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      84 stored in 17 kernels, 84 a frame; 40 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 2002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    2 x exposure - full well: all codes for 0 to 30000 e, 117.647 e each
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 cd259a6c4288e26103fef310f636ff119a46e34e165ead89360ece9fa9cb243e

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
// writes A: stops.nsl:4: open when n < stop
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix(B);                          // rpix; rpix; nop; bus NEWS, PIX; bus B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 1
// writes A: stops.nsl:4: open when n < stop
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R4, R5, R6);                // NOR R0, R4, R5, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 2
// writes A: stops.nsl:4: open when n < stop
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R3, R5, R6);                // NOR R0, R3, R5, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 3
// writes A: stops.nsl:4: open when n < stop
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R3, R4, R6);                // NOR R0, R3, R4, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 4
// writes A: stops.nsl:4: open when n < stop
void k4() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R3, R4, R5);                // NOR R0, R3, R4, R5
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 5
// writes A: stops.nsl:4: open when n < stop
void k5() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R2, R5, R6);                // NOR R0, R2, R5, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 6
// writes A: stops.nsl:4: open when n < stop
void k6() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R2, R4, R6);                // NOR R0, R2, R4, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 7
// writes A: stops.nsl:4: open when n < stop
void k7() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R2, R4, R5);                // NOR R0, R2, R4, R5
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 8
// writes A: stops.nsl:4: open when n < stop
void k8() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R2, R3, R6);                // NOR R0, R2, R3, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 9
// writes A: stops.nsl:4: open when n < stop
void k9() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R2, R3, R5);                // NOR R0, R2, R3, R5
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 10
// writes A: stops.nsl:4: open when n < stop
void k10() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R2, R3, R4);                // NOR R0, R2, R3, R4
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 11
// writes A: stops.nsl:4: open when n < stop
void k11() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R1, R5, R6);                // NOR R0, R1, R5, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 12
// writes A: stops.nsl:4: open when n < stop
void k12() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R1, R4, R6);                // NOR R0, R1, R4, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 13
// writes A: stops.nsl:4: open when n < stop
void k13() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R1, R4, R5);                // NOR R0, R1, R4, R5
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 14
// writes A: stops.nsl:4: open when n < stop
void k14() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R1, R3, R6);                // NOR R0, R1, R3, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 15
// writes A: stops.nsl:4: open when n < stop
void k15() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R1, R3, R5);                // NOR R0, R1, R3, R5
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 16 words, 2.8 us; launched at boundary 16
// writes A: stops.nsl:4: open when n < stop
void k16() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOR(R0, R1, R3, R4);                // NOR R0, R1, R3, R4
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        REFRESH(R1);                        // REFRESH.read R1; REFRESH.write R1
        REFRESH(R2);                        // REFRESH.read R2; REFRESH.write R2
        REFRESH(R3);                        // REFRESH.read R3; REFRESH.write R3
        REFRESH(R4);                        // REFRESH.read R4; REFRESH.write R4
        REFRESH(R5);                        // REFRESH.read R5; REFRESH.write R5
        REFRESH(R6);                        // REFRESH.read R6; REFRESH.write R6
    scamp5_kernel_end();
}

// stops.nsl:2: frame 16 slots of 125us
void (*const kernels[])() = {
    k0, k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11,
    k12, k13, k14, k15, k16,
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
    const double share = (passed_us - 2) / (2002.0 - 2);
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
    {127, 0, 1, 1},                 // boundary 1
    {252, 0, 2, 1},                 // boundary 2
    {377, 0, 3, 1},                 // boundary 3
    {502, 0, 4, 1},                 // boundary 4
    {627, 0, 5, 1},                 // boundary 5
    {752, 0, 6, 1},                 // boundary 6
    {877, 0, 7, 1},                 // boundary 7
    {1002, 0, 8, 1},                // boundary 8
    {1127, 0, 9, 1},                // boundary 9
    {1252, 0, 10, 1},               // boundary 10
    {1377, 0, 11, 1},               // boundary 11
    {1502, 0, 12, 1},               // boundary 12
    {1627, 0, 13, 1},               // boundary 13
    {1752, 0, 14, 1},               // boundary 14
    {1877, 0, 15, 1},               // boundary 15
    {2002, 0, 16, 1},               // boundary 16
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

// stops.nsl:5: pixels stop = 1 + (5 * (x % 4) + 4 * (y % 4)) % 16
// Digital memory fades when it is not written for a while: all codes are written back after each
// plane, and again and again during what takes long.
void refresh_codes() {
    scamp5_kernel_begin();
        REFRESH(R1);
        REFRESH(R2);
        REFRESH(R3);
        REFRESH(R4);
        REFRESH(R5);
        REFRESH(R6);
    scamp5_kernel_end();
}

// All pixels whose address is (row, col) but for the bits set in the masks.
struct Match {
    uint8_t row, col, row_mask, col_mask;
};

const Match code_r1[] = {
    {0, 2, 253, 253}, {1, 0, 252, 254}, {1, 2, 254, 252}, {2, 0, 252, 253},
    {2, 1, 252, 254}, {2, 1, 253, 252},
};

void load_r1() {
    scamp5_kernel_begin();
        CLR(R1, R0);
    scamp5_kernel_end();
    for (const Match &match : code_r1) {
        scamp5_load_pattern(R0, match.row, match.col, match.row_mask,
                            match.col_mask);
        scamp5_kernel_begin();
            OR(R1, R0);
            CLR(R0);
        scamp5_kernel_end();
    }
}

const Match code_r2[] = {
    {0, 0, 253, 253}, {0, 1, 252, 254}, {0, 1, 254, 252}, {2, 2, 253, 252},
    {3, 0, 252, 254}, {3, 2, 252, 253},
};

void load_r2() {
    scamp5_kernel_begin();
        CLR(R2, R0);
    scamp5_kernel_end();
    for (const Match &match : code_r2) {
        scamp5_load_pattern(R0, match.row, match.col, match.row_mask,
                            match.col_mask);
        scamp5_kernel_begin();
            OR(R2, R0);
            CLR(R0);
        scamp5_kernel_end();
    }
}

const Match code_r3[] = {
    {0, 1, 252, 254}, {0, 2, 252, 253}, {1, 3, 254, 252}, {3, 0, 252, 253},
};

void load_r3() {
    scamp5_kernel_begin();
        CLR(R3, R0);
    scamp5_kernel_end();
    for (const Match &match : code_r3) {
        scamp5_load_pattern(R0, match.row, match.col, match.row_mask,
                            match.col_mask);
        scamp5_kernel_begin();
            OR(R3, R0);
            CLR(R0);
        scamp5_kernel_end();
    }
}

const Match code_r4[] = {
    {0, 1, 253, 252}, {1, 1, 252, 254}, {2, 0, 252, 254}, {2, 2, 252, 253},
    {2, 2, 253, 252},
};

void load_r4() {
    scamp5_kernel_begin();
        CLR(R4, R0);
    scamp5_kernel_end();
    for (const Match &match : code_r4) {
        scamp5_load_pattern(R0, match.row, match.col, match.row_mask,
                            match.col_mask);
        scamp5_kernel_begin();
            OR(R4, R0);
            CLR(R0);
        scamp5_kernel_end();
    }
}

const Match code_r5[] = {
    {0, 0, 254, 254}, {0, 2, 253, 252}, {2, 0, 252, 253}, {2, 0, 253, 252},
};

void load_r5() {
    scamp5_kernel_begin();
        CLR(R5, R0);
    scamp5_kernel_end();
    for (const Match &match : code_r5) {
        scamp5_load_pattern(R0, match.row, match.col, match.row_mask,
                            match.col_mask);
        scamp5_kernel_begin();
            OR(R5, R0);
            CLR(R0);
        scamp5_kernel_end();
    }
}

const Match code_r6[] = {
    {0, 0, 253, 252}, {1, 0, 252, 254}, {1, 1, 254, 252}, {2, 3, 253, 252},
};

void load_r6() {
    scamp5_kernel_begin();
        CLR(R6, R0);
    scamp5_kernel_end();
    for (const Match &match : code_r6) {
        scamp5_load_pattern(R0, match.row, match.col, match.row_mask,
                            match.col_mask);
        scamp5_kernel_begin();
            OR(R6, R0);
            CLR(R0);
        scamp5_kernel_end();
    }
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
    load_r5();
    refresh_codes();
    load_r6();
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
