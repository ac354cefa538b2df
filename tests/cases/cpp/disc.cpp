// disc.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of the
// compiled program, each launched kernel word for word as it was proved.
//
// class      general: buckets of different classes: early class b, late class d
// slots      4 of 100 to 800 us, 1500 us in all
// lowering   edges; encoding: one register for each predicate
// digital    R1 fall at boundary 1; R2 fall at boundary 3
// analog     A exposure of early; B exposure of late; C reset level of PIX; NEWS scratch of analog
//            words
// words      26 stored in 4 kernels, 26 a frame; 13 more load the codes and prepare readout
// time       the exposure begins 3 us after the frame's first word and ends 1503 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    2 x exposure - full well: all codes for 0 to 30000 e, 117.647 e each
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// image      disc.R1.bmp, in the host application's folder: the code in R1, SHA-256
//            1a845b442ba76f43a33ca9cc5399d826f1125fcdc86311b61164799765d1cf8f
// image      disc.R2.bmp, in the host application's folder: the code in R2, SHA-256
//            5a211bf550a405a9d55afb572ef5e8bfac55aee3174620e9986adeade836c7e0
// source     SHA-256 644ad2f8f556a02dcc369725d9fb8be1b1f78f884ddce93c94e7b47a2735c6c6

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
// writes A: disc.nsl:4: bucket early open when n < split
// writes B: disc.nsl:5: bucket late open when n >= split
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A, B);                          // bus NEWS; bus A, NEWS; bus B, NEWS
        respix(C);                          // rpix; rpix; nop; bus NEWS, PIX; bus C, NEWS
    scamp5_kernel_end();
}

// 5 words, 1.9 us; launched at boundary 1
// writes A: disc.nsl:4: bucket early open when n < split
// writes B: disc.nsl:5: bucket late open when n >= split
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R1);                          // WHERE R1
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, C, NEWS);                    // bus A, C, NEWS
        bus(NEWS, B, C);                    // bus NEWS, B, C
        bus(B, NEWS, PIX);                  // bus B, NEWS, PIX
    scamp5_kernel_end();
}

// 5 words, 1.9 us; launched at boundary 3
// writes A: disc.nsl:4: bucket early open when n < split
// writes B: disc.nsl:5: bucket late open when n >= split
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        WHERE(R2);                          // WHERE R2
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, C, NEWS);                    // bus A, C, NEWS
        bus(NEWS, B, C);                    // bus NEWS, B, C
        bus(B, NEWS, PIX);                  // bus B, NEWS, PIX
    scamp5_kernel_end();
}

// 7 words, 2 us; launched at boundary 4
// writes B: disc.nsl:5: bucket late open when n >= split
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        bus(NEWS, B, PIX);                  // bus NEWS, B, PIX
        bus(B, C, NEWS);                    // bus B, C, NEWS
        REFRESH(R1);                        // REFRESH.read R1; REFRESH.write R1
        REFRESH(R2);                        // REFRESH.read R2; REFRESH.write R2
    scamp5_kernel_end();
}

// disc.nsl:2: frame slots [100us, 200us, 0.4ms, 800us]
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
    const double share = (passed_us - 3) / (1503.0 - 3);
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
    {103, 0, 1, 1},                 // boundary 1
    {703, 0, 2, 1},                 // boundary 3
    {1503, 0, 3, 1},                // boundary 4
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

// disc.nsl:6: pixels split = 1 if (x - 100) * (x - 100) + (y - 60) * (y - 60) < 2500 else 3
// Digital memory fades when it is not written for a while: all codes are written back after each
// plane, and again and again during what takes long.
void refresh_codes() {
    scamp5_kernel_begin();
        REFRESH(R1);
        REFRESH(R2);
    scamp5_kernel_end();
}

const int rows = 256, cols = 256;

// Draws an image onto a cleared plane. Column 0 of the image is its left one, column 0 of the array
// the right one.
template <class Plane>
void draw(const vs_dotmat &image, const Plane &plane) {
    const uint8_t *bits = static_cast<const uint8_t *>(image.get_buffer());
    scamp5_draw_begin(plane);
    for (int row = 0; row < rows; ++row) {
        for (int x = 0; x < cols; ++x) {
            if (bits[(row * 256 + x) / 8] >> x % 8 & 1) {
                scamp5_draw_pixel(row, cols - 1 - x);
            }
        }
        if (row % 16 == 15) {
            refresh_codes();
        }
    }
    scamp5_draw_end();
}

// Asks the host for an image until it is there, with the right size: a request that is not answered
// in time, or was not taken, is made again.
template <class Plane>
void load_image(const char *file, const Plane &plane) {
    bool drawn = false;
    while (!drawn) {
        bool answered = false;
        vs_gui_request_image(file, 1, [&](const vs_dotmat &image, int status) {
            answered = true;
            if (status >= 0 && image.get_width() == 256 &&
                image.get_height() == rows) {
                draw(image, plane);
                drawn = true;
            }
        });
        for (int turn = 0; turn < 20 && !answered; ++turn) {
            vs_frame_loop_control();
            refresh_codes();
        }
    }
}

void load_r1() {
    scamp5_kernel_begin();
        CLR(R1);
    scamp5_kernel_end();
    load_image("disc.R1.bmp", R1);
}

void load_r2() {
    scamp5_kernel_begin();
        CLR(R2);
    scamp5_kernel_end();
    load_image("disc.R2.bmp", R2);
}

void load_codes() {
    load_r1();
    refresh_codes();
    load_r2();
    refresh_codes();
}

}  // namespace

int main() {
    vs_init();
    const auto display_0 = vs_gui_add_display("early", 0, 0, 2);
    const auto display_1 = vs_gui_add_display("late", 0, 2, 2);

#ifdef __LPC43XX__
    // A kernel is recorded when it first runs, which takes time: here, where none is lost.
    for (void (*kernel)() : kernels) {
        kernel();
    }
#endif

    // While images are awaited, codes are refreshed at this rate.
    vs_configure_frame_trigger(VS_FRAME_TRIGGER_CONST_LOOP, 3);
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
            bus(F, B, IN);
            bus(NEWS, B, IN);
            bus(B, NEWS, F, IN);
        scamp5_kernel_end();
        scamp5_output_image(A, display_0);
        scamp5_output_image(B, display_1);
    }
}
