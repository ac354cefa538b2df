// auto_exposure.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of
// the compiled program, each launched kernel word for word as it was proved.
//
// class      looking: pixels look at the light at 1 boundary
// slots      16 of 500 us, 8000 us in all
// lowering   latch; encoding: stop one-hot, was few ones
// digital    R0 scratch; R1 stop; R2 stop; R3 stop; R4 stop; R5 state was; R6 state was; R7 state
//            was; R8 scratch; R9 scratch; R10 scratch; R11 scratch
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      51 stored in 7 kernels, 51 a frame; 16 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 8002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    2 x exposure - full well: all codes for 0 to 30000 e, 117.647 e each
// state      stop in R1 R2 R3 R4: 4 is 0000, 0 is 1000, 1 is 0100, 2 is 0010, 3 is 0001
// state      was in R5 R6 R7: 4 is 000, 0 is 100, 1 is 010, 2 is 001, 3 is 110
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 adf931f3491fdf5c51824a68475d9c8172b0abe35b364b96ab72d860eb2c7b81

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

// 8 words, 2.5 us; launched at boundary 0
// writes A: auto_exposure.nsl:15: open when n < 1 << stop
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix();                           // rpix; rpix; nop
        bus(B, PIX);                        // bus B, PIX
        CLR(R5, R6, R7);                    // CLR R5, R6, R7
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 1
// writes A: auto_exposure.nsl:15: open when n < 1 << stop
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R1);                          // WHERE R1
        add(A, B, PIX);                     // bus NEWS, B, PIX; bus A, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 2
// writes A: auto_exposure.nsl:15: open when n < 1 << stop
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R2);                          // WHERE R2
        add(A, B, PIX);                     // bus NEWS, B, PIX; bus A, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 4
// writes A: auto_exposure.nsl:15: open when n < 1 << stop
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R3);                          // WHERE R3
        add(A, B, PIX);                     // bus NEWS, B, PIX; bus A, NEWS
    scamp5_kernel_end();
}

// 3 words, 1.5 us; launched at boundary 8
// writes A: auto_exposure.nsl:15: open when n < 1 << stop
void k4() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R4);                          // WHERE R4
        add(A, B, PIX);                     // bus NEWS, B, PIX; bus A, NEWS
    scamp5_kernel_end();
}

// 7 words, 2.1 us; launched at boundary 16
void k5() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        bus(NEWS, A);                       // bus NEWS, A
        NOR(R0, R1, R2, R3, R4);            // NOR R0, R1, R2, R3, R4
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B, PIX);               // bus NEWS, A, B, PIX
        where(NEWS, IN);                    // where NEWS, IN
        MOV(R0, FLAG);                      // MOV R0, FLAG
    scamp5_kernel_end();
}

// 24 words, 3.7 us; launched at boundary 16
// writes A: auto_exposure.nsl:15: open when n < 1 << stop
#ifdef __LPC43XX__
const uint32_t k6_words[][5] = {
    {0x00420, 0x10110, 0x20000, 0x30000, 0x40000},  // where NEWS, IN
    {0x80060, 0x10000, 0x20000, 0x3e008, 0x40000},  // MOV R8, FLAG
    {0x80020, 0x10000, 0x2000f, 0x3b410, 0x40000},  // NOR R9, R1, R2, R3, R4
    {0x80800, 0x10010, 0x20100, 0x32000, 0x40000},  // WHERE R9
    {0x00402, 0x10141, 0x20000, 0x30000, 0x40000},  // bus NEWS, B, PIX
    {0x02400, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS
    {0x80020, 0x10000, 0x20009, 0x3e001, 0x40000},  // OR R5, R1, R4
    {0x80020, 0x10000, 0x2000a, 0x3e002, 0x40000},  // OR R6, R2, R4
    {0x80020, 0x10000, 0x20004, 0x3e004, 0x40000},  // MOV R7, R3
    {0x80060, 0x10000, 0x2000c, 0x3b610, 0x40000},  // NOR R9, R0, R3, R4, FLAG
    {0x80060, 0x10000, 0x2008e, 0x3b420, 0x40000},  // NOR R10, R2, R3, R4, R8, FLAG
    {0x80020, 0x10000, 0x21300, 0x3e000, 0x40000},  // OR R1, R9, R10
    {0x80060, 0x10000, 0x2000f, 0x3b410, 0x40000},  // NOR R9, R1, R2, R3, R4, FLAG
    {0x80060, 0x10000, 0x2008d, 0x3b420, 0x40000},  // NOR R10, R1, R3, R4, R8, FLAG
    {0x80060, 0x10000, 0x20009, 0x3b640, 0x40000},  // NOR R11, R0, R1, R4, FLAG
    {0x80020, 0x10000, 0x22700, 0x3e000, 0x40000},  // OR R2, R9, R10, R11
    {0x80060, 0x10000, 0x2000f, 0x3b410, 0x40000},  // NOR R9, R1, R2, R3, R4, FLAG
    {0x80060, 0x10000, 0x2008b, 0x3b420, 0x40000},  // NOR R10, R1, R2, R4, R8, FLAG
    {0x80060, 0x10000, 0x20003, 0x3b640, 0x40000},  // NOR R11, R0, R1, R2, FLAG
    {0x80020, 0x10000, 0x24700, 0x3e000, 0x40000},  // OR R3, R9, R10, R11
    {0x80060, 0x10000, 0x2000f, 0x3b410, 0x40000},  // NOR R9, R1, R2, R3, R4, FLAG
    {0x80060, 0x10000, 0x20087, 0x3b420, 0x40000},  // NOR R10, R1, R2, R3, R8, FLAG
    {0x80020, 0x10000, 0x20007, 0x3b608, 0x40000},  // NOR R8, R0, R1, R2, R3
    {0x80020, 0x10000, 0x28380, 0x3e000, 0x40000},  // OR R4, R8, R9, R10
};
void k6() { scamp5_kernel(k6_words, 24), Run(); }
#else
void k6() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        where(NEWS, IN);                    // where NEWS, IN
        MOV(R8, FLAG);                      // MOV R8, FLAG
        NOR(R9, R1, R2, R3, R4);            // NOR R9, R1, R2, R3, R4
        WHERE(R9);                          // WHERE R9
        add(A, B, PIX);                     // bus NEWS, B, PIX; bus A, NEWS
        OR(R5, R1, R4);                     // OR R5, R1, R4
        OR(R6, R2, R4);                     // OR R6, R2, R4
        MOV(R7, R3);                        // MOV R7, R3
        NOR(R9, R0, R3, R4, FLAG);          // NOR R9, R0, R3, R4, FLAG
        OR(R10, R2, R3, R4, R8);            // OR R10, R2, R3, R4, R8
        NOR(R10, FLAG);                     // NOR.read R10, FLAG; NOR.write R10
        OR(R1, R9, R10);                    // OR R1, R9, R10
        OR(R9, R1, R2, R3, R4);             // OR R9, R1, R2, R3, R4
        NOR(R9, FLAG);                      // NOR.read R9, FLAG; NOR.write R9
        OR(R10, R1, R3, R4, R8);            // OR R10, R1, R3, R4, R8
        NOR(R10, FLAG);                     // NOR.read R10, FLAG; NOR.write R10
        NOR(R11, R0, R1, R4, FLAG);         // NOR R11, R0, R1, R4, FLAG
        OR(R2, R9, R10, R11);               // OR R2, R9, R10, R11
        OR(R9, R1, R2, R3, R4);             // OR R9, R1, R2, R3, R4
        NOR(R9, FLAG);                      // NOR.read R9, FLAG; NOR.write R9
        OR(R10, R1, R2, R4, R8);            // OR R10, R1, R2, R4, R8
        NOR(R10, FLAG);                     // NOR.read R10, FLAG; NOR.write R10
        NOR(R11, R0, R1, R2, FLAG);         // NOR R11, R0, R1, R2, FLAG
        OR(R3, R9, R10, R11);               // OR R3, R9, R10, R11
        OR(R9, R1, R2, R3, R4);             // OR R9, R1, R2, R3, R4
        NOR(R9, FLAG);                      // NOR.read R9, FLAG; NOR.write R9
        OR(R10, R1, R2, R3, R8);            // OR R10, R1, R2, R3, R8
        NOR(R10, FLAG);                     // NOR.read R10, FLAG; NOR.write R10
        NOR(R8, R0, R1, R2, R3);            // NOR R8, R0, R1, R2, R3
        OR(R4, R8, R9, R10);                // OR R4, R8, R9, R10
    scamp5_kernel_end();
}
#endif

// auto_exposure.nsl:5: frame 16 slots of 500us
void (*const kernels[])() = {
    k0, k1, k2, k3, k4, k5, k6,
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
    const double share = (passed_us - 2) / (8002.0 - 2);
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
    {502, 0, 1, 1, -32768},         // boundary 1
    {1002, 0, 2, 1, -32768},        // boundary 2
    {2002, 0, 3, 1, -32768},        // boundary 4
    {4002, 0, 4, 1, -32768},        // boundary 8
    {8002, 0, 5, 1, 102},           // boundary 16
    {8002, 0, 6, 1, 38},            // boundary 16
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
}

void load_r2() {
    scamp5_kernel_begin();
        CLR(R2);
    scamp5_kernel_end();
}

void load_r3() {
    scamp5_kernel_begin();
        CLR(R3);
    scamp5_kernel_end();
}

void load_r4() {
    scamp5_kernel_begin();
        CLR(R4);
    scamp5_kernel_end();
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
    const auto display_1 = vs_gui_add_display("R1", 0, 2, 2);
    const auto display_2 = vs_gui_add_display("R2", 2, 0, 2);
    const auto display_3 = vs_gui_add_display("R3", 2, 2, 2);
    const auto display_4 = vs_gui_add_display("R4", 4, 0, 2);
    const auto display_5 = vs_gui_add_display("R5", 4, 2, 2);
    const auto display_6 = vs_gui_add_display("R6", 6, 0, 2);
    const auto display_7 = vs_gui_add_display("R7", 6, 2, 2);

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
        scamp5_output_image(R1, display_1);
        scamp5_output_image(R2, display_2);
        scamp5_output_image(R3, display_3);
        scamp5_output_image(R4, display_4);
        scamp5_output_image(R5, display_5);
        scamp5_output_image(R6, display_6);
        scamp5_output_image(R7, display_7);
    }
}
