// The port and the scans, by public names of the devkit's library.

#include <new>

#include <scamp5.hpp>

#include "limits.hpp"
#include "port.hpp"
#include "scan.hpp"
#include "target.hpp"
#include "watchdog.hpp"

#ifndef NSCC_WATCHDOG
#define NSCC_WATCHDOG 1
#endif

namespace nscc {

namespace {

// The library fills one buffer while the loader takes bytes from the other.
NSCC_SHARED_RAM uint8_t received[2][limits::window / 2];
size_t filling, length, taken;
bool asked;

uint8_t sending[256];
bool sent_before;

// While one of these is there, no interrupt comes.
class InterruptsOff {
public:
#ifdef __arm__
    InterruptsOff() { asm volatile("mrs %0, primask\n\tcpsid i" : "=r"(before_)::"memory"); }
    ~InterruptsOff() { asm volatile("msr primask, %0" ::"r"(before_) : "memory"); }

private:
    uint32_t before_;
#else
    InterruptsOff() {}
    ~InterruptsOff() {}
#endif
};

uint32_t reversed(uint32_t byte) {
    byte = (byte & 0xf0) >> 4 | (byte & 0x0f) << 4;
    byte = (byte & 0xcc) >> 2 | (byte & 0x33) << 2;
    return (byte & 0xaa) >> 1 | (byte & 0x55) << 1;
}

}  // namespace

size_t port_read(uint8_t *data, size_t room) {
    if (taken == length) {
        if (!asked) {
            vs_uart->receive(received[filling], sizeof received[0], 1);
            asked = true;
        }
        size_t count = 0;
        if (!vs_uart->receive_done(&count)) {
            return 0;
        }
        length = count < sizeof received[0] ? count : sizeof received[0];
        taken = 0;
        filling = 1 - filling;
        vs_uart->receive(received[filling], sizeof received[0], 1);
    }
    const uint8_t *from = received[1 - filling];
    size_t some = 0;
    while (some < room && taken < length) {
        data[some++] = from[taken++];
    }
    return some;
}

size_t port_write(const uint8_t *data, size_t count) {
    if (count == 0 || (sent_before && !vs_uart->send_done())) {
        return 0;
    }
    const size_t some = count < sizeof sending ? count : sizeof sending;
    for (size_t i = 0; i < some; ++i) {
        sending[i] = data[i];
    }
    vs_uart->send(sending, some);
    sent_before = true;
    return some;
}

// The library's clock has 32 bits, and is looked at many times an hour.
uint64_t port_micros() {
    // Never destroyed, for the program never ends.
    alignas(vs_stopwatch) static uint8_t room[sizeof(vs_stopwatch)];
    static const vs_stopwatch &clock = *new (room) vs_stopwatch;
    static uint32_t last = 0, rounds = 0;
    const uint32_t now = clock.get_usec();
    rounds += now < last;
    last = now;
    return uint64_t(rounds) << 32 | now;
}

// The first feed starts it. Compiled with -DNSCC_WATCHDOG=0 the chip's watchdog is left alone.
void port_feed_watchdog() {
#if NSCC_WATCHDOG
    auto &watchdog = *reinterpret_cast<WatchdogRegisters *>(watchdog_address);
    if (watchdog.mode == 0) {
        watchdog.constant = watchdog_counts;
        watchdog.mode = 3;
    }
    const InterruptsOff off;
    watchdog.feed = 0xaa;
    watchdog.feed = 0x55;
#endif
}

// Addresses count columns from the right.
bool port_scan(const areg_t &reg, uint32_t column, uint8_t *codes) {
    const uint8_t address = uint8_t(target::cols - 1 - column);
    scamp5_scan_areg(reg, codes, 0, address, uint8_t(target::rows - 1), address, 1, 1);
    return true;
}

// Which end of a row comes first is not public: the right one is assumed, as in addresses, its first
// pixel in the lowest bit. Where states come out mirrored, rows are to be copied as they are.
bool port_scan_bits(const dreg_t &reg, uint32_t row, uint32_t rows, uint8_t *bits) {
    constexpr uint32_t array_bytes = 256 / 8, row_bytes = target::cols / 8;
    uint8_t whole[array_bytes];
    for (uint32_t i = 0; i < rows; ++i) {
        scamp5_scan_dreg(reg, whole, uint8_t(row + i), uint8_t(row + i));
        for (uint32_t byte = 0; byte < row_bytes; ++byte) {
            bits[i * row_bytes + byte] = uint8_t(reversed(whole[row_bytes - 1 - byte]));
        }
    }
    return true;
}

}  // namespace nscc
