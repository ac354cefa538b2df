// hdr_doubling.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of
// the compiled program, each launched kernel word for word as it was proved.
//
// class      b: every shutter is open from slot 0 up to a stop of its own, in all codes that the
//            fields allow
// slots      8 of 125 to 8000 us, 16000 us in all
// lowering   edges; encoding: one register for each predicate
// digital    R1 fall at boundary 1; R2 fall at boundary 2; R3 fall at boundary 3; R4 fall at
//            boundary 4; R5 fall at boundary 5; R6 fall at boundary 6; R7 fall at boundary 7; R8
//            fall at boundary 8
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      48 stored in 9 kernels, 48 a frame; 52 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 16002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    2 x exposure - full well: all codes for 0 to 30000 e, 117.647 e each
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 c82853f61ee56a79430a07ffcbf6afd709ac00698ec2ea1ef6fd8ffa75f26e2b

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
// writes A: hdr_doubling.nsl:9: open when n < stop
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix(B);                          // rpix; rpix; nop; bus NEWS, PIX; bus B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 1
// writes A: hdr_doubling.nsl:9: open when n < stop
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R1);                          // WHERE R1
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 2
// writes A: hdr_doubling.nsl:9: open when n < stop
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R2);                          // WHERE R2
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 3
// writes A: hdr_doubling.nsl:9: open when n < stop
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R3);                          // WHERE R3
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 4
// writes A: hdr_doubling.nsl:9: open when n < stop
void k4() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R4);                          // WHERE R4
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 5
// writes A: hdr_doubling.nsl:9: open when n < stop
void k5() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R5);                          // WHERE R5
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 6
// writes A: hdr_doubling.nsl:9: open when n < stop
void k6() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R6);                          // WHERE R6
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 7
// writes A: hdr_doubling.nsl:9: open when n < stop
void k7() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R7);                          // WHERE R7
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 19 words, 3.1 us; launched at boundary 8
// writes A: hdr_doubling.nsl:9: open when n < stop
void k8() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R8);                          // WHERE R8
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        REFRESH(R1);                        // REFRESH.read R1; REFRESH.write R1
        REFRESH(R2);                        // REFRESH.read R2; REFRESH.write R2
        REFRESH(R3);                        // REFRESH.read R3; REFRESH.write R3
        REFRESH(R4);                        // REFRESH.read R4; REFRESH.write R4
        REFRESH(R5);                        // REFRESH.read R5; REFRESH.write R5
        REFRESH(R6);                        // REFRESH.read R6; REFRESH.write R6
        REFRESH(R7);                        // REFRESH.read R7; REFRESH.write R7
        REFRESH(R8);                        // REFRESH.read R8; REFRESH.write R8
    scamp5_kernel_end();
}

// hdr_doubling.nsl:6: frame slots [125us, 125us, 250us, 500us, 1ms, 2ms, 4ms, 8ms]
void (*const kernels[])() = {
    k0, k1, k2, k3, k4, k5, k6, k7, k8,
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
    const double share = (passed_us - 2) / (16002.0 - 2);
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
    {502, 0, 3, 1},                 // boundary 3
    {1002, 0, 4, 1},                // boundary 4
    {2002, 0, 5, 1},                // boundary 5
    {4002, 0, 6, 1},                // boundary 6
    {8002, 0, 7, 1},                // boundary 7
    {16002, 0, 8, 1},               // boundary 8
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

// hdr_doubling.nsl:11: pixels stop = 1 + (x + 3 * y) % N
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
        REFRESH(R7);
        REFRESH(R8);
    scamp5_kernel_end();
}

// All pixels whose address is (row, col) but for the bits set in the masks.
struct Match {
    uint8_t row, col, row_mask, col_mask;
};

const Match code_r1[] = {
    {0, 7, 248, 248}, {1, 2, 248, 248}, {2, 5, 248, 248}, {3, 0, 248, 248},
    {4, 3, 248, 248}, {5, 6, 248, 248}, {6, 1, 248, 248}, {7, 4, 248, 248},
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
    {0, 6, 248, 248}, {1, 1, 248, 248}, {2, 4, 248, 248}, {3, 7, 248, 248},
    {4, 2, 248, 248}, {5, 5, 248, 248}, {6, 0, 248, 248}, {7, 3, 248, 248},
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
    {0, 5, 248, 248}, {1, 0, 248, 248}, {2, 3, 248, 248}, {3, 6, 248, 248},
    {4, 1, 248, 248}, {5, 4, 248, 248}, {6, 7, 248, 248}, {7, 2, 248, 248},
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
    {0, 4, 248, 248}, {1, 7, 248, 248}, {2, 2, 248, 248}, {3, 5, 248, 248},
    {4, 0, 248, 248}, {5, 3, 248, 248}, {6, 6, 248, 248}, {7, 1, 248, 248},
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
    {0, 3, 248, 248}, {1, 6, 248, 248}, {2, 1, 248, 248}, {3, 4, 248, 248},
    {4, 7, 248, 248}, {5, 2, 248, 248}, {6, 5, 248, 248}, {7, 0, 248, 248},
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
    {0, 2, 248, 248}, {1, 5, 248, 248}, {2, 0, 248, 248}, {3, 3, 248, 248},
    {4, 6, 248, 248}, {5, 1, 248, 248}, {6, 4, 248, 248}, {7, 7, 248, 248},
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

const Match code_r7[] = {
    {0, 1, 248, 248}, {1, 4, 248, 248}, {2, 7, 248, 248}, {3, 2, 248, 248},
    {4, 5, 248, 248}, {5, 0, 248, 248}, {6, 3, 248, 248}, {7, 6, 248, 248},
};

void load_r7() {
    scamp5_kernel_begin();
        CLR(R7, R0);
    scamp5_kernel_end();
    for (const Match &match : code_r7) {
        scamp5_load_pattern(R0, match.row, match.col, match.row_mask,
                            match.col_mask);
        scamp5_kernel_begin();
            OR(R7, R0);
            CLR(R0);
        scamp5_kernel_end();
    }
}

const Match code_r8[] = {
    {0, 0, 248, 248}, {1, 3, 248, 248}, {2, 6, 248, 248}, {3, 1, 248, 248},
    {4, 4, 248, 248}, {5, 7, 248, 248}, {6, 2, 248, 248}, {7, 5, 248, 248},
};

void load_r8() {
    scamp5_kernel_begin();
        CLR(R8, R0);
    scamp5_kernel_end();
    for (const Match &match : code_r8) {
        scamp5_load_pattern(R0, match.row, match.col, match.row_mask,
                            match.col_mask);
        scamp5_kernel_begin();
            OR(R8, R0);
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
    load_r7();
    refresh_codes();
    load_r8();
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
