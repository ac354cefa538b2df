// From power on to main, without a library.

#include "mps2.hpp"

extern "C" {

extern uint32_t _data_load, _data_begin, _data_end, _bss_begin, _bss_end, _shared_begin, _shared_end;
extern uint32_t _stack_end;
extern void (*_init_begin[])();
extern void (*_init_end[])();
int loader_main() asm("main");

[[noreturn]] void stop() {
    while (true) {
    }
}

[[noreturn]] void reset() {
    const uint32_t *from = &_data_load;
    for (uint32_t *to = &_data_begin; to < &_data_end;) {
        *to++ = *from++;
    }
    for (volatile uint32_t *to = &_bss_begin; to < &_bss_end;) {
        *to++ = 0;
    }
    for (volatile uint32_t *to = &_shared_begin; to < &_shared_end;) {
        *to++ = 0;
    }
#ifdef __ARM_ARCH_6M__
    // As on a Cortex-M0, which has no access to words that are not aligned.
    constexpr uint32_t configuration_control = 0xe000ed14, trap_unaligned = 8;
    nscc::mps2::at(configuration_control) = nscc::mps2::at(configuration_control) | trap_unaligned;
#endif
    nscc::mps2::power_on();             // the loader says at once that it has started
    for (void (**begin)() = _init_begin; begin < _init_end;) {
        (*begin++)();
    }
    loader_main();
    stop();
}

using Vector = void (*)();
[[gnu::section(".vectors"), gnu::used]] const Vector vectors[16] = {
    reinterpret_cast<Vector>(&_stack_end), reset, stop, stop, stop, stop, stop};

}

namespace nscc::mps2 {

void power_on() {
    line.open();
    records.open();
    at(0x40000008) = 0xffffffff;
    at(0x40000004) = 0xffffffff;
    at(0x40000000) = 1;
}

// Two periods of two seconds without food start the board anew.
void feed_watchdog() {
    at(0x40008c00) = 0x1acce551;
    at(0x40008000) = 50000000;
    at(0x40008008) = 3;
    at(0x40008c00) = 0;
}

}  // namespace nscc::mps2
