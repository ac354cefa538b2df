// grown_regions.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of
// the compiled program, each launched kernel word for word as it was proved.
//
// class      a: the shutter is open in every slot, for every pixel
// slots      1 of 1000 us, 1000 us in all
// lowering   accumulate; encoding: no code is needed
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      82 stored in 6 kernels, 82 a frame; 4 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 1002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    images and planes
// images     region in R5; codes of images are signed, 128 is 0
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 4955346c5680c6404031de0739d164b0523c0a1fbfe18fd91bdc4fa93eabdb87

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
// writes A: grown_regions.nsl:5: open when true
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix(B);                          // rpix; rpix; nop; bus NEWS, PIX; bus B, NEWS
    scamp5_kernel_end();
}

// 2 words, 1.4 us; launched at boundary 1
// writes A: grown_regions.nsl:5: open when true
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.7 us; launched at boundary 1
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        where(A, IN);                       // where A, IN
        MOV(R6, FLAG);                      // MOV R6, FLAG
        all();                              // all
    scamp5_kernel_end();
}

// 9 words, 2.3 us; launched at boundary 1
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        where(A, IN);                       // where A, IN
        MOV(R7, FLAG);                      // MOV R7, FLAG
        all();                              // all
        bus(A);                             // bus A
        CLR(R1, R2, R3, R4);                // CLR R1, R2, R3, R4
        SET(R1);                            // SET R1
        DNEWS0(R8, R5);                     // DNEWS0 R8, R5
        bus(B, A);                          // bus B, A
        WHERE(R8);                          // WHERE R8
    scamp5_kernel_end();
}

// 51 words, 8.4 us; launched at boundary 1
void k4() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        bus(B, A, IN);                      // bus B, A, IN
        CLR(R1, R2, R3, R4);                // CLR R1, R2, R3, R4
        SET(R3);                            // SET R3
        DNEWS0(R8, R5);                     // DNEWS0 R8, R5
        all();                              // all
        bus(A, B, IN);                      // bus A, B, IN
        WHERE(R8);                          // WHERE R8
        bus(A, B);                          // bus A, B
        CLR(R1, R2, R3, R4);                // CLR R1, R2, R3, R4
        SET(R4);                            // SET R4
        DNEWS0(R8, R5);                     // DNEWS0 R8, R5
        all();                              // all
        bus(B, A);                          // bus B, A
        WHERE(R8);                          // WHERE R8
        bus(B, A, IN);                      // bus B, A, IN
        CLR(R1, R2, R3, R4);                // CLR R1, R2, R3, R4
        SET(R1);                            // SET R1
        DNEWS0(R9, R8);                     // DNEWS0 R9, R8
        all();                              // all
        bus(A, B, IN);                      // bus A, B, IN
        WHERE(R9);                          // WHERE R9
        bus(A, B);                          // bus A, B
        CLR(R1, R2, R3, R4);                // CLR R1, R2, R3, R4
        SET(R3);                            // SET R3
        DNEWS0(R9, R8);                     // DNEWS0 R9, R8
        all();                              // all
        bus(B, A);                          // bus B, A
        WHERE(R9);                          // WHERE R9
        bus(B, A, IN);                      // bus B, A, IN
        CLR(R1, R2, R3, R4);                // CLR R1, R2, R3, R4
        SET(R2);                            // SET R2
        DNEWS0(R8, R5);                     // DNEWS0 R8, R5
        all();                              // all
        bus(A, B, IN);                      // bus A, B, IN
        WHERE(R8);                          // WHERE R8
        bus(A, B);                          // bus A, B
        CLR(R1, R2, R3, R4);                // CLR R1, R2, R3, R4
        SET(R1);                            // SET R1
        DNEWS0(R9, R8);                     // DNEWS0 R9, R8
        all();                              // all
        bus(B, A);                          // bus B, A
        WHERE(R9);                          // WHERE R9
        bus(B, A, IN);                      // bus B, A, IN
        CLR(R1, R2, R3, R4);                // CLR R1, R2, R3, R4
        SET(R3);                            // SET R3
        DNEWS0(R9, R8);                     // DNEWS0 R9, R8
        all();                              // all
        bus(A, B, IN);                      // bus A, B, IN
        WHERE(R9);                          // WHERE R9
        bus(A, B);                          // bus A, B
        all();                              // all
    scamp5_kernel_end();
}

// 8 words, 2 us; launched at boundary 1
void k5() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        where(A, IN);                       // where A, IN
        MOV(R8, FLAG);                      // MOV R8, FLAG
        all();                              // all
        NOT(R9, R7);                        // NOT R9, R7
        NOT(R10, R8);                       // NOT R10, R8
        NOR(R11, R9, R10);                  // NOR R11, R9, R10
        OR(R7, R6, R11);                    // OR R7, R6, R11
        MOV(R5, R7);                        // MOV R5, R7
    scamp5_kernel_end();
}

// grown_regions.nsl:4: frame 1 slots of 1ms
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
    const double share = (passed_us - 2) / (1002.0 - 2);
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
    {1002, 0, 1, 1, -32768},        // boundary 1
    {1002, 0, 2, 1, -89},           // boundary 1
    {1002, 0, 3, 1, -38},           // boundary 1
    {1002, 0, 4, 1, 30},            // boundary 1
    {1002, 0, 5, 1, 45},            // boundary 1
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
        REFRESH(R5);
    scamp5_kernel_end();
}

void load_r5() {
    scamp5_kernel_begin();
        CLR(R5);
    scamp5_kernel_end();
}

void load_codes() {
    load_r5();
    refresh_codes();
}

}  // namespace

int main() {
    vs_init();
    const auto display_0 = vs_gui_add_display("region", 0, 0, 2);

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
        scamp5_output_image(R5, display_0);
    }
}
