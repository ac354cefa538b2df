// staggered.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of the
// compiled program, each launched kernel word for word as it was proved.
//
// class      general: some shutters open more than once, in all codes that the fields allow
// slots      8 of 2000 us, 16000 us in all
// lowering   edges; encoding: one register for each shutter
// digital    R1 shutter 0; R2 shutter 1; R3 shutter 2; R4 shutter 3; R5 shutter 4; R6 shutter 5; R7
//            shutter 6; R8 shutter 7
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      69 stored in 9 kernels, 69 a frame; 28 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 16002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    2 x exposure - full well: all codes for 0 to 30000 e, 117.647 e each
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 ffa73864f7f18947b3ae73d241eb161f95913eecd9c46853d121da43277a71cc

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
// writes A: staggered.nsl:10: open when (n - phase) % N < len
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix(B);                          // rpix; rpix; nop; bus NEWS, PIX; bus B, NEWS
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 1
// writes A: staggered.nsl:10: open when (n - phase) % N < len
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R5);                          // WHERE R5
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        WHERE(R4);                          // WHERE R4
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 2
// writes A: staggered.nsl:10: open when (n - phase) % N < len
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R6);                          // WHERE R6
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        WHERE(R3);                          // WHERE R3
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 3
// writes A: staggered.nsl:10: open when (n - phase) % N < len
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R7);                          // WHERE R7
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        WHERE(R2);                          // WHERE R2
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 4
// writes A: staggered.nsl:10: open when (n - phase) % N < len
void k4() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R8);                          // WHERE R8
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        WHERE(R1);                          // WHERE R1
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 5
// writes A: staggered.nsl:10: open when (n - phase) % N < len
void k5() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R4);                          // WHERE R4
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        WHERE(R5);                          // WHERE R5
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 6
// writes A: staggered.nsl:10: open when (n - phase) % N < len
void k6() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R3);                          // WHERE R3
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        WHERE(R6);                          // WHERE R6
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 7
// writes A: staggered.nsl:10: open when (n - phase) % N < len
void k7() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R2);                          // WHERE R2
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        WHERE(R7);                          // WHERE R7
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}

// 19 words, 3.1 us; launched at boundary 8
// writes A: staggered.nsl:10: open when (n - phase) % N < len
#ifdef __LPC43XX__
const uint32_t k8_words[][5] = {
    {0x80800, 0x10010, 0x20071, 0x32000, 0x40000},  // WHERE R1, R5, R6, R7
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80020, 0x10000, 0x20001, 0x3e000, 0x40000},  // REFRESH.read R1
    {0x80020, 0x10000, 0x21000, 0x3c000, 0x40000},  // REFRESH.write R1
    {0x80020, 0x10000, 0x20002, 0x3e000, 0x40000},  // REFRESH.read R2
    {0x80020, 0x10000, 0x22000, 0x3c000, 0x40000},  // REFRESH.write R2
    {0x80020, 0x10000, 0x20004, 0x3e000, 0x40000},  // REFRESH.read R3
    {0x80020, 0x10000, 0x24000, 0x3c000, 0x40000},  // REFRESH.write R3
    {0x80020, 0x10000, 0x20008, 0x3e000, 0x40000},  // REFRESH.read R4
    {0x80020, 0x10000, 0x28000, 0x3c000, 0x40000},  // REFRESH.write R4
    {0x80020, 0x10000, 0x20010, 0x3e000, 0x40000},  // REFRESH.read R5
    {0x80020, 0x10000, 0x20000, 0x3c001, 0x40000},  // REFRESH.write R5
    {0x80020, 0x10000, 0x20020, 0x3e000, 0x40000},  // REFRESH.read R6
    {0x80020, 0x10000, 0x20000, 0x3c002, 0x40000},  // REFRESH.write R6
    {0x80020, 0x10000, 0x20040, 0x3e000, 0x40000},  // REFRESH.read R7
    {0x80020, 0x10000, 0x20000, 0x3c004, 0x40000},  // REFRESH.write R7
    {0x80020, 0x10000, 0x20080, 0x3e000, 0x40000},  // REFRESH.read R8
    {0x80020, 0x10000, 0x20000, 0x3c008, 0x40000},  // REFRESH.write R8
};
void k8() { scamp5_kernel(k8_words, 19), Run(); }
#else
void k8() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        OR(R9, R1, R5, R6, R7);             // OR R9, R1, R5, R6, R7
        WHERE(R9);                          // WHERE R9
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
#endif

// staggered.nsl:6: frame 8 slots of 2ms
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
    {2002, 0, 1, 1},                // boundary 1
    {4002, 0, 2, 1},                // boundary 2
    {6002, 0, 3, 1},                // boundary 3
    {8002, 0, 4, 1},                // boundary 4
    {10002, 0, 5, 1},               // boundary 5
    {12002, 0, 6, 1},               // boundary 6
    {14002, 0, 7, 1},               // boundary 7
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

// staggered.nsl:12: pixels phase = 5 * (x % 4 + 4 * (y % 4)) % N
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

void load_r1() {
    scamp5_kernel_begin();
        CLR(R1);
    scamp5_kernel_end();
    scamp5_load_pattern(R1, 1, 3, 254, 252);
}

void load_r2() {
    scamp5_kernel_begin();
        CLR(R2);
    scamp5_kernel_end();
    scamp5_load_pattern(R2, 1, 0, 254, 252);
}

void load_r3() {
    scamp5_kernel_begin();
        CLR(R3);
    scamp5_kernel_end();
    scamp5_load_pattern(R3, 0, 1, 254, 252);
}

void load_r4() {
    scamp5_kernel_begin();
        CLR(R4);
    scamp5_kernel_end();
    scamp5_load_pattern(R4, 1, 2, 254, 252);
}

void load_r5() {
    scamp5_kernel_begin();
        CLR(R5);
    scamp5_kernel_end();
    scamp5_load_pattern(R5, 0, 2, 254, 252);
}

void load_r6() {
    scamp5_kernel_begin();
        CLR(R6);
    scamp5_kernel_end();
    scamp5_load_pattern(R6, 1, 1, 254, 252);
}

void load_r7() {
    scamp5_kernel_begin();
        CLR(R7);
    scamp5_kernel_end();
    scamp5_load_pattern(R7, 0, 0, 254, 252);
}

void load_r8() {
    scamp5_kernel_begin();
        CLR(R8);
    scamp5_kernel_end();
    scamp5_load_pattern(R8, 0, 3, 254, 252);
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
