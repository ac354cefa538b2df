// stops.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of the
// compiled program, each launched kernel word for word as it was proved.
//
// class      b: every shutter is open from slot 0 up to a stop of its own, in all codes that the
//            fields allow
// slots      16 of 125 us, 2000 us in all
// lowering   edges; encoding: event times in digits 4 x 4
// digital    R0 scratch; R1 fall time, digit 1 is not 1; R2 fall time, digit 1 is not 2; R3 fall
//            time, digit 1 is not 3; R4 fall time, digit 0 is not 0; R5 fall time, digit 0 is not
//            1; R6 fall time, digit 0 is not 2; R7 fall time, digit 0 is not 3; R8 fall at boundary
//            13; R9 fall at boundary 14; R10 fall at boundary 15; R11 fall at boundary 16; R12 fall
//            time, digit 1 is not 0
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      93 stored in 17 kernels, 93 a frame; 67 more load the codes and prepare readout
// time       waits fill the slots after the words, at 0.2 us an analog word, 0.1 us a digital one
//            and 1 us a launch; they are whole microseconds, rounded up so that no slot is too
//            short, which makes a frame 9.3 us longer
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 cd259a6c4288e26103fef310f636ff119a46e34e165ead89360ece9fa9cb243e

#include <scamp5.hpp>

#include <cstdint>

using namespace SCAMP5_PE;

namespace {

// 8 words, 2.6 us; launched at boundary 0
// writes A: stops.nsl:4: open when n < stop
void k0() {
    scamp5_kernel_begin();
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix(B);                          // rpix; rpix; nop; bus NEWS, PIX; bus B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 1
// writes A: stops.nsl:4: open when n < stop
void k1() {
    scamp5_kernel_begin();
        NOR(R0, R4, R12);                   // NOR R0, R4, R12
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 2
// writes A: stops.nsl:4: open when n < stop
void k2() {
    scamp5_kernel_begin();
        NOR(R0, R5, R12);                   // NOR R0, R5, R12
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 3
// writes A: stops.nsl:4: open when n < stop
void k3() {
    scamp5_kernel_begin();
        NOR(R0, R6, R12);                   // NOR R0, R6, R12
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 4
// writes A: stops.nsl:4: open when n < stop
void k4() {
    scamp5_kernel_begin();
        NOR(R0, R7, R12);                   // NOR R0, R7, R12
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 5
// writes A: stops.nsl:4: open when n < stop
void k5() {
    scamp5_kernel_begin();
        NOR(R0, R1, R4);                    // NOR R0, R1, R4
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 6
// writes A: stops.nsl:4: open when n < stop
void k6() {
    scamp5_kernel_begin();
        NOR(R0, R1, R5);                    // NOR R0, R1, R5
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 7
// writes A: stops.nsl:4: open when n < stop
void k7() {
    scamp5_kernel_begin();
        NOR(R0, R1, R6);                    // NOR R0, R1, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 8
// writes A: stops.nsl:4: open when n < stop
void k8() {
    scamp5_kernel_begin();
        NOR(R0, R1, R7);                    // NOR R0, R1, R7
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 9
// writes A: stops.nsl:4: open when n < stop
void k9() {
    scamp5_kernel_begin();
        NOR(R0, R2, R4);                    // NOR R0, R2, R4
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 10
// writes A: stops.nsl:4: open when n < stop
void k10() {
    scamp5_kernel_begin();
        NOR(R0, R2, R5);                    // NOR R0, R2, R5
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 11
// writes A: stops.nsl:4: open when n < stop
void k11() {
    scamp5_kernel_begin();
        NOR(R0, R2, R6);                    // NOR R0, R2, R6
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 12
// writes A: stops.nsl:4: open when n < stop
void k12() {
    scamp5_kernel_begin();
        NOR(R0, R2, R7);                    // NOR R0, R2, R7
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 13
// writes A: stops.nsl:4: open when n < stop
void k13() {
    scamp5_kernel_begin();
        WHERE(R8);                          // WHERE R8
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 14
// writes A: stops.nsl:4: open when n < stop
void k14() {
    scamp5_kernel_begin();
        WHERE(R9);                          // WHERE R9
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 15
// writes A: stops.nsl:4: open when n < stop
void k15() {
    scamp5_kernel_begin();
        WHERE(R10);                         // WHERE R10
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 28 words, 4 us; launched at boundary 16
// writes A: stops.nsl:4: open when n < stop
void k16() {
    scamp5_kernel_begin();
        WHERE(R11);                         // WHERE R11
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        SET(R0);                            // SET R0
        REFRESH(R12);                       // REFRESH.read R12; REFRESH.write R12
        REFRESH(R1);                        // REFRESH.read R1; REFRESH.write R1
        REFRESH(R2);                        // REFRESH.read R2; REFRESH.write R2
        REFRESH(R3);                        // REFRESH.read R3; REFRESH.write R3
        REFRESH(R4);                        // REFRESH.read R4; REFRESH.write R4
        REFRESH(R5);                        // REFRESH.read R5; REFRESH.write R5
        REFRESH(R6);                        // REFRESH.read R6; REFRESH.write R6
        REFRESH(R7);                        // REFRESH.read R7; REFRESH.write R7
        REFRESH(R8);                        // REFRESH.read R8; REFRESH.write R8
        REFRESH(R9);                        // REFRESH.read R9; REFRESH.write R9
        REFRESH(R10);                       // REFRESH.read R10; REFRESH.write R10
        REFRESH(R11);                       // REFRESH.read R11; REFRESH.write R11
    scamp5_kernel_end();
}

// stops.nsl:2: frame 16 slots of 125us
void (*const kernels[])() = {
    k0, k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11,
    k12, k13, k14, k15, k16,
};

struct Step {
    uint32_t wait_us;               // for the rest of the slots before
    uint16_t kernel;                // then this one of `kernels` runs,
    uint16_t times;                 // so many times over
};

const Step schedule[] = {
    {0, 0, 1},                      // boundary 0
    {125, 1, 1},                    // boundary 1
    {124, 2, 1},                    // boundary 2
    {124, 3, 1},                    // boundary 3
    {124, 4, 1},                    // boundary 4
    {124, 5, 1},                    // boundary 5
    {124, 6, 1},                    // boundary 6
    {124, 7, 1},                    // boundary 7
    {124, 8, 1},                    // boundary 8
    {124, 9, 1},                    // boundary 9
    {124, 10, 1},                   // boundary 10
    {124, 11, 1},                   // boundary 11
    {124, 12, 1},                   // boundary 12
    {124, 13, 1},                   // boundary 13
    {124, 14, 1},                   // boundary 14
    {124, 15, 1},                   // boundary 15
    {124, 16, 1},                   // boundary 16
};

void expose() {
    for (const Step &step : schedule) {
        for (uint16_t i = 0; i < step.times; ++i) {
            if (step.wait_us) {
                vs_wait(step.wait_us);
            }
            kernels[step.kernel]();
        }
    }
}

// stops.nsl:5: pixels stop = 1 + (5 * (x % 4) + 4 * (y % 4)) % 16
// Digital memory fades when it is not written for a while: all codes are written back after each
// plane, and again and again during what takes long.
void refresh_codes() {
    scamp5_kernel_begin();
        SET(R0);
        REFRESH(R12);
        REFRESH(R1);
        REFRESH(R2);
        REFRESH(R3);
        REFRESH(R4);
        REFRESH(R5);
        REFRESH(R6);
        REFRESH(R7);
        REFRESH(R8);
        REFRESH(R9);
        REFRESH(R10);
        REFRESH(R11);
    scamp5_kernel_end();
}

// All pixels whose address is (row, col) but for the bits set in the masks.
struct Match {
    uint8_t row, col, row_mask, col_mask;
};

const Match code_r12[] = {
    {0, 3, 252, 252}, {1, 0, 252, 252}, {2, 1, 252, 252}, {3, 2, 252, 252},
};

void load_r12() {
    scamp5_kernel_begin();
        SET(R0);
        CLR(R12, R1);
    scamp5_kernel_end();
    for (const Match &match : code_r12) {
        scamp5_load_pattern(R1, match.row, match.col, match.row_mask,
                            match.col_mask);
        scamp5_kernel_begin();
            OR(R12, R1);
            CLR(R1);
        scamp5_kernel_end();
    }
    scamp5_kernel_begin();
        NOT(R12);
    scamp5_kernel_end();
}

const Match code_r1[] = {
    {0, 0, 253, 253}, {0, 1, 254, 254}, {1, 0, 254, 254}, {2, 2, 253, 253},
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
    {0, 1, 252, 252}, {1, 2, 252, 252}, {2, 3, 252, 252}, {3, 0, 252, 252},
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
    scamp5_kernel_begin();
        NOT(R2);
    scamp5_kernel_end();
}

const Match code_r3[] = {
    {0, 1, 254, 254}, {0, 2, 253, 253}, {1, 0, 254, 254}, {2, 0, 253, 253},
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
    {0, 1, 254, 252}, {0, 2, 253, 252}, {1, 0, 254, 254}, {2, 0, 253, 253},
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
    {0, 0, 255, 253}, {0, 1, 255, 254}, {2, 0, 252, 255},
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
    {0, 0, 255, 254}, {0, 2, 255, 253}, {1, 0, 252, 255},
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
    {0, 0, 252, 255}, {0, 1, 255, 254}, {0, 2, 255, 253},
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

void load_r8() {
    scamp5_kernel_begin();
        CLR(R8);
    scamp5_kernel_end();
    scamp5_load_pattern(R8, 3, 3, 252, 252);
}

void load_r9() {
    scamp5_kernel_begin();
        CLR(R9);
    scamp5_kernel_end();
    scamp5_load_pattern(R9, 2, 2, 252, 252);
}

void load_r10() {
    scamp5_kernel_begin();
        CLR(R10);
    scamp5_kernel_end();
    scamp5_load_pattern(R10, 1, 1, 252, 252);
}

void load_r11() {
    scamp5_kernel_begin();
        CLR(R11);
    scamp5_kernel_end();
    scamp5_load_pattern(R11, 0, 0, 252, 252);
}

void load_codes() {
    load_r12();
    refresh_codes();
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
    load_r9();
    refresh_codes();
    load_r10();
    refresh_codes();
    load_r11();
    refresh_codes();
}

}  // namespace

int main() {
    vs_init();
    const auto display_0 = vs_gui_add_display("frame", 0, 0, 2);

    // A kernel is recorded when it first runs, which takes time: here, where none is lost.
    for (void (*kernel)() : kernels) {
        kernel();
    }
    load_codes();

    // Faster than frames can be, so that none waits for the next: codes fade meanwhile.
    vs_configure_frame_trigger(VS_FRAME_TRIGGER_CONST_LOOP, 54);
    while (true) {
        vs_frame_loop_control();
        expose();
        // Pixels that FLAG leaves out would be left out of readout.
        scamp5_kernel_begin();
            all();
        scamp5_kernel_end();
        scamp5_output_image(A, display_0);
    }
}
