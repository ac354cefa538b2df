// class_b.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of the
// compiled program, each launched kernel word for word as it was proved.
//
// class      b: every shutter is open from slot 0 up to a stop of its own, in all codes that the
//            fields allow
// slots      64 of 250 us, 16000 us in all
// lowering   edges; encoding: event times in Gray code
// digital    R0 scratch; R1 fall time, Gray bit 0; R2 fall time, Gray bit 1; R3 fall time, Gray bit
//            2; R4 fall time, Gray bit 3; R5 fall time, Gray bit 4; R6 fall time, Gray bit 5
// analog     C exposure of frame; D reset level of PIX; NEWS scratch of analog words
// words      56 stored in 9 kernels, 392 a frame; 37 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 16002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 1.1 us (digital), a launch 1 us
// readout    exposures as they are, in the upper half of a symmetric converter's codes, 235.294 e
//            each
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 7f6b9b20a6b6ffd98b52f11ee5b6a1ecc8b3132db6e5db7365408a55582482b8

#include <scamp5.hpp>

#include <cstdint>

using namespace SCAMP5_PE;

#ifdef __LPC43XX__
#define SLOW_CLOCK allow_highspeed(false);      // analog words do not keep up with the fast one
#else
#define SLOW_CLOCK
#endif

namespace {

#ifdef __LPC43XX__
// Runs a constant table, be scamp5_kernel(table, n) a function that runs it or an object that runs
// when it is called.
struct Run {};
template <class Kernel>
auto operator,(Kernel &&kernel, Run) -> decltype(kernel()) {
    return kernel();
}
#endif

// 8 words, 2.6 us; launched at boundary 0
// writes C: class_b.nsl:8: open when n < stop
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(C);                             // bus NEWS; bus C, NEWS
        respix(D);                          // rpix; rpix; nop; bus NEWS, PIX; bus D, NEWS
    scamp5_kernel_end();
}

// 4 words, 3.6 us; launched at boundary 1
// writes C: class_b.nsl:8: open when n < stop
#ifdef __LPC43XX__
const uint32_t k1_words[][5] = {
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10181, 0x20000, 0x30000, 0x40000},  // bus NEWS, C, PIX
    {0x08400, 0x10380, 0x20000, 0x30000, 0x40000},  // bus C, NEWS, D
};
void k1() { scamp5_kernel(k1_words, 4), Run(); }
#else
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        OR(R0, R1, R2, R3, R4);             // OR R0, R1, R2, R3, R4
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, C, PIX);                  // bus NEWS, C, PIX
        bus(C, NEWS, D);                    // bus C, NEWS, D
    scamp5_kernel_end();
}
#endif

// 6 words, 5.8 us; launched at boundary 2..62/2
// writes C: class_b.nsl:8: open when n < stop
#ifdef __LPC43XX__
const uint32_t k2_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10181, 0x20000, 0x30000, 0x40000},  // bus NEWS, C, PIX
    {0x08400, 0x10380, 0x20000, 0x30000, 0x40000},  // bus C, NEWS, D
};
void k2() { scamp5_kernel(k2_words, 6), Run(); }
#else
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R1);                            // NOR.read R1; NOR.write R1
        OR(R0, R1, R2, R3, R4);             // OR R0, R1, R2, R3, R4
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, C, PIX);                  // bus NEWS, C, PIX
        bus(C, NEWS, D);                    // bus C, NEWS, D
    scamp5_kernel_end();
}
#endif

// 6 words, 5.8 us; launched at boundary 3..63/4
// writes C: class_b.nsl:8: open when n < stop
#ifdef __LPC43XX__
const uint32_t k3_words[][5] = {
    {0x80000, 0x10000, 0x20002, 0x32400, 0x40000},  // NOR.read R2
    {0x80000, 0x10000, 0x22000, 0x30400, 0x40000},  // NOR.write R2
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10181, 0x20000, 0x30000, 0x40000},  // bus NEWS, C, PIX
    {0x08400, 0x10380, 0x20000, 0x30000, 0x40000},  // bus C, NEWS, D
};
void k3() { scamp5_kernel(k3_words, 6), Run(); }
#else
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R2);                            // NOR.read R2; NOR.write R2
        OR(R0, R1, R2, R3, R4);             // OR R0, R1, R2, R3, R4
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, C, PIX);                  // bus NEWS, C, PIX
        bus(C, NEWS, D);                    // bus C, NEWS, D
    scamp5_kernel_end();
}
#endif

// 6 words, 5.8 us; launched at boundary 5..61/8
// writes C: class_b.nsl:8: open when n < stop
#ifdef __LPC43XX__
const uint32_t k4_words[][5] = {
    {0x80000, 0x10000, 0x20004, 0x32400, 0x40000},  // NOR.read R3
    {0x80000, 0x10000, 0x24000, 0x30400, 0x40000},  // NOR.write R3
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10181, 0x20000, 0x30000, 0x40000},  // bus NEWS, C, PIX
    {0x08400, 0x10380, 0x20000, 0x30000, 0x40000},  // bus C, NEWS, D
};
void k4() { scamp5_kernel(k4_words, 6), Run(); }
#else
void k4() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R3);                            // NOR.read R3; NOR.write R3
        OR(R0, R1, R2, R3, R4);             // OR R0, R1, R2, R3, R4
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, C, PIX);                  // bus NEWS, C, PIX
        bus(C, NEWS, D);                    // bus C, NEWS, D
    scamp5_kernel_end();
}
#endif

// 6 words, 5.8 us; launched at boundary 9..57/16
// writes C: class_b.nsl:8: open when n < stop
#ifdef __LPC43XX__
const uint32_t k5_words[][5] = {
    {0x80000, 0x10000, 0x20008, 0x32400, 0x40000},  // NOR.read R4
    {0x80000, 0x10000, 0x28000, 0x30400, 0x40000},  // NOR.write R4
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10181, 0x20000, 0x30000, 0x40000},  // bus NEWS, C, PIX
    {0x08400, 0x10380, 0x20000, 0x30000, 0x40000},  // bus C, NEWS, D
};
void k5() { scamp5_kernel(k5_words, 6), Run(); }
#else
void k5() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R4);                            // NOR.read R4; NOR.write R4
        OR(R0, R1, R2, R3, R4);             // OR R0, R1, R2, R3, R4
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, C, PIX);                  // bus NEWS, C, PIX
        bus(C, NEWS, D);                    // bus C, NEWS, D
    scamp5_kernel_end();
}
#endif

// 6 words, 5.8 us; launched at boundary 17,49
// writes C: class_b.nsl:8: open when n < stop
#ifdef __LPC43XX__
const uint32_t k6_words[][5] = {
    {0x80000, 0x10000, 0x20010, 0x32400, 0x40000},  // NOR.read R5
    {0x80000, 0x10000, 0x20000, 0x30401, 0x40000},  // NOR.write R5
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10181, 0x20000, 0x30000, 0x40000},  // bus NEWS, C, PIX
    {0x08400, 0x10380, 0x20000, 0x30000, 0x40000},  // bus C, NEWS, D
};
void k6() { scamp5_kernel(k6_words, 6), Run(); }
#else
void k6() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R5);                            // NOR.read R5; NOR.write R5
        OR(R0, R1, R2, R3, R4);             // OR R0, R1, R2, R3, R4
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, C, PIX);                  // bus NEWS, C, PIX
        bus(C, NEWS, D);                    // bus C, NEWS, D
    scamp5_kernel_end();
}
#endif

// 6 words, 5.8 us; launched at boundary 33
// writes C: class_b.nsl:8: open when n < stop
#ifdef __LPC43XX__
const uint32_t k7_words[][5] = {
    {0x80000, 0x10000, 0x20020, 0x32400, 0x40000},  // NOR.read R6
    {0x80000, 0x10000, 0x20000, 0x30402, 0x40000},  // NOR.write R6
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10181, 0x20000, 0x30000, 0x40000},  // bus NEWS, C, PIX
    {0x08400, 0x10380, 0x20000, 0x30000, 0x40000},  // bus C, NEWS, D
};
void k7() { scamp5_kernel(k7_words, 6), Run(); }
#else
void k7() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R6);                            // NOR.read R6; NOR.write R6
        OR(R0, R1, R2, R3, R4);             // OR R0, R1, R2, R3, R4
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, C, PIX);                  // bus NEWS, C, PIX
        bus(C, NEWS, D);                    // bus C, NEWS, D
    scamp5_kernel_end();
}
#endif

// 8 words, 8 us; launched at boundary 64
// writes C: class_b.nsl:8: open when n < stop
#ifdef __LPC43XX__
const uint32_t k8_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10181, 0x20000, 0x30000, 0x40000},  // bus NEWS, C, PIX
    {0x08400, 0x10380, 0x20000, 0x30000, 0x40000},  // bus C, NEWS, D
    {0x80000, 0x10000, 0x20020, 0x32400, 0x40000},  // NOR.read R6
    {0x80000, 0x10000, 0x20000, 0x30402, 0x40000},  // NOR.write R6
};
void k8() { scamp5_kernel(k8_words, 8), Run(); }
#else
void k8() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R1);                            // NOR.read R1; NOR.write R1
        OR(R0, R1, R2, R3, R4);             // OR R0, R1, R2, R3, R4
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, C, PIX);                  // bus NEWS, C, PIX
        bus(C, NEWS, D);                    // bus C, NEWS, D
        NOT(R6);                            // NOR.read R6; NOR.write R6
    scamp5_kernel_end();
}
#endif

// class_b.nsl:5: frame 64 slots of 250us
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
    {252, 0, 1, 1},                 // boundary 1
    {502, 0, 2, 1},                 // boundary 2
    {752, 0, 3, 1},                 // boundary 3
    {1002, 0, 2, 1},                // boundary 4
    {1252, 0, 4, 1},                // boundary 5
    {1502, 0, 2, 1},                // boundary 6
    {1752, 0, 3, 1},                // boundary 7
    {2002, 0, 2, 1},                // boundary 8
    {2252, 0, 5, 1},                // boundary 9
    {2502, 0, 2, 1},                // boundary 10
    {2752, 0, 3, 1},                // boundary 11
    {3002, 0, 2, 1},                // boundary 12
    {3252, 0, 4, 1},                // boundary 13
    {3502, 0, 2, 1},                // boundary 14
    {3752, 0, 3, 1},                // boundary 15
    {4002, 0, 2, 1},                // boundary 16
    {4252, 0, 6, 1},                // boundary 17
    {4502, 0, 2, 1},                // boundary 18
    {4752, 0, 3, 1},                // boundary 19
    {5002, 0, 2, 1},                // boundary 20
    {5252, 0, 4, 1},                // boundary 21
    {5502, 0, 2, 1},                // boundary 22
    {5752, 0, 3, 1},                // boundary 23
    {6002, 0, 2, 1},                // boundary 24
    {6252, 0, 5, 1},                // boundary 25
    {6502, 0, 2, 1},                // boundary 26
    {6752, 0, 3, 1},                // boundary 27
    {7002, 0, 2, 1},                // boundary 28
    {7252, 0, 4, 1},                // boundary 29
    {7502, 0, 2, 1},                // boundary 30
    {7752, 0, 3, 1},                // boundary 31
    {8002, 0, 2, 1},                // boundary 32
    {8252, 0, 7, 1},                // boundary 33
    {8502, 0, 2, 1},                // boundary 34
    {8752, 0, 3, 1},                // boundary 35
    {9002, 0, 2, 1},                // boundary 36
    {9252, 0, 4, 1},                // boundary 37
    {9502, 0, 2, 1},                // boundary 38
    {9752, 0, 3, 1},                // boundary 39
    {10002, 0, 2, 1},               // boundary 40
    {10252, 0, 5, 1},               // boundary 41
    {10502, 0, 2, 1},               // boundary 42
    {10752, 0, 3, 1},               // boundary 43
    {11002, 0, 2, 1},               // boundary 44
    {11252, 0, 4, 1},               // boundary 45
    {11502, 0, 2, 1},               // boundary 46
    {11752, 0, 3, 1},               // boundary 47
    {12002, 0, 2, 1},               // boundary 48
    {12252, 0, 6, 1},               // boundary 49
    {12502, 0, 2, 1},               // boundary 50
    {12752, 0, 3, 1},               // boundary 51
    {13002, 0, 2, 1},               // boundary 52
    {13252, 0, 4, 1},               // boundary 53
    {13502, 0, 2, 1},               // boundary 54
    {13752, 0, 3, 1},               // boundary 55
    {14002, 0, 2, 1},               // boundary 56
    {14252, 0, 5, 1},               // boundary 57
    {14502, 0, 2, 1},               // boundary 58
    {14752, 0, 3, 1},               // boundary 59
    {15002, 0, 2, 1},               // boundary 60
    {15252, 0, 4, 1},               // boundary 61
    {15502, 0, 2, 1},               // boundary 62
    {15752, 0, 3, 1},               // boundary 63
    {16002, 0, 8, 1},               // boundary 64
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

// class_b.nsl:10: pixels stop = 1 + (21 * (x % 8) + 8 * (y % 8)) % N
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
    {0, 0, 255, 248}, {0, 3, 255, 248}, {0, 5, 255, 248}, {0, 6, 255, 248},
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
    {0, 2, 254, 249}, {0, 2, 254, 252}, {0, 5, 254, 248}, {1, 0, 254, 249},
    {1, 0, 254, 252}, {1, 7, 254, 248},
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
    {0, 0, 252, 250}, {0, 2, 252, 249}, {0, 2, 252, 252}, {0, 2, 253, 248},
    {0, 5, 253, 248}, {1, 5, 252, 250}, {2, 1, 253, 248}, {2, 4, 253, 248},
    {2, 7, 252, 248}, {3, 0, 252, 252}, {3, 1, 252, 250}, {3, 4, 252, 250},
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
    {0, 0, 251, 248}, {0, 2, 248, 252}, {0, 3, 251, 248}, {0, 5, 248, 248},
    {0, 6, 251, 248}, {2, 3, 249, 252}, {3, 0, 248, 252}, {3, 1, 248, 250},
    {4, 1, 249, 248}, {4, 1, 250, 248}, {4, 4, 249, 248}, {4, 4, 250, 248},
    {4, 7, 249, 248}, {5, 2, 250, 248}, {5, 5, 250, 248}, {6, 2, 249, 248},
    {6, 5, 249, 248},
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
    {0, 1, 248, 252}, {0, 2, 249, 248}, {0, 2, 250, 248}, {0, 4, 248, 249},
    {0, 5, 249, 248}, {0, 5, 250, 248}, {2, 0, 249, 248}, {2, 3, 249, 248},
    {2, 6, 249, 248}, {4, 0, 249, 248}, {4, 3, 249, 252}, {4, 6, 249, 249},
    {4, 7, 251, 248}, {5, 1, 250, 248}, {5, 4, 250, 248}, {6, 1, 249, 248},
    {6, 4, 249, 248}, {7, 1, 248, 252}, {7, 2, 248, 248},
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
        scamp5_kernel_begin();
            all();
        scamp5_kernel_end();
        scamp5_output_image(C, display_0);
    }
}
