// What the SCAMP-5d's public names leave open: the serial port's bytes, a clock, and an analog
// register read into memory. Whoever has the devkit supplies these four functions (README.md).
#ifndef NSCC_PORT_HPP
#define NSCC_PORT_HPP

#include <cstddef>
#include <cstdint>

#include <scamp5.hpp>

namespace nscc {

// Bytes that have arrived, at most `room`: how many. Does not wait. Between two calls the port
// has to keep at least limits::window bytes.
size_t port_read(uint8_t *data, size_t room);

// Sends bytes; how many were taken. Does not wait.
size_t port_write(const uint8_t *data, size_t count);

// Microseconds since power on.
uint64_t port_micros();

// Has the chip start anew unless it is called again within four seconds. The main loop calls it,
// and nothing else does.
void port_feed_watchdog();

// Converts a column of an analog register from the top, a byte a pixel: the converter's code.
// Columns count from the left. False where it cannot.
bool port_scan(const areg_t &reg, uint32_t column, uint8_t *codes);

// Reads so many rows of a digital register from `row` on, from the left, a bit a pixel, the first
// one in the lowest bit. False where it cannot.
bool port_scan_bits(const dreg_t &reg, uint32_t row, uint32_t rows, uint8_t *bits);

}  // namespace nscc

#endif
