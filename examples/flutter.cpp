// flutter.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of the
// compiled program, each launched kernel word for word as it was proved.
//
// class      c: every shutter is one bump of 4 slots, in all codes that the fields allow
// slots      64 of 250 us, 16000 us in all
// lowering   edges; encoding: shutter number in Gray code, both polarities
// digital    R0 scratch; R1 shutter number, Gray bit 0; R2 shutter number, Gray bit 0, inverted; R3
//            shutter number, Gray bit 1; R4 shutter number, Gray bit 1, inverted; R5 shutter
//            number, Gray bit 2; R6 shutter number, Gray bit 2, inverted; R7 shutter number, Gray
//            bit 3; R8 shutter number, Gray bit 3, inverted
// analog     A exposure of frame; NEWS scratch of analog words
// words      118 stored in 17 kernels, 118 a frame; 49 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 16002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    exposures as they are, in the upper half of a symmetric converter's codes, 235.294 e
//            each
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 6bb4bf2444851c44790e370edfcfe00111193a663890ff0d07ee1e7bdfd13c11

#include <scamp5.hpp>

#include <cstdint>

using namespace SCAMP5_PE;

#ifdef __LPC43XX__
#define SLOW_CLOCK allow_highspeed(false);      // analog words do not keep up with the fast one
#else
#define SLOW_CLOCK
#endif

namespace {

// 10 words, 2.8 us; launched at boundary 0
// writes A: flutter.nsl:10: open when start <= n < start + len
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix();                           // rpix; rpix; nop
        NOR(R0, R1, R3, R5, R8);            // NOR R0, R1, R3, R5, R8
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 4
// writes A: flutter.nsl:10: open when start <= n < start + len
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R2, R3, R5, R8);            // NOR R0, R2, R3, R5, R8
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 8
// writes A: flutter.nsl:10: open when start <= n < start + len
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R2, R4, R5, R8);            // NOR R0, R2, R4, R5, R8
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 12
// writes A: flutter.nsl:10: open when start <= n < start + len
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R1, R4, R5, R8);            // NOR R0, R1, R4, R5, R8
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 16
// writes A: flutter.nsl:10: open when start <= n < start + len
void k4() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R1, R4, R6, R8);            // NOR R0, R1, R4, R6, R8
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 20
// writes A: flutter.nsl:10: open when start <= n < start + len
void k5() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R2, R4, R6, R8);            // NOR R0, R2, R4, R6, R8
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 24
// writes A: flutter.nsl:10: open when start <= n < start + len
void k6() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R2, R3, R6, R8);            // NOR R0, R2, R3, R6, R8
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 28
// writes A: flutter.nsl:10: open when start <= n < start + len
void k7() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R1, R3, R6, R8);            // NOR R0, R1, R3, R6, R8
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 32
// writes A: flutter.nsl:10: open when start <= n < start + len
void k8() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R1, R3, R6, R7);            // NOR R0, R1, R3, R6, R7
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 36
// writes A: flutter.nsl:10: open when start <= n < start + len
void k9() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R2, R3, R6, R7);            // NOR R0, R2, R3, R6, R7
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 40
// writes A: flutter.nsl:10: open when start <= n < start + len
void k10() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R2, R4, R6, R7);            // NOR R0, R2, R4, R6, R7
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 44
// writes A: flutter.nsl:10: open when start <= n < start + len
void k11() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R1, R4, R6, R7);            // NOR R0, R1, R4, R6, R7
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 48
// writes A: flutter.nsl:10: open when start <= n < start + len
void k12() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R1, R4, R5, R7);            // NOR R0, R1, R4, R5, R7
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 52
// writes A: flutter.nsl:10: open when start <= n < start + len
void k13() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R2, R4, R5, R7);            // NOR R0, R2, R4, R5, R7
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 56
// writes A: flutter.nsl:10: open when start <= n < start + len
void k14() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R2, R3, R5, R7);            // NOR R0, R2, R3, R5, R7
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 60
// writes A: flutter.nsl:10: open when start <= n < start + len
void k15() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
        NOR(R0, R1, R3, R5, R7);            // NOR R0, R1, R3, R5, R7
        WHERE(R0);                          // WHERE R0
        sub(A, A, PIX);                     // bus NEWS, A; bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 18 words, 3 us; launched at boundary 64
// writes A: flutter.nsl:10: open when start <= n < start + len
void k16() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        add(A, A, PIX);                     // bus NEWS, A, PIX; bus A, NEWS
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

// flutter.nsl:5: frame 64 slots of 250us             # 16 ms in all
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
    {1002, 0, 1, 1},                // boundary 4
    {2002, 0, 2, 1},                // boundary 8
    {3002, 0, 3, 1},                // boundary 12
    {4002, 0, 4, 1},                // boundary 16
    {5002, 0, 5, 1},                // boundary 20
    {6002, 0, 6, 1},                // boundary 24
    {7002, 0, 7, 1},                // boundary 28
    {8002, 0, 8, 1},                // boundary 32
    {9002, 0, 9, 1},                // boundary 36
    {10002, 0, 10, 1},              // boundary 40
    {11002, 0, 11, 1},              // boundary 44
    {12002, 0, 12, 1},              // boundary 48
    {13002, 0, 13, 1},              // boundary 52
    {14002, 0, 14, 1},              // boundary 56
    {15002, 0, 15, 1},              // boundary 60
    {16002, 0, 16, 1},              // boundary 64
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

// flutter.nsl:12: pixels start = len * ((5 * (x % 4) + 12 * (y % 4)) % moments)
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
    {0, 1, 255, 252}, {0, 2, 255, 252},
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
    {0, 0, 255, 252}, {0, 3, 255, 252},
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
    {0, 1, 254, 252}, {0, 2, 254, 252}, {1, 0, 254, 252}, {1, 3, 254, 252},
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
    {0, 0, 254, 252}, {0, 3, 254, 252}, {1, 1, 254, 252}, {1, 2, 254, 252},
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
    {0, 1, 253, 252}, {0, 2, 252, 252}, {1, 0, 252, 253}, {2, 0, 252, 252},
    {2, 3, 253, 252}, {3, 2, 252, 253},
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
    {0, 0, 252, 252}, {0, 3, 253, 252}, {1, 2, 252, 253}, {2, 1, 253, 252},
    {2, 2, 252, 252}, {3, 0, 252, 253},
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
    {0, 2, 252, 253}, {0, 2, 253, 252}, {1, 1, 252, 252}, {2, 0, 252, 253},
    {2, 0, 253, 252}, {3, 3, 252, 252},
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
    {0, 0, 252, 253}, {0, 0, 253, 252}, {1, 3, 252, 252}, {2, 2, 252, 253},
    {2, 2, 253, 252}, {3, 1, 252, 252},
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
        scamp5_kernel_begin();
            all();
        scamp5_kernel_end();
        scamp5_output_image(A, display_0);
    }
}
