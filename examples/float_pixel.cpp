// float_pixel.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of
// the compiled program, each launched kernel word for word as it was proved.
//
// class      looking: pixels look at the light at 8 boundaries
// slots      256 of 125 us, 32000 us in all
// lowering   latch; encoding: closed_at one-hot
// digital    R0 scratch; R1 state closed_at; R2 state closed_at; R3 state closed_at; R4 state
//            closed_at; R5 state closed_at; R6 state closed_at; R7 state closed_at; R8 state
//            closed_at
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      61 stored in 10 kernels, 61 a frame; 4 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 32002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    2 x exposure - full well: all codes for 0 to 30000 e, 117.647 e each
// state      closed_at in R1 R2 R3 R4 R5 R6 R7 R8: 0 is 00000000, 1 is 10000000, 2 is 01000000, 3
//            is 00100000, 4 is 00010000, 5 is 00001000, 6 is 00000100, 7 is 00000010, 8 is 00000001
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 3a3a8c11b2a9148ed284d05d6abba2dd86788ebefb74094b51b51265e5f2293e

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

// 9 words, 2.6 us; launched at boundary 0
// writes A: float_pixel.nsl:13: open when closed_at == 0
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix();                           // rpix; rpix; nop
        bus(B, PIX);                        // bus B, PIX
        CLR(R1, R2, R3, R4);                // CLR R1, R2, R3, R4
        CLR(R5, R6, R7, R8);                // CLR R5, R6, R7, R8
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 1
// writes A: float_pixel.nsl:13: open when closed_at == 0
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        bus(NEWS, B, PIX);                  // bus NEWS, B, PIX
        where(NEWS, IN);                    // where NEWS, IN
        NOT(R1, FLAG);                      // NOT R1, FLAG
        WHERE(R1);                          // WHERE R1
        bus(A, NEWS);                       // bus A, NEWS
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 2
// writes A: float_pixel.nsl:13: open when closed_at == 0
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        bus(NEWS, B, PIX);                  // bus NEWS, B, PIX
        where(NEWS, IN);                    // where NEWS, IN
        NOR(R2, R1, FLAG);                  // NOR R2, R1, FLAG
        WHERE(R2);                          // WHERE R2
        bus(A, NEWS);                       // bus A, NEWS
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 4
// writes A: float_pixel.nsl:13: open when closed_at == 0
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        bus(NEWS, B, PIX);                  // bus NEWS, B, PIX
        where(NEWS, IN);                    // where NEWS, IN
        NOR(R3, R1, R2, FLAG);              // NOR R3, R1, R2, FLAG
        WHERE(R3);                          // WHERE R3
        bus(A, NEWS);                       // bus A, NEWS
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 8
// writes A: float_pixel.nsl:13: open when closed_at == 0
void k4() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        bus(NEWS, B, PIX);                  // bus NEWS, B, PIX
        where(NEWS, IN);                    // where NEWS, IN
        NOR(R4, R1, R2, R3, FLAG);          // NOR R4, R1, R2, R3, FLAG
        WHERE(R4);                          // WHERE R4
        bus(A, NEWS);                       // bus A, NEWS
    scamp5_kernel_end();
}

// 6 words, 2 us; launched at boundary 16
// writes A: float_pixel.nsl:13: open when closed_at == 0
#ifdef __LPC43XX__
const uint32_t k5_words[][5] = {
    {0x00800, 0x11000, 0x20000, 0x32000, 0x40000},  // all
    {0x00402, 0x10141, 0x20000, 0x30000, 0x40000},  // bus NEWS, B, PIX
    {0x00420, 0x10110, 0x20000, 0x30000, 0x40000},  // where NEWS, IN
    {0x80060, 0x10000, 0x2000f, 0x3b401, 0x40000},  // NOR R5, R1, R2, R3, R4, FLAG
    {0x80800, 0x10010, 0x20010, 0x32000, 0x40000},  // WHERE R5
    {0x02400, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS
};
void k5() { scamp5_kernel(k5_words, 6), Run(); }
#else
void k5() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        bus(NEWS, B, PIX);                  // bus NEWS, B, PIX
        where(NEWS, IN);                    // where NEWS, IN
        OR(R5, R1, R2, R3, R4);             // OR R5, R1, R2, R3, R4
        NOR(R5, FLAG);                      // NOR.read R5, FLAG; NOR.write R5
        WHERE(R5);                          // WHERE R5
        bus(A, NEWS);                       // bus A, NEWS
    scamp5_kernel_end();
}
#endif

// 6 words, 2 us; launched at boundary 32
// writes A: float_pixel.nsl:13: open when closed_at == 0
#ifdef __LPC43XX__
const uint32_t k6_words[][5] = {
    {0x00800, 0x11000, 0x20000, 0x32000, 0x40000},  // all
    {0x00402, 0x10141, 0x20000, 0x30000, 0x40000},  // bus NEWS, B, PIX
    {0x00420, 0x10110, 0x20000, 0x30000, 0x40000},  // where NEWS, IN
    {0x80060, 0x10000, 0x2001f, 0x3b402, 0x40000},  // NOR R6, R1, R2, R3, R4, R5, FLAG
    {0x80800, 0x10010, 0x20020, 0x32000, 0x40000},  // WHERE R6
    {0x02400, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS
};
void k6() { scamp5_kernel(k6_words, 6), Run(); }
#else
void k6() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        bus(NEWS, B, PIX);                  // bus NEWS, B, PIX
        where(NEWS, IN);                    // where NEWS, IN
        OR(R6, R1, R2, R3, R4);             // OR R6, R1, R2, R3, R4
        OR(R6, R5);                         // OR.read R5, R6; OR.write R6
        NOR(R6, FLAG);                      // NOR.read R6, FLAG; NOR.write R6
        WHERE(R6);                          // WHERE R6
        bus(A, NEWS);                       // bus A, NEWS
    scamp5_kernel_end();
}
#endif

// 6 words, 2 us; launched at boundary 64
// writes A: float_pixel.nsl:13: open when closed_at == 0
#ifdef __LPC43XX__
const uint32_t k7_words[][5] = {
    {0x00800, 0x11000, 0x20000, 0x32000, 0x40000},  // all
    {0x00402, 0x10141, 0x20000, 0x30000, 0x40000},  // bus NEWS, B, PIX
    {0x00420, 0x10110, 0x20000, 0x30000, 0x40000},  // where NEWS, IN
    {0x80060, 0x10000, 0x2003f, 0x3b404, 0x40000},  // NOR R7, R1, R2, R3, R4, R5, R6, FLAG
    {0x80800, 0x10010, 0x20040, 0x32000, 0x40000},  // WHERE R7
    {0x02400, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS
};
void k7() { scamp5_kernel(k7_words, 6), Run(); }
#else
void k7() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        bus(NEWS, B, PIX);                  // bus NEWS, B, PIX
        where(NEWS, IN);                    // where NEWS, IN
        OR(R7, R1, R2, R3, R4);             // OR R7, R1, R2, R3, R4
        OR(R7, R5);                         // OR.read R5, R7; OR.write R7
        OR(R7, R6);                         // OR.read R6, R7; OR.write R7
        NOR(R7, FLAG);                      // NOR.read R7, FLAG; NOR.write R7
        WHERE(R7);                          // WHERE R7
        bus(A, NEWS);                       // bus A, NEWS
    scamp5_kernel_end();
}
#endif

// 6 words, 2 us; launched at boundary 128
// writes A: float_pixel.nsl:13: open when closed_at == 0
#ifdef __LPC43XX__
const uint32_t k8_words[][5] = {
    {0x00800, 0x11000, 0x20000, 0x32000, 0x40000},  // all
    {0x00402, 0x10141, 0x20000, 0x30000, 0x40000},  // bus NEWS, B, PIX
    {0x00420, 0x10110, 0x20000, 0x30000, 0x40000},  // where NEWS, IN
    {0x80060, 0x10000, 0x2007f, 0x3b408, 0x40000},  // NOR R8, R1, R2, R3, R4, R5, R6, R7, FLAG
    {0x80800, 0x10010, 0x20080, 0x32000, 0x40000},  // WHERE R8
    {0x02400, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS
};
void k8() { scamp5_kernel(k8_words, 6), Run(); }
#else
void k8() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        bus(NEWS, B, PIX);                  // bus NEWS, B, PIX
        where(NEWS, IN);                    // where NEWS, IN
        OR(R8, R1, R2, R3, R4);             // OR R8, R1, R2, R3, R4
        OR(R8, R5);                         // OR.read R5, R8; OR.write R8
        OR(R8, R6);                         // OR.read R6, R8; OR.write R8
        OR(R8, R7);                         // OR.read R7, R8; OR.write R8
        NOR(R8, FLAG);                      // NOR.read R8, FLAG; NOR.write R8
        WHERE(R8);                          // WHERE R8
        bus(A, NEWS);                       // bus A, NEWS
    scamp5_kernel_end();
}
#endif

// 4 words, 1.6 us; launched at boundary 256
// writes A: float_pixel.nsl:13: open when closed_at == 0
#ifdef __LPC43XX__
const uint32_t k9_words[][5] = {
    {0x80020, 0x10000, 0x200ff, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6, R7, R8
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10141, 0x20000, 0x30000, 0x40000},  // bus NEWS, B, PIX
    {0x02400, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS
};
void k9() { scamp5_kernel(k9_words, 4), Run(); }
#else
void k9() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        OR(R0, R1, R2, R3, R4);             // OR R0, R1, R2, R3, R4
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        OR(R0, R6);                         // OR.read R0, R6; OR.write R0
        OR(R0, R7);                         // OR.read R0, R7; OR.write R0
        NOR(R0, R8);                        // NOR.read R0, R8; NOR.write R0
        WHERE(R0);                          // WHERE R0
        add(A, B, PIX);                     // bus NEWS, B, PIX; bus A, NEWS
    scamp5_kernel_end();
}
#endif

// float_pixel.nsl:6: frame 256 slots of 125us            # 32 ms in all
void (*const kernels[])() = {
    k0, k1, k2, k3, k4, k5, k6, k7, k8, k9,
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
    int16_t in;                     // with IN at so many steps; -32768: as it is
};

const Step schedule[] = {
    {0, 0, 0, 1, -32768},           // boundary 0
    {127, 0, 1, 1, 57},             // boundary 1
    {252, 0, 2, 1, 57},             // boundary 2
    {502, 0, 3, 1, 57},             // boundary 4
    {1002, 0, 4, 1, 57},            // boundary 8
    {2002, 0, 5, 1, 57},            // boundary 16
    {4002, 0, 6, 1, 57},            // boundary 32
    {8002, 0, 7, 1, 57},            // boundary 64
    {16002, 0, 8, 1, 57},           // boundary 128
    {32002, 0, 9, 1, -32768},       // boundary 256
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
    int16_t in = -32768;
    for (const Step &step : schedule) {
        uint32_t us = step.at_us;
        for (uint16_t i = 0; i < step.times; ++i) {
            // What a boundary launches beside its first kernel follows at once.
            if (us != before) {
                await(clock, us);
                before = us;
            }
            if (step.in != -32768 && step.in != in) {
                scamp5_load_in(int8_t(step.in));
                in = step.in;
#ifdef __LPC43XX__
                vs_wait(5);
#endif
            }
            kernels[step.kernel]();
            us += step.every_us;
        }
    }
}

}  // namespace

int main() {
    vs_init();
    const auto display_0 = vs_gui_add_display("frame", 0, 0, 2);
    const auto display_1 = vs_gui_add_display("R1", 0, 2, 2);
    const auto display_2 = vs_gui_add_display("R2", 2, 0, 2);
    const auto display_3 = vs_gui_add_display("R3", 2, 2, 2);
    const auto display_4 = vs_gui_add_display("R4", 4, 0, 2);
    const auto display_5 = vs_gui_add_display("R5", 4, 2, 2);
    const auto display_6 = vs_gui_add_display("R6", 6, 0, 2);
    const auto display_7 = vs_gui_add_display("R7", 6, 2, 2);
    const auto display_8 = vs_gui_add_display("R8", 8, 0, 2);

#ifdef __LPC43XX__
    // A kernel is recorded when it first runs, which takes time: here, where none is lost.
    for (void (*kernel)() : kernels) {
        kernel();
    }
#endif

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
        scamp5_output_image(R1, display_1);
        scamp5_output_image(R2, display_2);
        scamp5_output_image(R3, display_3);
        scamp5_output_image(R4, display_4);
        scamp5_output_image(R5, display_5);
        scamp5_output_image(R6, display_6);
        scamp5_output_image(R7, display_7);
        scamp5_output_image(R8, display_8);
    }
}
