// local_contrast.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of
// the compiled program, each launched kernel word for word as it was proved.
//
// class      general: buckets of different classes: short class b, long class a
// slots      64 of 250 us, 16000 us in all
// lowering   latch; encoding: no code is needed
// analog     A exposure of short; B exposure of long; C reset level of PIX; NEWS scratch of analog
//            words
// words      36 stored in 4 kernels, 36 a frame; 1 more load the codes and prepare readout
// time       the exposure begins 3 us after the frame's first word and ends 16003 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    images and planes
// images     contrast in E, full in R1; codes of images are signed, 128 is 0
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 ad4eb15e358a504e1d3426d18d9b034c1616f9b2227c859c744018fd79e041d4

#include <scamp5.hpp>

#include <cstdint>

using namespace SCAMP5_PE;

#ifdef __LPC43XX__
#define SLOW_CLOCK allow_highspeed(false);      // analog words do not keep up with the fast one
#else
#define SLOW_CLOCK
#endif

namespace {

// 9 words, 2.8 us; launched at boundary 0
// writes A: local_contrast.nsl:4: bucket short open when n < 16
// writes B: local_contrast.nsl:5: bucket long open when true
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A, B);                          // bus NEWS; bus A, NEWS; bus B, NEWS
        respix(C);                          // rpix; rpix; nop; bus NEWS, PIX; bus C, NEWS
    scamp5_kernel_end();
}

// 2 words, 1.4 us; launched at boundary 16
// writes A: local_contrast.nsl:4: bucket short open when n < 16
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        getpix(A, C);                       // bus NEWS, PIX; bus A, C, NEWS
    scamp5_kernel_end();
}

// 2 words, 1.4 us; launched at boundary 64
// writes B: local_contrast.nsl:5: bucket long open when true
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        getpix(B, C);                       // bus NEWS, PIX; bus B, C, NEWS
    scamp5_kernel_end();
}

// 23 words, 5.4 us; launched at boundary 64
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        where(B, IN);                       // where B, IN
        MOV(R1, FLAG);                      // MOV R1, FLAG
        all();                              // all
        bus2(C, NEWS, B);                   // bus2 C, NEWS, B
        bus2(B, NEWS, C);                   // bus2 B, NEWS, C
        bus(D, B);                          // bus D, B
        WHERE(R1);                          // WHERE R1
        bus(D, A);                          // bus D, A
        all();                              // all
        bus2(A, NEWS, D);                   // bus2 A, NEWS, D
        bus2(NEWS, E, A);                   // bus2 NEWS, E, A
        bus(XW, E);                         // bus XW, E
        bus2(A, F, NEWS, E);                // bus2 A, F, NEWS, E
        bus2(A, NEWS, E, F);                // bus2 A, NEWS, E, F
        bus(F, XW);                         // bus F, XW
        bus(B, F);                          // bus B, F
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(F, XS);                         // bus F, XS
        bus(C, XN);                         // bus C, XN
        bus(E, A, B, C, F);                 // bus E, A, B, C, F
        bus(C, NEWS, E);                    // bus C, NEWS, E
        bus(E, C, D);                       // bus E, C, D
    scamp5_kernel_end();
}

// local_contrast.nsl:3: frame 64 slots of 250us
void (*const kernels[])() = {
    k0, k1, k2, k3,
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
    const double share = (passed_us - 3) / (16003.0 - 3);
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
    {4003, 0, 1, 1, -32768},        // boundary 16
    {16003, 0, 2, 1, -32768},       // boundary 64
    {16003, 0, 3, 1, -114},         // boundary 64
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
    const auto display_0 = vs_gui_add_display("contrast", 0, 0, 2);
    const auto display_1 = vs_gui_add_display("full", 0, 2, 2);

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
        scamp5_kernel_begin();
            all();
        scamp5_kernel_end();
        scamp5_output_image(E, display_0);
        scamp5_output_image(R1, display_1);
    }
}
