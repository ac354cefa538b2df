// class_b_4096.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of
// the compiled program, each launched kernel word for word as it was proved.
//
// class      b: every shutter is open from slot 0 up to a stop of its own, in the codes that the
//            pixels use
// slots      4096 of 100 us, 409600 us in all
// lowering   edges; encoding: event times in Gray code
// digital    R0 scratch; R1 fall time, Gray bit 0; R2 fall time, Gray bit 1; R3 fall time, Gray bit
//            2; R4 fall time, Gray bit 3; R5 fall time, Gray bit 4; R6 fall time, Gray bit 5
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      56 stored in 9 kernels, 392 a frame; 37 more load the codes and prepare readout
// time       waits fill the slots after the words, at 0.2 us an analog word, 0.1 us a digital one
//            and 1 us a launch; they are whole microseconds, rounded up so that no slot is too
//            short, which makes a frame 50.8 us longer
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// source     SHA-256 f424613be851eee10a9417f01be0b67595a075227396888c174f39514196ba2a

#include <scamp5.hpp>

#include <cstdint>

using namespace SCAMP5_PE;

namespace {

// Runs a constant table, be scamp5_kernel(table, n) a function that runs it or an object that runs
// when it is called.
struct Run {};
template <class Kernel>
auto operator,(Kernel &&kernel, Run) -> decltype(kernel()) {
    return kernel();
}

// 8 words, 2.6 us; launched at boundary 0
// writes A: class_b_4096.nsl:9: open when n < stop
void k0() {
    scamp5_kernel_begin();
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix(B);                          // rpix; rpix; nop; bus NEWS, PIX; bus B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 64
// writes A: class_b_4096.nsl:9: open when n < stop
const uint32_t k1_words[][5] = {
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k1() { scamp5_kernel(k1_words, 4), Run(); }

// 6 words, 1.8 us; launched at boundary 128..3968/128
// writes A: class_b_4096.nsl:9: open when n < stop
const uint32_t k2_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k2() { scamp5_kernel(k2_words, 6), Run(); }

// 6 words, 1.8 us; launched at boundary 192..4032/256
// writes A: class_b_4096.nsl:9: open when n < stop
const uint32_t k3_words[][5] = {
    {0x80000, 0x10000, 0x20002, 0x32400, 0x40000},  // NOR.read R2
    {0x80000, 0x10000, 0x22000, 0x30400, 0x40000},  // NOR.write R2
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k3() { scamp5_kernel(k3_words, 6), Run(); }

// 6 words, 1.8 us; launched at boundary 320..3904/512
// writes A: class_b_4096.nsl:9: open when n < stop
const uint32_t k4_words[][5] = {
    {0x80000, 0x10000, 0x20004, 0x32400, 0x40000},  // NOR.read R3
    {0x80000, 0x10000, 0x24000, 0x30400, 0x40000},  // NOR.write R3
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k4() { scamp5_kernel(k4_words, 6), Run(); }

// 6 words, 1.8 us; launched at boundary 576..3648/1024
// writes A: class_b_4096.nsl:9: open when n < stop
const uint32_t k5_words[][5] = {
    {0x80000, 0x10000, 0x20008, 0x32400, 0x40000},  // NOR.read R4
    {0x80000, 0x10000, 0x28000, 0x30400, 0x40000},  // NOR.write R4
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k5() { scamp5_kernel(k5_words, 6), Run(); }

// 6 words, 1.8 us; launched at boundary 1088,3136
// writes A: class_b_4096.nsl:9: open when n < stop
const uint32_t k6_words[][5] = {
    {0x80000, 0x10000, 0x20010, 0x32400, 0x40000},  // NOR.read R5
    {0x80000, 0x10000, 0x20000, 0x30401, 0x40000},  // NOR.write R5
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k6() { scamp5_kernel(k6_words, 6), Run(); }

// 6 words, 1.8 us; launched at boundary 2112
// writes A: class_b_4096.nsl:9: open when n < stop
const uint32_t k7_words[][5] = {
    {0x80000, 0x10000, 0x20020, 0x32400, 0x40000},  // NOR.read R6
    {0x80000, 0x10000, 0x20000, 0x30402, 0x40000},  // NOR.write R6
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k7() { scamp5_kernel(k7_words, 6), Run(); }

// 8 words, 2 us; launched at boundary 4096
// writes A: class_b_4096.nsl:9: open when n < stop
const uint32_t k8_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20020, 0x32400, 0x40000},  // NOR.read R6
    {0x80000, 0x10000, 0x20000, 0x30402, 0x40000},  // NOR.write R6
};
void k8() { scamp5_kernel(k8_words, 8), Run(); }

// class_b_4096.nsl:6: frame 4096 slots of 100us           # 0.41 s in all
void (*const kernels[])() = {
    k0, k1, k2, k3, k4, k5, k6, k7, k8,
};

struct Step {
    uint32_t wait_us;               // for the rest of the slots before
    uint16_t kernel;                // then this one of `kernels` runs,
    uint16_t times;                 // so many times over
};

const Step schedule[] = {
    {0, 0, 1},                      // boundary 0
    {6400, 1, 1},                   // boundary 64
    {6399, 2, 1},                   // boundary 128
    {6399, 3, 1},                   // boundary 192
    {6399, 2, 1},                   // boundary 256
    {6399, 4, 1},                   // boundary 320
    {6399, 2, 1},                   // boundary 384
    {6399, 3, 1},                   // boundary 448
    {6399, 2, 1},                   // boundary 512
    {6399, 5, 1},                   // boundary 576
    {6399, 2, 1},                   // boundary 640
    {6399, 3, 1},                   // boundary 704
    {6399, 2, 1},                   // boundary 768
    {6399, 4, 1},                   // boundary 832
    {6399, 2, 1},                   // boundary 896
    {6399, 3, 1},                   // boundary 960
    {6399, 2, 1},                   // boundary 1024
    {6399, 6, 1},                   // boundary 1088
    {6399, 2, 1},                   // boundary 1152
    {6399, 3, 1},                   // boundary 1216
    {6399, 2, 1},                   // boundary 1280
    {6399, 4, 1},                   // boundary 1344
    {6399, 2, 1},                   // boundary 1408
    {6399, 3, 1},                   // boundary 1472
    {6399, 2, 1},                   // boundary 1536
    {6399, 5, 1},                   // boundary 1600
    {6399, 2, 1},                   // boundary 1664
    {6399, 3, 1},                   // boundary 1728
    {6399, 2, 1},                   // boundary 1792
    {6399, 4, 1},                   // boundary 1856
    {6399, 2, 1},                   // boundary 1920
    {6399, 3, 1},                   // boundary 1984
    {6399, 2, 1},                   // boundary 2048
    {6399, 7, 1},                   // boundary 2112
    {6399, 2, 1},                   // boundary 2176
    {6399, 3, 1},                   // boundary 2240
    {6399, 2, 1},                   // boundary 2304
    {6399, 4, 1},                   // boundary 2368
    {6399, 2, 1},                   // boundary 2432
    {6399, 3, 1},                   // boundary 2496
    {6399, 2, 1},                   // boundary 2560
    {6399, 5, 1},                   // boundary 2624
    {6399, 2, 1},                   // boundary 2688
    {6399, 3, 1},                   // boundary 2752
    {6399, 2, 1},                   // boundary 2816
    {6399, 4, 1},                   // boundary 2880
    {6399, 2, 1},                   // boundary 2944
    {6399, 3, 1},                   // boundary 3008
    {6399, 2, 1},                   // boundary 3072
    {6399, 6, 1},                   // boundary 3136
    {6399, 2, 1},                   // boundary 3200
    {6399, 3, 1},                   // boundary 3264
    {6399, 2, 1},                   // boundary 3328
    {6399, 4, 1},                   // boundary 3392
    {6399, 2, 1},                   // boundary 3456
    {6399, 3, 1},                   // boundary 3520
    {6399, 2, 1},                   // boundary 3584
    {6399, 5, 1},                   // boundary 3648
    {6399, 2, 1},                   // boundary 3712
    {6399, 3, 1},                   // boundary 3776
    {6399, 2, 1},                   // boundary 3840
    {6399, 4, 1},                   // boundary 3904
    {6399, 2, 1},                   // boundary 3968
    {6399, 3, 1},                   // boundary 4032
    {6399, 8, 1},                   // boundary 4096
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

// class_b_4096.nsl:11: pixels stop = N / 64 * (1 + (9 * (x % 8) + 8 * (y % 8)) % 64)
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
    {0, 2, 255, 249}, {0, 4, 255, 249},
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
    {0, 1, 254, 250}, {0, 4, 254, 250}, {1, 0, 254, 250}, {1, 5, 254, 250},
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
    {0, 1, 252, 252}, {0, 2, 253, 252}, {1, 2, 252, 253}, {2, 0, 253, 252},
    {2, 3, 252, 252}, {3, 0, 252, 253},
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
    {0, 2, 248, 249}, {0, 3, 249, 248}, {0, 4, 249, 249}, {0, 4, 250, 249},
    {0, 5, 251, 248}, {1, 6, 250, 248}, {2, 6, 249, 249}, {3, 0, 248, 248},
    {4, 0, 249, 249}, {4, 0, 250, 249}, {4, 1, 251, 248}, {4, 6, 248, 249},
    {4, 7, 249, 248}, {5, 2, 250, 248}, {6, 2, 249, 249}, {7, 4, 248, 248},
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
    {0, 0, 248, 251}, {0, 1, 249, 250}, {0, 2, 249, 249}, {0, 2, 250, 249},
    {0, 3, 251, 248}, {1, 4, 250, 248}, {2, 4, 249, 249}, {3, 4, 248, 250},
    {4, 4, 248, 251}, {4, 5, 249, 250}, {4, 6, 249, 249}, {4, 6, 250, 249},
    {4, 7, 251, 248}, {5, 0, 250, 248}, {6, 0, 249, 249}, {7, 0, 248, 250},
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

    // A kernel is recorded when it first runs, which takes time: here, where none is lost.
    for (void (*kernel)() : kernels) {
        kernel();
    }
    load_codes();

    // Faster than frames can be, so that none waits for the next: codes fade meanwhile.
    vs_configure_frame_trigger(VS_FRAME_TRIGGER_CONST_LOOP, 3);
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
