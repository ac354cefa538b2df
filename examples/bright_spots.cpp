// bright_spots.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of
// the compiled program, each launched kernel word for word as it was proved.
//
// class      a: the shutter is open in every slot, for every pixel
// slots      1 of 1000 us, 1000 us in all
// lowering   accumulate; encoding: no code is needed
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      20 stored in 3 kernels, 20 a frame; 1 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 1002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    images and planes
// images     core in R5; codes of images are signed, 128 is 0
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 97ea6e12a94623cbcf4184e952e074962ad0f0bc5331afde0c5d21bd22535449

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
// writes A: bright_spots.nsl:4: open when true
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix(B);                          // rpix; rpix; nop; bus NEWS, PIX; bus B, NEWS
    scamp5_kernel_end();
}

// 2 words, 1.4 us; launched at boundary 1
// writes A: bright_spots.nsl:4: open when true
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}

// 10 words, 2.3 us; launched at boundary 1
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        where(A, IN);                       // where A, IN
        MOV(R5, FLAG);                      // MOV R5, FLAG
        all();                              // all
        NOT(R6, R5);                        // NOT R6, R5
        CLR(R1, R2, R3, R4);                // CLR R1, R2, R3, R4
        SET(R1, R2, R3, R4);                // SET R1, R2, R3, R4
        DNEWS1(R5, R6);                     // DNEWS1 R5, R6
        OR(R7, R5, R6);                     // OR R7, R5, R6
        NOT(R5, R7);                        // NOT R5, R7
    scamp5_kernel_end();
}

// bright_spots.nsl:3: frame 1 slots of 1ms
void (*const kernels[])() = {
    k0, k1, k2,
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
    {1002, 0, 2, 1, -51},           // boundary 1
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

#ifdef __LPC43XX__
const uint16_t margin_0[][4] = {{0, 0, 0, 0}};
uint32_t frame;                     // so many frames came before

// Sends the bits of a plane to the host as text: the first `most` coordinates, then the number of
// bits and the box around them. `margins` are the numbers of columns on the left and right and of
// rows at the top and bottom that depend on values beyond the array and are left out, for the first
// frame, the second and so on; the last entry is for all later frames. (In the simulator, the
// displays show the planes.)
template <class Plane, uint32_t frames>
void report(const char *name, const Plane &plane, const uint16_t (&margins)[frames][4], int most) {
    const uint16_t *margin = margins[frame < frames ? frame : frames - 1];
    int count = 0, box[] = {256, 256, -1, -1};
    for (int y = margin[2]; y < 256 - margin[3]; ++y) {
        uint8_t bits[32];
        scamp5_scan_dreg(plane, bits, uint8_t(y), uint8_t(y));
        for (int x = margin[0]; x < 256 - margin[1]; ++x) {
            const int place = 256 - 1 - x;       // the first bit is the rightmost pixel
            if (!(bits[place / 8] >> place % 8 & 1)) {
                continue;
            }
            if (count++ < most) {
                vs_post_text("%s: %d %d\n", name, x, y);
            }
            box[0] = x < box[0] ? x : box[0];
            box[1] = y < box[1] ? y : box[1];
            box[2] = x > box[2] ? x : box[2];
            box[3] = y;
        }
    }
    vs_post_text("%s: %d in %d %d to %d %d\n", name, count, box[0], box[1], box[2], box[3]);
}
#endif

}  // namespace

int main() {
    vs_init();
    const auto display_0 = vs_gui_add_display("core", 0, 0, 2);

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
        scamp5_output_image(R5, display_0);
#ifdef __LPC43XX__
        report("events core", R5, margin_0, 1000);
        frame += frame < 65535;
#endif
    }
}
