// class_c.nsl: per-pixel shutters for the SCAMP-5d devkit. Written by nscc from the words of the
// compiled program, each launched kernel word for word as it was proved.
//
// class      c: every shutter is one bump of 8 slots, in all codes that the fields allow
// slots      64 of 500 us, 32000 us in all
// lowering   edges; encoding: event times in Gray code
// digital    R0 scratch; R1 fall time, Gray bit 0; R2 fall time, Gray bit 1; R3 fall time, Gray bit
//            2; R4 fall time, Gray bit 3; R5 fall time, Gray bit 4; R6 fall time, Gray bit 5; R7
//            rise time, Gray bit 0; R8 rise time, Gray bit 1; R9 rise time, Gray bit 2; R10 rise
//            time, Gray bit 3; R11 rise time, Gray bit 5; R12 rise time, Gray bit 4
// analog     A exposure of frame; B reset level of PIX; NEWS scratch of analog words
// words      315 stored in 20 kernels, 1146 a frame; 42 more load the codes and prepare readout
// time       the exposure begins 2 us after the frame's first word and ends 32002 us after it; a
//            launch waits for its moment on a clock that runs on, so that no error adds up; words
//            take, by the target's figures, 0.2 us (analog) and 0.1 us (digital), a launch 1 us
// readout    2 x exposure - full well: all codes for 0 to 30000 e, 117.647 e each
// array      256 x 256 pixels; the devkit's (0, 0) is the top right one
// image      class_c.R12.bmp, in the host application's folder: the code in R12, SHA-256
//            d70a1d53ae8cd805a9efb410ba857937d95ae22d1bfea8340b5d1213aa84f021
// image      class_c.R1.bmp, in the host application's folder: the code in R1, SHA-256
//            9c715ed899c9f17052ce0f4b5de35c00ab27e4692fc39b670e909f0eca27b060
// image      class_c.R2.bmp, in the host application's folder: the code in R2, SHA-256
//            8db97fe3b2fd552103863588a7b62db54fd5b43b75d10d5511715b82d9107f3e
// image      class_c.R3.bmp, in the host application's folder: the code in R3, SHA-256
//            b2aa2917bc8d9030d7e17b3501ccb6339894dd4924cdbd43353645fc7711bda9
// image      class_c.R4.bmp, in the host application's folder: the code in R4, SHA-256
//            b63e43bc90a0d3c2a5f8ef781cd79d3c6c88c7f984affaea61ba35d12b6726e5
// image      class_c.R5.bmp, in the host application's folder: the code in R5, SHA-256
//            ddf037d1f9850117c59bc098c104e3e45d8b466487b22389c35b739bc352894b
// image      class_c.R6.bmp, in the host application's folder: the code in R6, SHA-256
//            bfe535b46ccd4b21ce900b81283f88401bc11f7c1b93c17cd824235efb758177
// image      class_c.R7.bmp, in the host application's folder: the code in R7, SHA-256
//            19567c4bc53a2ad545ea59bdcd014946664fcb8c3bb753560d702bad595420ae
// image      class_c.R8.bmp, in the host application's folder: the code in R8, SHA-256
//            bdd855c9ee52ed3651c82b98fc2d58cb3fa0e59100136c0c9f5358b102a7d25f
// image      class_c.R9.bmp, in the host application's folder: the code in R9, SHA-256
//            fd2da3ffcc7dab80daa0ebb18daa06803627707ac7a2331118752b9ed81104dc
// image      class_c.R10.bmp, in the host application's folder: the code in R10, SHA-256
//            d269742b79cb9d83c39bc07cdfd381307cf37723a2315dc45fd37030b8191099
// image      class_c.R11.bmp, in the host application's folder: the code in R11, SHA-256
//            9682eadf7f50035bc26dfc75bd963509f2cf809110eb9d2a4d5cabd10e6118b4
// source     SHA-256 bf0e21564b8a64114c852a959857ebee77e8ec2766a1dea6e9a0111b67a5053d

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
// writes A: class_c.nsl:9: open when start <= n < start + len
void k0() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix(B);                          // rpix; rpix; nop; bus NEWS, PIX; bus B, NEWS
    scamp5_kernel_end();
}

// 8 words, 2 us; launched at boundary 1
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k1_words[][5] = {
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k1() { scamp5_kernel(k1_words, 8), Run(); }
#else
void k1() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 10 words, 2.2 us; launched at boundary 2..6/2
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k2_words[][5] = {
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k2() { scamp5_kernel(k2_words, 10), Run(); }
#else
void k2() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R7);                            // NOR.read R7; NOR.write R7
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 10 words, 2.2 us; launched at boundary 3,7
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k3_words[][5] = {
    {0x80000, 0x10000, 0x20080, 0x32400, 0x40000},  // NOR.read R8
    {0x80000, 0x10000, 0x20000, 0x30408, 0x40000},  // NOR.write R8
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k3() { scamp5_kernel(k3_words, 10), Run(); }
#else
void k3() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R8);                            // NOR.read R8; NOR.write R8
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 10 words, 2.2 us; launched at boundary 5
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k4_words[][5] = {
    {0x80000, 0x10000, 0x20100, 0x32400, 0x40000},  // NOR.read R9
    {0x80000, 0x10000, 0x20000, 0x30410, 0x40000},  // NOR.write R9
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k4() { scamp5_kernel(k4_words, 10), Run(); }
#else
void k4() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R9);                            // NOR.read R9; NOR.write R9
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 18 words, 3.2 us; launched at boundary 8
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k5_words[][5] = {
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k5() { scamp5_kernel(k5_words, 18), Run(); }
#else
void k5() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R7);                            // NOR.read R7; NOR.write R7
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 20 words, 3.4 us; launched at boundary 9..41/16
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k6_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20200, 0x32400, 0x40000},  // NOR.read R10
    {0x80000, 0x10000, 0x20000, 0x30420, 0x40000},  // NOR.write R10
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k6() { scamp5_kernel(k6_words, 20), Run(); }
#else
void k6() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R1);                            // NOR.read R1; NOR.write R1
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R10);                           // NOR.read R10; NOR.write R10
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 20 words, 3.4 us; launched at boundary 10..54/4
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k7_words[][5] = {
    {0x80000, 0x10000, 0x20002, 0x32400, 0x40000},  // NOR.read R2
    {0x80000, 0x10000, 0x22000, 0x30400, 0x40000},  // NOR.write R2
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k7() { scamp5_kernel(k7_words, 20), Run(); }
#else
void k7() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R2);                            // NOR.read R2; NOR.write R2
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R7);                            // NOR.read R7; NOR.write R7
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 20 words, 3.4 us; launched at boundary 11..55/4
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k8_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20080, 0x32400, 0x40000},  // NOR.read R8
    {0x80000, 0x10000, 0x20000, 0x30408, 0x40000},  // NOR.write R8
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k8() { scamp5_kernel(k8_words, 20), Run(); }
#else
void k8() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R1);                            // NOR.read R1; NOR.write R1
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R8);                            // NOR.read R8; NOR.write R8
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 20 words, 3.4 us; launched at boundary 12..52/8
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k9_words[][5] = {
    {0x80000, 0x10000, 0x20004, 0x32400, 0x40000},  // NOR.read R3
    {0x80000, 0x10000, 0x24000, 0x30400, 0x40000},  // NOR.write R3
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k9() { scamp5_kernel(k9_words, 20), Run(); }
#else
void k9() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R3);                            // NOR.read R3; NOR.write R3
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R7);                            // NOR.read R7; NOR.write R7
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 20 words, 3.4 us; launched at boundary 13..53/8
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k10_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20100, 0x32400, 0x40000},  // NOR.read R9
    {0x80000, 0x10000, 0x20000, 0x30410, 0x40000},  // NOR.write R9
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k10() { scamp5_kernel(k10_words, 20), Run(); }
#else
void k10() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R1);                            // NOR.read R1; NOR.write R1
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R9);                            // NOR.read R9; NOR.write R9
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 20 words, 3.4 us; launched at boundary 16..48/16
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k11_words[][5] = {
    {0x80000, 0x10000, 0x20008, 0x32400, 0x40000},  // NOR.read R4
    {0x80000, 0x10000, 0x28000, 0x30400, 0x40000},  // NOR.write R4
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k11() { scamp5_kernel(k11_words, 20), Run(); }
#else
void k11() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R4);                            // NOR.read R4; NOR.write R4
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R7);                            // NOR.read R7; NOR.write R7
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 21 words, 3.5 us; launched at boundary 17,49
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k12_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80020, 0x10000, 0x20000, 0x31100, 0x40000},  // SET R0
    {0x80000, 0x10000, 0x20800, 0x32400, 0x40000},  // NOR.read R12
    {0x80000, 0x10000, 0x20000, 0x30480, 0x40000},  // NOR.write R12
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k12() { scamp5_kernel(k12_words, 21), Run(); }
#else
void k12() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R1);                            // NOR.read R1; NOR.write R1
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        SET(R0);                            // SET R0
        NOT(R12);                           // NOR.read R12; NOR.write R12
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 20 words, 3.4 us; launched at boundary 24,56
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k13_words[][5] = {
    {0x80000, 0x10000, 0x20010, 0x32400, 0x40000},  // NOR.read R5
    {0x80000, 0x10000, 0x20000, 0x30401, 0x40000},  // NOR.write R5
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k13() { scamp5_kernel(k13_words, 20), Run(); }
#else
void k13() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R5);                            // NOR.read R5; NOR.write R5
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R7);                            // NOR.read R7; NOR.write R7
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 20 words, 3.4 us; launched at boundary 33
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k14_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20400, 0x32400, 0x40000},  // NOR.read R11
    {0x80000, 0x10000, 0x20000, 0x30440, 0x40000},  // NOR.write R11
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k14() { scamp5_kernel(k14_words, 20), Run(); }
#else
void k14() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R1);                            // NOR.read R1; NOR.write R1
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R11);                           // NOR.read R11; NOR.write R11
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 20 words, 3.4 us; launched at boundary 40
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k15_words[][5] = {
    {0x80000, 0x10000, 0x20020, 0x32400, 0x40000},  // NOR.read R6
    {0x80000, 0x10000, 0x20000, 0x30402, 0x40000},  // NOR.write R6
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x201c0, 0x3e100, 0x40000},  // OR R0, R7, R8, R9
    {0x80000, 0x10000, 0x20a00, 0x3e200, 0x40000},  // OR.read R0, R10, R12
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20400, 0x32600, 0x40000},  // NOR.read R0, R11
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k15() { scamp5_kernel(k15_words, 20), Run(); }
#else
void k15() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R6);                            // NOR.read R6; NOR.write R6
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R7);                            // NOR.read R7; NOR.write R7
        OR(R0, R7, R8, R9);                 // OR R0, R7, R8, R9
        OR(R0, R10);                        // OR.read R0, R10; OR.write R0
        OR(R0, R12);                        // OR.read R0, R12; OR.write R0
        NOR(R0, R11);                       // NOR.read R0, R11; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, B);                    // bus NEWS, A, B
        bus(A, NEWS, PIX);                  // bus A, NEWS, PIX
    scamp5_kernel_end();
}
#endif

// 10 words, 2.2 us; launched at boundary 57..63/2
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k16_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k16() { scamp5_kernel(k16_words, 10), Run(); }
#else
void k16() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R1);                            // NOR.read R1; NOR.write R1
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}
#endif

// 10 words, 2.2 us; launched at boundary 58,62
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k17_words[][5] = {
    {0x80000, 0x10000, 0x20002, 0x32400, 0x40000},  // NOR.read R2
    {0x80000, 0x10000, 0x22000, 0x30400, 0x40000},  // NOR.write R2
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k17() { scamp5_kernel(k17_words, 10), Run(); }
#else
void k17() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R2);                            // NOR.read R2; NOR.write R2
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}
#endif

// 10 words, 2.2 us; launched at boundary 60
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k18_words[][5] = {
    {0x80000, 0x10000, 0x20004, 0x32400, 0x40000},  // NOR.read R3
    {0x80000, 0x10000, 0x24000, 0x30400, 0x40000},  // NOR.write R3
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k18() { scamp5_kernel(k18_words, 10), Run(); }
#else
void k18() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R3);                            // NOR.read R3; NOR.write R3
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
    scamp5_kernel_end();
}
#endif

// 20 words, 3.2 us; launched at boundary 64
// writes A: class_c.nsl:9: open when start <= n < start + len
#ifdef __LPC43XX__
const uint32_t k19_words[][5] = {
    {0x80000, 0x10000, 0x20008, 0x32400, 0x40000},  // NOR.read R4
    {0x80000, 0x10000, 0x28000, 0x30400, 0x40000},  // NOR.write R4
    {0x80020, 0x10000, 0x20007, 0x3e100, 0x40000},  // OR R0, R1, R2, R3
    {0x80000, 0x10000, 0x20018, 0x3e200, 0x40000},  // OR.read R0, R4, R5
    {0x80000, 0x10000, 0x20000, 0x3c100, 0x40000},  // OR.write R0
    {0x80000, 0x10000, 0x20020, 0x32600, 0x40000},  // NOR.read R0, R6
    {0x80000, 0x10000, 0x20000, 0x30500, 0x40000},  // NOR.write R0
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20004, 0x32400, 0x40000},  // NOR.read R3
    {0x80000, 0x10000, 0x24000, 0x30400, 0x40000},  // NOR.write R3
    {0x80000, 0x10000, 0x20020, 0x32400, 0x40000},  // NOR.read R6
    {0x80000, 0x10000, 0x20000, 0x30402, 0x40000},  // NOR.write R6
    {0x80000, 0x10000, 0x20100, 0x32400, 0x40000},  // NOR.read R9
    {0x80000, 0x10000, 0x20000, 0x30410, 0x40000},  // NOR.write R9
    {0x80000, 0x10000, 0x20200, 0x32400, 0x40000},  // NOR.read R10
    {0x80000, 0x10000, 0x20000, 0x30420, 0x40000},  // NOR.write R10
    {0x80000, 0x10000, 0x20400, 0x32400, 0x40000},  // NOR.read R11
    {0x80000, 0x10000, 0x20000, 0x30440, 0x40000},  // NOR.write R11
};
void k19() { scamp5_kernel(k19_words, 20), Run(); }
#else
void k19() {
    scamp5_kernel_begin();
        SLOW_CLOCK
        NOT(R4);                            // NOR.read R4; NOR.write R4
        OR(R0, R1, R2, R3);                 // OR R0, R1, R2, R3
        OR(R0, R4);                         // OR.read R0, R4; OR.write R0
        OR(R0, R5);                         // OR.read R0, R5; OR.write R0
        NOR(R0, R6);                        // NOR.read R0, R6; NOR.write R0
        WHERE(R0);                          // WHERE R0
        bus(NEWS, A, PIX);                  // bus NEWS, A, PIX
        bus(A, B, NEWS);                    // bus A, B, NEWS
        NOT(R3);                            // NOR.read R3; NOR.write R3
        NOT(R6);                            // NOR.read R6; NOR.write R6
        NOT(R9);                            // NOR.read R9; NOR.write R9
        NOT(R10);                           // NOR.read R10; NOR.write R10
        NOT(R11);                           // NOR.read R11; NOR.write R11
    scamp5_kernel_end();
}
#endif

// class_c.nsl:5: frame 64 slots of 500us
void (*const kernels[])() = {
    k0, k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11,
    k12, k13, k14, k15, k16, k17, k18, k19,
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
};

const Step schedule[] = {
    {0, 0, 0, 1},                   // boundary 0
    {502, 0, 1, 1},                 // boundary 1
    {1002, 0, 2, 1},                // boundary 2
    {1502, 0, 3, 1},                // boundary 3
    {2002, 0, 2, 1},                // boundary 4
    {2502, 0, 4, 1},                // boundary 5
    {3002, 0, 2, 1},                // boundary 6
    {3502, 0, 3, 1},                // boundary 7
    {4002, 0, 5, 1},                // boundary 8
    {4502, 0, 6, 1},                // boundary 9
    {5002, 0, 7, 1},                // boundary 10
    {5502, 0, 8, 1},                // boundary 11
    {6002, 0, 9, 1},                // boundary 12
    {6502, 0, 10, 1},               // boundary 13
    {7002, 0, 7, 1},                // boundary 14
    {7502, 0, 8, 1},                // boundary 15
    {8002, 0, 11, 1},               // boundary 16
    {8502, 0, 12, 1},               // boundary 17
    {9002, 0, 7, 1},                // boundary 18
    {9502, 0, 8, 1},                // boundary 19
    {10002, 0, 9, 1},               // boundary 20
    {10502, 0, 10, 1},              // boundary 21
    {11002, 0, 7, 1},               // boundary 22
    {11502, 0, 8, 1},               // boundary 23
    {12002, 0, 13, 1},              // boundary 24
    {12502, 0, 6, 1},               // boundary 25
    {13002, 0, 7, 1},               // boundary 26
    {13502, 0, 8, 1},               // boundary 27
    {14002, 0, 9, 1},               // boundary 28
    {14502, 0, 10, 1},              // boundary 29
    {15002, 0, 7, 1},               // boundary 30
    {15502, 0, 8, 1},               // boundary 31
    {16002, 0, 11, 1},              // boundary 32
    {16502, 0, 14, 1},              // boundary 33
    {17002, 0, 7, 1},               // boundary 34
    {17502, 0, 8, 1},               // boundary 35
    {18002, 0, 9, 1},               // boundary 36
    {18502, 0, 10, 1},              // boundary 37
    {19002, 0, 7, 1},               // boundary 38
    {19502, 0, 8, 1},               // boundary 39
    {20002, 0, 15, 1},              // boundary 40
    {20502, 0, 6, 1},               // boundary 41
    {21002, 0, 7, 1},               // boundary 42
    {21502, 0, 8, 1},               // boundary 43
    {22002, 0, 9, 1},               // boundary 44
    {22502, 0, 10, 1},              // boundary 45
    {23002, 0, 7, 1},               // boundary 46
    {23502, 0, 8, 1},               // boundary 47
    {24002, 0, 11, 1},              // boundary 48
    {24502, 0, 12, 1},              // boundary 49
    {25002, 0, 7, 1},               // boundary 50
    {25502, 0, 8, 1},               // boundary 51
    {26002, 0, 9, 1},               // boundary 52
    {26502, 0, 10, 1},              // boundary 53
    {27002, 0, 7, 1},               // boundary 54
    {27502, 0, 8, 1},               // boundary 55
    {28002, 0, 13, 1},              // boundary 56
    {28502, 0, 16, 1},              // boundary 57
    {29002, 0, 17, 1},              // boundary 58
    {29502, 0, 16, 1},              // boundary 59
    {30002, 0, 18, 1},              // boundary 60
    {30502, 0, 16, 1},              // boundary 61
    {31002, 0, 17, 1},              // boundary 62
    {31502, 0, 16, 1},              // boundary 63
    {32002, 0, 19, 1},              // boundary 64
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

// class_c.nsl:11: pixels start = (8 * x + 16 * y) % (N - len + 1)
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

void load_r12() {
    scamp5_kernel_begin();
        SET(R0);
        CLR(R12);
    scamp5_kernel_end();
    load_image("class_c.R12.bmp", R12);
}

void load_r1() {
    scamp5_kernel_begin();
        CLR(R1);
    scamp5_kernel_end();
    load_image("class_c.R1.bmp", R1);
}

void load_r2() {
    scamp5_kernel_begin();
        CLR(R2);
    scamp5_kernel_end();
    load_image("class_c.R2.bmp", R2);
}

void load_r3() {
    scamp5_kernel_begin();
        CLR(R3);
    scamp5_kernel_end();
    load_image("class_c.R3.bmp", R3);
}

void load_r4() {
    scamp5_kernel_begin();
        CLR(R4);
    scamp5_kernel_end();
    load_image("class_c.R4.bmp", R4);
}

void load_r5() {
    scamp5_kernel_begin();
        CLR(R5);
    scamp5_kernel_end();
    load_image("class_c.R5.bmp", R5);
}

void load_r6() {
    scamp5_kernel_begin();
        CLR(R6);
    scamp5_kernel_end();
    load_image("class_c.R6.bmp", R6);
}

void load_r7() {
    scamp5_kernel_begin();
        CLR(R7);
    scamp5_kernel_end();
    load_image("class_c.R7.bmp", R7);
}

void load_r8() {
    scamp5_kernel_begin();
        CLR(R8);
    scamp5_kernel_end();
    load_image("class_c.R8.bmp", R8);
}

void load_r9() {
    scamp5_kernel_begin();
        CLR(R9);
    scamp5_kernel_end();
    load_image("class_c.R9.bmp", R9);
}

void load_r10() {
    scamp5_kernel_begin();
        CLR(R10);
    scamp5_kernel_end();
    load_image("class_c.R10.bmp", R10);
}

void load_r11() {
    scamp5_kernel_begin();
        CLR(R11);
    scamp5_kernel_end();
    load_image("class_c.R11.bmp", R11);
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
        scamp5_kernel_end();
        scamp5_output_image(A, display_0);
    }
}
