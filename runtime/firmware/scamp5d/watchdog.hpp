// The LPC4357's watchdog, by its registers as in NXP's user manual (UM10503).
#ifndef NSCC_WATCHDOG_HPP
#define NSCC_WATCHDOG_HPP

#include <cstdint>

namespace nscc {

struct WatchdogRegisters {
    volatile uint32_t mode;         // 1: it runs, until power off; 2: its end starts the chip anew
    volatile uint32_t constant;     // counts from a feed to its end, a quarter of 12 MHz
    volatile uint32_t feed;         // 0xaa and then 0x55, with no other access between them
    volatile uint32_t value;
};

constexpr uintptr_t watchdog_address = 0x40080000;
constexpr uint32_t watchdog_counts = 4 * 3000000;

}  // namespace nscc

#endif
