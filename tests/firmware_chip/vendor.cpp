// Stands for the devkit's library where the loader is linked for the chip: the memory of its store
// of instruction words, a start, and functions that do nothing.

#include <scamp5.hpp>

// 1024 instruction words.
volatile uint32_t icw_store[1024][5];

extern "C" {
extern uint32_t _data_load, _data_begin, _data_end, _bss_begin, _bss_end, _shared_begin, _shared_end;
extern uint32_t _stack_end;
extern void (*_init_begin[])();
extern void (*_init_end[])();
int loader_main() asm("main");

void reset() {
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
    for (void (**begin)() = _init_begin; begin < _init_end;) {
        (*begin++)();
    }
    loader_main();
}

[[gnu::section(".vectors"), gnu::used]] void *const vectors[] = {
    &_stack_end, reinterpret_cast<void *>(reset)};
}

void vs_init() {}
void vs_disable_frame_trigger() {}
void vs_frame_loop_control() {}
void scamp5_kernel(const uint32_t (*icw)[5], size_t count) {
    for (size_t i = 0; i < count; ++i) {
        icw_store[i][0] = icw[i][0];
    }
}
void scamp5_load_in(int8_t) {}
void scamp5_draw_begin(const dreg_t &) {}
void scamp5_draw_pixel(uint8_t, uint8_t) {}
void scamp5_draw_end() {}

void scamp5_scan_areg(const areg_t &, uint8_t *, uint8_t, uint8_t, uint8_t, uint8_t, uint8_t,
                      uint8_t) {}
void scamp5_scan_dreg(const dreg_t &, uint8_t *, uint8_t, uint8_t) {}

vs_io_agent_api agent;
vs_io_agent_api *vs_uart = &agent;
volatile uint32_t microseconds;

void vs_io_agent_api::send(const void *, size_t) {}
bool vs_io_agent_api::send_done() { return true; }
void vs_io_agent_api::receive(void *, size_t, size_t) {}
bool vs_io_agent_api::receive_done(size_t *) { return false; }
vs_stopwatch::vs_stopwatch() : start(microseconds) {}
vs_stopwatch::~vs_stopwatch() {}
uint32_t vs_stopwatch::get_usec() const { return microseconds - start; }
