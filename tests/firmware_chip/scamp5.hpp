// What the loader needs of the SCAMP-5d devkit's library, by its public signatures, to be linked for
// the chip: no more of it runs anywhere.
#ifndef CHIP_STUB_SCAMP5_HPP
#define CHIP_STUB_SCAMP5_HPP

#include <cstddef>
#include <cstdint>

struct areg_t { uint8_t number; };
struct dreg_t { uint8_t number; };

namespace SCAMP5_PE {
constexpr areg_t A{0}, B{1}, C{2}, D{3}, E{4}, F{5}, NEWS{6};
constexpr dreg_t R0{0}, R1{1}, R2{2}, R3{3}, R4{4}, R5{5}, R6{6}, R7{7}, R8{8}, R9{9}, R10{10},
    R11{11}, R12{12};
}  // namespace SCAMP5_PE

void vs_init();
void vs_disable_frame_trigger();
void vs_frame_loop_control();
void scamp5_kernel(const uint32_t (*icw)[5], size_t count);
void scamp5_load_in(int8_t value);
void scamp5_draw_begin(const dreg_t &reg);
void scamp5_draw_pixel(uint8_t row, uint8_t col);
void scamp5_draw_end();
void scamp5_scan_areg(const areg_t &reg, uint8_t *buffer, uint8_t r0, uint8_t c0, uint8_t r1,
                      uint8_t c1, uint8_t rs, uint8_t cs);
void scamp5_scan_dreg(const dreg_t &reg, uint8_t *mem, uint8_t r0 = 0, uint8_t r1 = 255);

class vs_io_agent_api {
public:
    void send(const void *data, size_t bytes);
    bool send_done();
    void receive(void *buffer, size_t buffer_size, size_t min_size = 1);
    bool receive_done(size_t *length);
};
extern vs_io_agent_api *vs_uart;

class vs_stopwatch {
public:
    vs_stopwatch();
    ~vs_stopwatch();
    uint32_t get_usec() const;

private:
    uint32_t start;
};

#endif
