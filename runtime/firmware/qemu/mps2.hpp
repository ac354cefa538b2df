// Arm's MPS2 board as QEMU has it: two serial ports, a timer of 25 MHz and a watchdog, by the
// registers of Arm's CMSDK (DDI 0479).
#ifndef NSCC_MPS2_HPP
#define NSCC_MPS2_HPP

#include <cstdint>

namespace nscc::mps2 {

inline volatile uint32_t &at(uint32_t address) {
    return *reinterpret_cast<volatile uint32_t *>(address);
}

class Uart {
public:
    explicit constexpr Uart(uint32_t base) : base_(base) {}
    void open() const {
        at(base_ + 0x10) = 16;
        at(base_ + 0x08) = 3;
    }
    bool has_byte() const { return (at(base_ + 0x04) & 2) != 0; }
    bool has_room() const { return (at(base_ + 0x04) & 1) == 0; }
    uint8_t get() const { return uint8_t(at(base_)); }
    void put(uint8_t byte) const { at(base_) = byte; }

private:
    uint32_t base_;
};

constexpr Uart line(0x40004000), records(0x40005000);

// Counts up, 25 times a microsecond.
inline uint32_t ticks() { return ~at(0x40000004); }

// Ports and timer work from here on.
void power_on();
void feed_watchdog();

}  // namespace nscc::mps2

#endif
