// A stand-in for the SCAMP-5d devkit's library, for programs that nscc writes: with __LPC43XX__ for
// the chip, without it for the devkit's simulator.
//
// It has the calls that such programs make, with their public forms, and draws no picture: it prints
// what the program does, one event a line, and ends it after two frames. Words are put together
// from the chip's control lines, by themselves and not by nscc's table.
//
//   kernel ID HEX...        the words of a kernel (five integers each), before its first launch
//   launch ID NS            in STEPS NS             loop
//   trigger MODE RATE       display NAME ROW COL SIZE
//   pattern REG R C RX CX   draw REG R C R C ...    request FILE BITS
//   output REG DISPLAY      integrate NUM DEN       wait US
//   scan REG COL            scan_bits REG ROW       post TEXT
//
// NS is the time on a clock that words, launches, waits and looks at it move on: as long as they
// should take, and some more that is different each time.
//
// With DEVKIT_STUB_TABLE_FUNCTION, scamp5_kernel(table, n) is a function that launches a table;
// without it, an object that launches it when called.

#ifndef DEVKIT_STUB_SCAMP5_HPP
#define DEVKIT_STUB_SCAMP5_HPP

#include <poll.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <map>
#include <vector>

// Registers ------------------------------------------------------------------------------------

struct aref_t {
    const char *name;
    int read, also;
    aref_t(const char *name, int read, int also = -1) : name(name), read(read), also(also) {}
};

struct areg_t : aref_t {
    int write;
    areg_t(const char *name, int read, int write, int also = -1)
        : aref_t(name, read, also), write(write) {}
};

struct dref_t {
    const char *name;
    int read;
    dref_t(const char *name, int read) : name(name), read(read) {}
};

struct dreg_t : dref_t {
    int write;
    dreg_t(const char *name, int read, int write) : dref_t(name, read), write(write) {}
};

namespace SCAMP5_PE {
static const areg_t A("A", 21, 13), B("B", 22, 14), C("C", 23, 15), NEWS("NEWS", 24, 16, 10),
    D("D", 25, 17), E("E", 26, 18), F("F", 27, 19);
static const areg_t XN("XN", 24, 16, 7), XE("XE", 24, 16, 9), XS("XS", 24, 16, 12),
    XW("XW", 24, 16, 29);
static const aref_t PIX("PIX", 1), IN("IN", 5);
static const dreg_t R0("R0", 57, 56), R1("R1", 32, 44), R2("R2", 33, 45), R3("R3", 34, 46),
    R4("R4", 35, 47), R5("R5", 36, 48), R6("R6", 37, 49), R7("R7", 38, 50), R8("R8", 39, 51),
    R9("R9", 40, 52), R10("R10", 41, 53), R11("R11", 42, 54), R12("R12", 43, 55);
static const dref_t FLAG("FLAG", 6), SELECT("SELECT", 64);
}  // namespace SCAMP5_PE

// Kernels --------------------------------------------------------------------------------------

namespace devkit_stub {

struct Word {
    uint32_t part[5];
    Word(int clock, std::initializer_list<int> lines) {
        for (int i = 0; i < 5; ++i) {
            part[i] = uint32_t(i) << 16;
        }
        part[0] |= uint32_t(clock) << 19;
        raise(lines);
    }
    void raise(std::initializer_list<int> lines) {
        for (int line : lines) {
            if (line >= 80) {
                part[1 + (line - 80) / 13] |= 1u << (19 + (line - 80) % 13);
            } else if (line >= 0) {
                part[line / 16] |= 1u << line % 16;
            }
        }
    }
};

inline void flush_drawing();

inline uint64_t &now_ns() {
    static uint64_t now = 1;
    return now;
}

// Time passes: so long, and up to `more_ns` on top.
inline void pass(uint64_t ns, uint32_t more_ns) {
    static uint32_t state = 12345;
    state = state * 1664525u + 1013904223u;
    now_ns() += ns + uint64_t(state >> 8) % (more_ns + 1);
}

inline std::vector<Word> *&recording() {
    static std::vector<Word> *words = nullptr;
    return words;
}

inline void push(const Word &word) {
    if (!recording()) {
        std::fprintf(stderr, "a word outside of a kernel\n");
        std::exit(4);
    }
    recording()->push_back(word);
}

inline int next_kernel() {
    static int count = 0;
    return count++;
}

inline void define(int id, const uint32_t (*words)[5], size_t count) {
    std::printf("kernel %d", id);
    for (size_t i = 0; i < count; ++i) {
        for (int k = 0; k < 5; ++k) {
            std::printf(" %x", unsigned(words[i][k]));
        }
    }
    std::printf("\n");
}

class Kernel {
    std::vector<Word> words;
    int id = -1;
    const uint32_t (*table)[5] = nullptr;
    size_t count = 0;

public:
    Kernel() {}
    Kernel(const uint32_t (*icw)[5], size_t n) : table(icw), count(n) {}

    bool begin() {
        if (id >= 0) {
            return false;
        }
        if (recording()) {
            std::fprintf(stderr, "a kernel inside a kernel\n");
            std::exit(4);
        }
        recording() = &words;
        return true;
    }

    void end() {
        recording() = nullptr;
    }

    void operator()() {
        flush_drawing();
        if (id < 0) {
            if (table) {
                static std::map<const void *, int> known;
                const auto found = known.find(table);
                id = found != known.end() ? found->second : next_kernel();
                if (found == known.end()) {
                    known[table] = id;
                    define(id, table, count);
                }
            } else {
                id = next_kernel();
                std::vector<uint32_t> flat;
                for (const Word &word : words) {
                    flat.insert(flat.end(), word.part, word.part + 5);
                }
                define(id, reinterpret_cast<const uint32_t (*)[5]>(flat.data()), words.size());
            }
        }
        std::printf("launch %d %llu\n", id, (unsigned long long)now_ns());
        pass(1000, 900);
        for (size_t i = 0; i < (table ? count : words.size()); ++i) {
            const uint32_t first = table ? table[i][0] : words[i].part[0];
            pass((first >> 19 & 7) == 0 ? 200 : 100, 20);
        }
    }
};

}  // namespace devkit_stub

#ifndef __LPC43XX__

// The simulator runs calls one by one, and has no tables.
inline void scamp5_kernel_begin() {
    static std::vector<devkit_stub::Word> words;
    words.clear();
    devkit_stub::recording() = &words;
}

inline void scamp5_kernel_end() {
    static std::map<std::vector<uint32_t>, int> known;
    std::vector<uint32_t> flat;
    for (const devkit_stub::Word &word : *devkit_stub::recording()) {
        flat.insert(flat.end(), word.part, word.part + 5);
    }
    devkit_stub::recording() = nullptr;
    devkit_stub::flush_drawing();
    if (!known.count(flat)) {
        const int id = known[flat] = devkit_stub::next_kernel();
        devkit_stub::define(id, reinterpret_cast<const uint32_t (*)[5]>(flat.data()),
                            flat.size() / 5);
    }
    std::printf("launch %d %llu\n", known[flat], (unsigned long long)devkit_stub::now_ns());
}

namespace vs_sim {
inline void pix_integrate(uint16_t increment_num, uint16_t increment_den) {
    std::printf("integrate %u %u\n", increment_num, increment_den);
}
}  // namespace vs_sim

#else

#ifdef DEVKIT_STUB_TABLE_FUNCTION
inline void scamp5_kernel(const uint32_t (*icw)[5], size_t n) {
    devkit_stub::Kernel(icw, n)();
}
#else
class scamp5_kernel : public devkit_stub::Kernel {
public:
    scamp5_kernel() {}
    scamp5_kernel(const uint32_t (*icw)[5], size_t n) : devkit_stub::Kernel(icw, n) {}
};
#endif

#define scamp5_kernel_begin()                      \
    {                                              \
        using namespace SCAMP5_PE;                 \
        using namespace scamp5_kernel_api;         \
        static devkit_stub::Kernel devkit_kernel;  \
        if (devkit_kernel.begin()) {
#define scamp5_kernel_end()                        \
            devkit_kernel.end();                   \
        }                                          \
        devkit_kernel();                           \
    }

#endif

namespace scamp5_kernel_api {

using devkit_stub::push;
using devkit_stub::Word;

inline void allow_highspeed(bool) {}

// Analog words.
inline void nop() { push(Word(0, {})); }
inline void rpix() { push(Word(0, {2, 1})); }
inline void all() { push(Word(0, {28, 61, 11})); }

// A destination is selected, too.
inline void devkit_bus(std::initializer_list<const areg_t *> to,
                       std::initializer_list<const aref_t *> from) {
    Word word(0, {});
    for (const areg_t *a : to) {
        word.raise({a->read, a->also, a->write});
    }
    for (const aref_t *a : from) {
        word.raise({a->read, a->also});
    }
    push(word);
}
inline void bus(const areg_t &a) { devkit_bus({&a}, {}); }
inline void bus(const areg_t &a, const aref_t &a0) { devkit_bus({&a}, {&a0}); }
inline void bus(const areg_t &a, const aref_t &a0, const aref_t &a1) {
    devkit_bus({&a}, {&a0, &a1});
}
inline void bus(const areg_t &a, const aref_t &a0, const aref_t &a1, const aref_t &a2) {
    devkit_bus({&a}, {&a0, &a1, &a2});
}
inline void bus(const areg_t &a, const aref_t &a0, const aref_t &a1, const aref_t &a2,
                const aref_t &a3) {
    devkit_bus({&a}, {&a0, &a1, &a2, &a3});
}
inline void bus2(const areg_t &a, const areg_t &b) { devkit_bus({&a, &b}, {}); }
inline void bus2(const areg_t &a, const areg_t &b, const aref_t &a0) {
    devkit_bus({&a, &b}, {&a0});
}
inline void bus2(const areg_t &a, const areg_t &b, const aref_t &a0, const aref_t &a1) {
    devkit_bus({&a, &b}, {&a0, &a1});
}
inline void bus3(const areg_t &a, const areg_t &b, const areg_t &c, const aref_t &a0) {
    devkit_bus({&a, &b, &c}, {&a0});
}
inline void where(const aref_t &a0) { push(Word(0, {20, a0.read, a0.also})); }
inline void where(const aref_t &a0, const aref_t &a1) {
    push(Word(0, {20, a0.read, a0.also, a1.read, a1.also}));
}
inline void where(const aref_t &a0, const aref_t &a1, const aref_t &a2) {
    push(Word(0, {20, a0.read, a0.also, a1.read, a1.also, a2.read, a2.also}));
}

// Digital words.
inline void WHERE(const dref_t &d) { push(Word(1, {20, 61, 11, d.read})); }
inline void WHERE(const dref_t &d, const dref_t &e) { push(Word(1, {20, 61, 11, d.read, e.read})); }
inline void WHERE(const dref_t &d, const dref_t &e, const dref_t &f) {
    push(Word(1, {20, 61, 11, d.read, e.read, f.read}));
}

inline void devkit_digital(std::initializer_list<int> lines, std::initializer_list<int> operands) {
    Word word(1, lines);
    word.raise(operands);
    push(word);
}
inline void devkit_set(std::initializer_list<int> operands) { devkit_digital({5, 60}, operands); }
inline void devkit_copy(std::initializer_list<int> operands) {
    devkit_digital({5, 61, 62, 63}, operands);
}
inline void devkit_invert(std::initializer_list<int> operands) {
    devkit_digital({5, 60, 61, 58, 63}, operands);
}
inline void DNEWS0(const dreg_t &d, const dref_t &d0) {
    Word word(2, {5, 11, 31, 59, 61, 62});
    word.raise({d.write, d0.read});
    push(word);
}
inline void DNEWS1(const dreg_t &d, const dref_t &d0) {
    Word word(2, {5, 11, 30, 31, 59, 61, 62});
    word.raise({d.write, d0.read});
    push(word);
}
inline void SET(const dreg_t &a) { devkit_set({a.write}); }
inline void SET(const dreg_t &a, const dreg_t &b) { devkit_set({a.write, b.write}); }
inline void SET(const dreg_t &a, const dreg_t &b, const dreg_t &c) {
    devkit_set({a.write, b.write, c.write});
}
inline void SET(const dreg_t &a, const dreg_t &b, const dreg_t &c, const dreg_t &d) {
    devkit_set({a.write, b.write, c.write, d.write});
}
inline void CLR(const dreg_t &a) { devkit_copy({a.write}); }
inline void CLR(const dreg_t &a, const dreg_t &b) { devkit_copy({a.write, b.write}); }
inline void CLR(const dreg_t &a, const dreg_t &b, const dreg_t &c) {
    devkit_copy({a.write, b.write, c.write});
}
inline void CLR(const dreg_t &a, const dreg_t &b, const dreg_t &c, const dreg_t &d) {
    devkit_copy({a.write, b.write, c.write, d.write});
}
inline void MOV(const dreg_t &d, const dref_t &a) { devkit_copy({d.write, a.read}); }
inline void OR(const dreg_t &d, const dref_t &a, const dref_t &b) {
    devkit_copy({d.write, a.read, b.read});
}
inline void OR(const dreg_t &d, const dref_t &a, const dref_t &b, const dref_t &c) {
    devkit_copy({d.write, a.read, b.read, c.read});
}
inline void OR(const dreg_t &d, const dref_t &a, const dref_t &b, const dref_t &c,
               const dref_t &e) {
    devkit_copy({d.write, a.read, b.read, c.read, e.read});
}
inline void NOT(const dreg_t &d, const dref_t &a) { devkit_invert({d.write, a.read}); }
inline void NOR(const dreg_t &d, const dref_t &a, const dref_t &b) {
    devkit_invert({d.write, a.read, b.read});
}
inline void NOR(const dreg_t &d, const dref_t &a, const dref_t &b, const dref_t &c) {
    devkit_invert({d.write, a.read, b.read, c.read});
}
inline void NOR(const dreg_t &d, const dref_t &a, const dref_t &b, const dref_t &c,
                const dref_t &e) {
    devkit_invert({d.write, a.read, b.read, c.read, e.read});
}

// In place: a word that reads and a word that writes.
inline void REFRESH(const dreg_t &d) {
    devkit_digital({5, 61, 62, 63}, {d.read});
    devkit_digital({5, 62, 63}, {d.write});
}
inline void NOT(const dreg_t &d) {
    devkit_digital({61, 58}, {d.read});
    devkit_digital({58}, {d.write});
}
inline void NOR(const dreg_t &d, const dref_t &a) {
    devkit_digital({61, 58}, {d.read, a.read});
    devkit_digital({58}, {d.write});
}
inline void OR(const dreg_t &d, const dref_t &a) {
    devkit_digital({61, 62, 63}, {d.read, a.read});
    devkit_digital({62, 63}, {d.write});
}

// Macros.
using SCAMP5_PE::NEWS;
using SCAMP5_PE::PIX;
using SCAMP5_PE::R0;
using SCAMP5_PE::R12;

inline void res(const areg_t &a) { bus(NEWS), bus(a, NEWS); }
inline void res(const areg_t &a, const areg_t &b) { res(a), bus(b, NEWS); }
inline void mov(const areg_t &y, const aref_t &x) { bus(NEWS, x), bus(y, NEWS); }
inline void add(const areg_t &y, const aref_t &a, const aref_t &b) { bus(NEWS, a, b), bus(y, NEWS); }
inline void add(const areg_t &y, const aref_t &a, const aref_t &b, const aref_t &c) {
    bus(NEWS, a, b, c), bus(y, NEWS);
}
inline void sub(const areg_t &y, const aref_t &a, const aref_t &b) { bus(NEWS, a), bus(y, NEWS, b); }
inline void neg(const areg_t &y, const aref_t &x) { bus(NEWS), bus(y, NEWS, x); }
inline void abs(const areg_t &y, const aref_t &x) {
    neg(y, x), bus(NEWS, x), where(x), bus(y, NEWS), all();
}
inline void div(const areg_t &a, const areg_t &b, const areg_t &c, const aref_t &x) {
    bus2(a, b, x), bus(NEWS, x, b), bus(c, NEWS, a), bus2(a, b, c), bus(a, b);
}
inline void diva(const areg_t &a, const areg_t &b, const areg_t &c) {
    bus2(b, c, a), bus(NEWS, b, a), bus(a, NEWS, c), bus2(b, c, a), bus(a, b);
}
inline void respix() { rpix(), rpix(), nop(); }
inline void respix(const areg_t &y) { respix(), bus(NEWS, PIX), bus(y, NEWS); }
inline void get_image(const areg_t &y) { bus(NEWS, PIX), respix(), bus(y, NEWS, PIX); }
inline void get_image(const areg_t &y, const areg_t &h) {
    bus(NEWS, PIX), bus(h, PIX), respix(), bus(y, h, NEWS, PIX);
}
inline void getpix(const areg_t &y, const aref_t &r) { bus(NEWS, PIX), bus(y, NEWS, r); }
inline void getpix(const areg_t &y, const areg_t &h, const aref_t &r) {
    bus(h, PIX), bus(NEWS, PIX), bus(y, h, NEWS, r);
}
inline void AND(const dreg_t &a, const dref_t &x, const dref_t &y) {
    SET(R0), NOT(R12, x), NOT(R0, y), NOR(a, R0, R12);
}
inline void NAND(const dreg_t &a, const dref_t &x, const dref_t &y) {
    SET(R0), NOT(R12, x), NOT(R0, y), OR(a, R0, R12);
}
inline void ANDX(const dreg_t &a, const dreg_t &b, const dref_t &x) {
    NOT(R0, b), NOT(b, x), NOR(a, R0, b);
}
inline void NANDX(const dreg_t &a, const dreg_t &b, const dref_t &x) {
    NOT(R0, b), NOT(b, x), OR(a, R0, b);
}
inline void IMP(const dreg_t &l, const dref_t &x, const dref_t &y) { NOT(R0, y), OR(l, x, R0); }
inline void NIMP(const dreg_t &l, const dref_t &x, const dref_t &y) { NOT(R0, y), NOR(l, x, R0); }
inline void CLR_IF(const dreg_t &l, const dref_t &x) { NOT(R0, l), NOR(l, R0, x); }
inline void XORX(const dreg_t &l, const dreg_t &x, const dref_t &y) {
    NOT(R0, y), NOR(l, x, R0), NOT(R0, x), NOR(x, y, R0), OR(l, x);
}
inline void MUX(const dreg_t &l, const dref_t &x, const dref_t &y, const dref_t &z) {
    SET(R0), MOV(R12, z), MOV(R0, x), MOV(R12, y), MOV(l, R12);
}

}  // namespace scamp5_kernel_api

#ifndef __LPC43XX__
using namespace scamp5_kernel_api;
#endif

// Codes ----------------------------------------------------------------------------------------

namespace devkit_stub {

struct Drawing {
    const char *plane = nullptr;
    std::vector<int> pixels;
};

inline Drawing &drawing() {
    static Drawing now;
    return now;
}

inline void flush_drawing() {
    Drawing &now = drawing();
    if (now.plane && !now.pixels.empty()) {
        std::printf("draw %s", now.plane);
        for (int at : now.pixels) {
            std::printf(" %d", at);
        }
        std::printf("\n");
        now.pixels.clear();
    }
}

}  // namespace devkit_stub

inline void scamp5_load_pattern(const dreg_t &d, uint8_t r, uint8_t c, uint8_t rx, uint8_t cx) {
    devkit_stub::flush_drawing();
    std::printf("pattern %s %d %d %d %d\n", d.name, r, c, rx, cx);
}

inline void scamp5_draw_begin(const dreg_t &d) { devkit_stub::drawing().plane = d.name; }

inline void scamp5_draw_pixel(uint8_t r, uint8_t c) {
    if (!devkit_stub::drawing().plane) {
        std::fprintf(stderr, "a pixel outside of a drawing\n");
        std::exit(4);
    }
    devkit_stub::drawing().pixels.push_back(r);
    devkit_stub::drawing().pixels.push_back(c);
}

inline void scamp5_draw_end() {
    devkit_stub::flush_drawing();
    devkit_stub::drawing().plane = nullptr;
}

// Host and frame loop --------------------------------------------------------------------------

class vs_dotmat {
    std::vector<uint8_t> bytes;
    uint16_t width, height;

public:
    vs_dotmat() : width(0), height(0) {}
    vs_dotmat(uint16_t w, uint16_t h) : bytes(size_t(w) * h / 8), width(w), height(h) {}
    uint16_t get_width() const { return width; }
    uint16_t get_height() const { return height; }
    void *get_buffer(size_t *size = nullptr) const {
        if (size) {
            *size = bytes.size();
        }
        return const_cast<uint8_t *>(bytes.data());
    }
    void set(int x, int y) { bytes[(size_t(y) * width + x) / 8] |= uint8_t(1 << x % 8); }
};

typedef uint32_t vs_handle;

enum { VS_FRAME_TRIGGER_CONST_LOOP = 0 };

namespace devkit_stub {

struct Host {
    std::vector<const char *> displays;
    int outputs = 0, loops = 0, deliveries = 0;
    const char *file = nullptr;
    std::function<void(const vs_dotmat &, int)> callback;
};

inline Host &host() {
    static Host now;
    return now;
}

inline uint32_t little(const uint8_t *at) {
    return at[0] | at[1] << 8 | at[2] << 16 | uint32_t(at[3]) << 24;
}

// A picture of 24 bits a pixel, bottom row first: the highest bit of each pixel.
inline bool read_picture(const char *path, vs_dotmat &image) {
    std::FILE *file = std::fopen(path, "rb");
    if (!file) {
        return false;
    }
    std::vector<uint8_t> data;
    for (int ch; (ch = std::fgetc(file)) != EOF;) {
        data.push_back(uint8_t(ch));
    }
    std::fclose(file);
    if (data.size() < 54 || data[0] != 'B' || data[1] != 'M' || data[28] != 24 ||
        little(&data[2]) != data.size()) {
        return false;
    }
    const int width = int(little(&data[18])), height = int(little(&data[22]));
    const size_t start = little(&data[10]), stride = (size_t(width) * 3 + 3) / 4 * 4;
    if (data.size() != start + stride * height || width % 8) {
        return false;
    }
    image = vs_dotmat(uint16_t(width), uint16_t(height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (data[start + (height - 1 - y) * stride + x * 3] & 0x80) {
                image.set(x, y);
            }
        }
    }
    return true;
}

}  // namespace devkit_stub

inline void vs_init() {}

#ifdef __LPC43XX__

// Scans: a column from its top, or rows; register X holds a pattern of its own.
inline void scamp5_scan_areg(const aref_t &a, uint8_t *buffer, uint8_t r0, uint8_t c0, uint8_t r1,
                             uint8_t c1, uint8_t rs, uint8_t cs) {
    std::printf("scan %s %d\n", a.name, 255 - c0);
    for (int col = c0; col <= c1; col += cs) {
        for (int row = r0; row <= r1; row += rs) {
            *buffer++ = uint8_t(3 * row + 5 * (255 - col) + a.name[0]);
        }
    }
}

inline void scamp5_scan_dreg(const dref_t &d, uint8_t *mem, uint8_t r0 = 0, uint8_t r1 = 255) {
    std::printf("scan_bits %s %d\n", d.name, r0);
    for (int row = r0; row <= r1; ++row) {
        for (int byte = 0; byte < 32; ++byte) {
            *mem++ = uint8_t(row == 3 && byte == 0 ? 1 : 0);
        }
    }
}

// The serial port: two pipes, named by the environment.
class vs_io_agent_api {
    size_t got = 0;
    bool waits = false;
    uint8_t *to = nullptr;
    size_t room = 0;

public:
    void send(const void *data, size_t bytes) {
        static const int out = std::atoi(std::getenv("PORT_OUT"));
        for (size_t done = 0; done < bytes;) {
            const ssize_t some = ::write(out, static_cast<const char *>(data) + done, bytes - done);
            if (some <= 0) {
                std::exit(6);
            }
            done += size_t(some);
        }
    }
    bool send_done() { return true; }
    void receive(void *buffer, size_t buffer_size, size_t = 1) {
        to = static_cast<uint8_t *>(buffer);
        room = buffer_size;
        waits = true;
    }
    bool receive_done(size_t *length) {
        static const int in = std::atoi(std::getenv("PORT_IN"));
        std::fflush(stdout);
        pollfd watched = {in, POLLIN, 0};
        if (!waits || poll(&watched, 1, 2) <= 0) {
            return false;
        }
        const ssize_t count = ::read(in, to, room);
        if (count <= 0) {
            std::_Exit(0);
        }
        waits = false;
        *length = size_t(count);
        return true;
    }
};

static vs_io_agent_api devkit_uart;
static vs_io_agent_api *const vs_uart = &devkit_uart;

#endif

class vs_stopwatch {
    uint64_t start;

public:
    vs_stopwatch() : start(devkit_stub::now_ns()) {}
    void reset() { start = devkit_stub::now_ns(); }
    uint32_t get_usec() const {
        devkit_stub::pass(100, 100);
        return uint32_t((devkit_stub::now_ns() - start) / 1000);
    }
};

inline void vs_disable_frame_trigger() {}
inline void vs_vision_chip_rest() { std::printf("rest\n"); }
template <class... Values>
inline void vs_post_text(const char *format, Values... values) {
    std::printf("post ");
    std::printf(format, values...);
}

inline vs_handle vs_gui_add_display(const char *name, uint8_t row, uint8_t col, int size = 1) {
    devkit_stub::host().displays.push_back(name);
    std::printf("display %s %d %d %d\n", name, row, col, size);
    return vs_handle(devkit_stub::host().displays.size() - 1);
}

// A slider goes at once to where DEVKIT_STUB_SLIDERS says, which has a number for each slider.
inline void vs_gui_add_slider(const char *name, int low, int high, int start, int *value) {
    static const char *at = std::getenv("DEVKIT_STUB_SLIDERS");
    std::printf("slider %d %d %d %s\n", low, high, start, name);
    char *end = nullptr;
    const long wanted = at ? std::strtol(at, &end, 10) : start;
    at = at && *end ? end + 1 : nullptr;
    *value = int(wanted);
}

inline void vs_configure_frame_trigger(uint16_t mode, int rate) {
    std::printf("trigger %d %d\n", mode, rate);
}

inline void scamp5_load_in(int8_t value) {
    devkit_stub::flush_drawing();
    std::printf("in %d %llu\n", value, (unsigned long long)devkit_stub::now_ns());
    devkit_stub::pass(2000, 3000);
}

inline void vs_wait(uint32_t usec) {
    devkit_stub::flush_drawing();
    std::printf("wait %lu\n", (unsigned long)usec);
    devkit_stub::pass(uint64_t(usec) * 1000, 9000);
}

// Not zero while another request is waiting: this one is not taken then.
inline int vs_gui_request_image(const char *path, int bits,
                                std::function<void(const vs_dotmat &, int)> callback,
                                uint32_t = 1000) {
    devkit_stub::Host &host = devkit_stub::host();
    std::printf("request %s %d\n", path, bits);
    if (host.file) {
        return 1;
    }
    host.file = path;
    host.callback = callback;
    return 0;
}

// The host is slow: it answers in the third turn, and the first request of all not in time.
inline void vs_frame_loop_control() {
    devkit_stub::Host &host = devkit_stub::host();
    devkit_stub::flush_drawing();
    if (!host.displays.empty() && host.outputs >= 2 * int(host.displays.size())) {
        std::printf("end\n");
        std::exit(0);
    }
    std::printf("loop\n");
    if (!host.file || ++host.loops % 3) {
        return;
    }
    vs_dotmat image;
    const bool there = host.deliveries++ > 0 && devkit_stub::read_picture(host.file, image);
    if (host.deliveries > 100) {
        std::fprintf(stderr, "no image is ever good enough\n");
        std::exit(5);
    }
    const auto callback = host.callback;
    callback(image, there ? 0 : -1);
    host.file = nullptr;
}

inline void scamp5_output_image(const aref_t &a, vs_handle display) {
    ++devkit_stub::host().outputs;
    std::printf("output %s %lu\n", a.name, (unsigned long)display);
}
inline void scamp5_output_image(const dref_t &d, vs_handle display) {
    ++devkit_stub::host().outputs;
    std::printf("output %s %lu\n", d.name, (unsigned long)display);
}

#endif
