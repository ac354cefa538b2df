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
// words      195 stored in 20 kernels, 694 a frame; 39 more load the codes and prepare readout
// time       waits fill the slots after the words, at 0.2 us an analog word, 0.1 us a digital one
//            and 1 us a launch; they are whole microseconds, rounded up so that no slot is too
//            short, which makes a frame 41 us longer
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

namespace {

// Runs a constant table, be scamp5_kernel(table, n) a function that runs it or an object that runs
// when it is called.
struct Run {};
template <class Kernel>
auto operator,(Kernel &&kernel, Run) -> decltype(kernel()) {
    return kernel();
}

// 8 words, 2.6 us; launched at boundary 0
// writes A: class_c.nsl:9: open when start <= n < start + len
void k0() {
    scamp5_kernel_begin();
        all();                              // all
        res(A);                             // bus NEWS; bus A, NEWS
        respix(B);                          // rpix; rpix; nop; bus NEWS, PIX; bus B, NEWS
    scamp5_kernel_end();
}

// 4 words, 1.6 us; launched at boundary 1
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k1_words[][5] = {
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k1() { scamp5_kernel(k1_words, 4), Run(); }

// 6 words, 1.8 us; launched at boundary 2..6/2
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k2_words[][5] = {
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k2() { scamp5_kernel(k2_words, 6), Run(); }

// 6 words, 1.8 us; launched at boundary 3,7
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k3_words[][5] = {
    {0x80000, 0x10000, 0x20080, 0x32400, 0x40000},  // NOR.read R8
    {0x80000, 0x10000, 0x20000, 0x30408, 0x40000},  // NOR.write R8
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k3() { scamp5_kernel(k3_words, 6), Run(); }

// 6 words, 1.8 us; launched at boundary 5
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k4_words[][5] = {
    {0x80000, 0x10000, 0x20100, 0x32400, 0x40000},  // NOR.read R9
    {0x80000, 0x10000, 0x20000, 0x30410, 0x40000},  // NOR.write R9
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k4() { scamp5_kernel(k4_words, 6), Run(); }

// 10 words, 2.4 us; launched at boundary 8
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k5_words[][5] = {
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k5() { scamp5_kernel(k5_words, 10), Run(); }

// 12 words, 2.6 us; launched at boundary 9..41/16
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k6_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20200, 0x32400, 0x40000},  // NOR.read R10
    {0x80000, 0x10000, 0x20000, 0x30420, 0x40000},  // NOR.write R10
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k6() { scamp5_kernel(k6_words, 12), Run(); }

// 12 words, 2.6 us; launched at boundary 10..54/4
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k7_words[][5] = {
    {0x80000, 0x10000, 0x20002, 0x32400, 0x40000},  // NOR.read R2
    {0x80000, 0x10000, 0x22000, 0x30400, 0x40000},  // NOR.write R2
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k7() { scamp5_kernel(k7_words, 12), Run(); }

// 12 words, 2.6 us; launched at boundary 11..55/4
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k8_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20080, 0x32400, 0x40000},  // NOR.read R8
    {0x80000, 0x10000, 0x20000, 0x30408, 0x40000},  // NOR.write R8
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k8() { scamp5_kernel(k8_words, 12), Run(); }

// 12 words, 2.6 us; launched at boundary 12..52/8
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k9_words[][5] = {
    {0x80000, 0x10000, 0x20004, 0x32400, 0x40000},  // NOR.read R3
    {0x80000, 0x10000, 0x24000, 0x30400, 0x40000},  // NOR.write R3
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k9() { scamp5_kernel(k9_words, 12), Run(); }

// 12 words, 2.6 us; launched at boundary 13..53/8
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k10_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20100, 0x32400, 0x40000},  // NOR.read R9
    {0x80000, 0x10000, 0x20000, 0x30410, 0x40000},  // NOR.write R9
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k10() { scamp5_kernel(k10_words, 12), Run(); }

// 12 words, 2.6 us; launched at boundary 16..48/16
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k11_words[][5] = {
    {0x80000, 0x10000, 0x20008, 0x32400, 0x40000},  // NOR.read R4
    {0x80000, 0x10000, 0x28000, 0x30400, 0x40000},  // NOR.write R4
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k11() { scamp5_kernel(k11_words, 12), Run(); }

// 13 words, 2.7 us; launched at boundary 17,49
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k12_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80020, 0x10000, 0x20000, 0x31100, 0x40000},  // SET R0
    {0x80000, 0x10000, 0x20800, 0x32400, 0x40000},  // NOR.read R12
    {0x80000, 0x10000, 0x20000, 0x30480, 0x40000},  // NOR.write R12
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k12() { scamp5_kernel(k12_words, 13), Run(); }

// 12 words, 2.6 us; launched at boundary 24,56
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k13_words[][5] = {
    {0x80000, 0x10000, 0x20010, 0x32400, 0x40000},  // NOR.read R5
    {0x80000, 0x10000, 0x20000, 0x30401, 0x40000},  // NOR.write R5
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k13() { scamp5_kernel(k13_words, 12), Run(); }

// 12 words, 2.6 us; launched at boundary 33
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k14_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20400, 0x32400, 0x40000},  // NOR.read R11
    {0x80000, 0x10000, 0x20000, 0x30440, 0x40000},  // NOR.write R11
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k14() { scamp5_kernel(k14_words, 12), Run(); }

// 12 words, 2.6 us; launched at boundary 40
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k15_words[][5] = {
    {0x80000, 0x10000, 0x20020, 0x32400, 0x40000},  // NOR.read R6
    {0x80000, 0x10000, 0x20000, 0x30402, 0x40000},  // NOR.write R6
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
    {0x80000, 0x10000, 0x20040, 0x32400, 0x40000},  // NOR.read R7
    {0x80000, 0x10000, 0x20000, 0x30404, 0x40000},  // NOR.write R7
    {0x80020, 0x10000, 0x20fc0, 0x3b500, 0x40000},  // NOR R0, R7, R8, R9, R10, R11, R12
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00400, 0x10161, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, B
    {0x02402, 0x10120, 0x20000, 0x30000, 0x40000},  // bus A, NEWS, PIX
};
void k15() { scamp5_kernel(k15_words, 12), Run(); }

// 6 words, 1.8 us; launched at boundary 57..63/2
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k16_words[][5] = {
    {0x80000, 0x10000, 0x20001, 0x32400, 0x40000},  // NOR.read R1
    {0x80000, 0x10000, 0x21000, 0x30400, 0x40000},  // NOR.write R1
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k16() { scamp5_kernel(k16_words, 6), Run(); }

// 6 words, 1.8 us; launched at boundary 58,62
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k17_words[][5] = {
    {0x80000, 0x10000, 0x20002, 0x32400, 0x40000},  // NOR.read R2
    {0x80000, 0x10000, 0x22000, 0x30400, 0x40000},  // NOR.write R2
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k17() { scamp5_kernel(k17_words, 6), Run(); }

// 6 words, 1.8 us; launched at boundary 60
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k18_words[][5] = {
    {0x80000, 0x10000, 0x20004, 0x32400, 0x40000},  // NOR.read R3
    {0x80000, 0x10000, 0x24000, 0x30400, 0x40000},  // NOR.write R3
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
    {0x80800, 0x10010, 0x20000, 0x32200, 0x40000},  // WHERE R0
    {0x00402, 0x10121, 0x20000, 0x30000, 0x40000},  // bus NEWS, A, PIX
    {0x02400, 0x10160, 0x20000, 0x30000, 0x40000},  // bus A, B, NEWS
};
void k18() { scamp5_kernel(k18_words, 6), Run(); }

// 16 words, 2.8 us; launched at boundary 64
// writes A: class_c.nsl:9: open when start <= n < start + len
const uint32_t k19_words[][5] = {
    {0x80000, 0x10000, 0x20008, 0x32400, 0x40000},  // NOR.read R4
    {0x80000, 0x10000, 0x28000, 0x30400, 0x40000},  // NOR.write R4
    {0x80020, 0x10000, 0x2003f, 0x3b500, 0x40000},  // NOR R0, R1, R2, R3, R4, R5, R6
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
void k19() { scamp5_kernel(k19_words, 16), Run(); }

// class_c.nsl:5: frame 64 slots of 500us
void (*const kernels[])() = {
    k0, k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11,
    k12, k13, k14, k15, k16, k17, k18, k19,
};

struct Step {
    uint32_t wait_us;               // for the rest of the slots before
    uint16_t kernel;                // then this one of `kernels` runs,
    uint16_t times;                 // so many times over
};

const Step schedule[] = {
    {0, 0, 1},                      // boundary 0
    {500, 1, 1},                    // boundary 1
    {499, 2, 1},                    // boundary 2
    {499, 3, 1},                    // boundary 3
    {499, 2, 1},                    // boundary 4
    {499, 4, 1},                    // boundary 5
    {499, 2, 1},                    // boundary 6
    {499, 3, 1},                    // boundary 7
    {499, 5, 1},                    // boundary 8
    {498, 6, 1},                    // boundary 9
    {498, 7, 1},                    // boundary 10
    {498, 8, 1},                    // boundary 11
    {498, 9, 1},                    // boundary 12
    {498, 10, 1},                   // boundary 13
    {498, 7, 1},                    // boundary 14
    {498, 8, 1},                    // boundary 15
    {498, 11, 1},                   // boundary 16
    {498, 12, 1},                   // boundary 17
    {498, 7, 1},                    // boundary 18
    {498, 8, 1},                    // boundary 19
    {498, 9, 1},                    // boundary 20
    {498, 10, 1},                   // boundary 21
    {498, 7, 1},                    // boundary 22
    {498, 8, 1},                    // boundary 23
    {498, 13, 1},                   // boundary 24
    {498, 6, 1},                    // boundary 25
    {498, 7, 1},                    // boundary 26
    {498, 8, 1},                    // boundary 27
    {498, 9, 1},                    // boundary 28
    {498, 10, 1},                   // boundary 29
    {498, 7, 1},                    // boundary 30
    {498, 8, 1},                    // boundary 31
    {498, 11, 1},                   // boundary 32
    {498, 14, 1},                   // boundary 33
    {498, 7, 1},                    // boundary 34
    {498, 8, 1},                    // boundary 35
    {498, 9, 1},                    // boundary 36
    {498, 10, 1},                   // boundary 37
    {498, 7, 1},                    // boundary 38
    {498, 8, 1},                    // boundary 39
    {498, 15, 1},                   // boundary 40
    {498, 6, 1},                    // boundary 41
    {498, 7, 1},                    // boundary 42
    {498, 8, 1},                    // boundary 43
    {498, 9, 1},                    // boundary 44
    {498, 10, 1},                   // boundary 45
    {498, 7, 1},                    // boundary 46
    {498, 8, 1},                    // boundary 47
    {498, 11, 1},                   // boundary 48
    {498, 12, 1},                   // boundary 49
    {498, 7, 1},                    // boundary 50
    {498, 8, 1},                    // boundary 51
    {498, 9, 1},                    // boundary 52
    {498, 10, 1},                   // boundary 53
    {498, 7, 1},                    // boundary 54
    {498, 8, 1},                    // boundary 55
    {498, 13, 1},                   // boundary 56
    {498, 16, 1},                   // boundary 57
    {499, 17, 1},                   // boundary 58
    {499, 16, 1},                   // boundary 59
    {499, 18, 1},                   // boundary 60
    {499, 16, 1},                   // boundary 61
    {499, 17, 1},                   // boundary 62
    {499, 16, 1},                   // boundary 63
    {499, 19, 1},                   // boundary 64
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

    // A kernel is recorded when it first runs, which takes time: here, where none is lost.
    for (void (*kernel)() : kernels) {
        kernel();
    }

    // While images are awaited, codes are refreshed at this rate.
    vs_configure_frame_trigger(VS_FRAME_TRIGGER_CONST_LOOP, 3);
    load_codes();

    // Faster than frames can be, so that none waits for the next: codes fade meanwhile.
    vs_configure_frame_trigger(VS_FRAME_TRIGGER_CONST_LOOP, 21);
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
