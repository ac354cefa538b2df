// What the SCAMP-5d's public names leave open: registers read into memory. Whoever has the devkit
// supplies these two functions (README.md), and those of port.hpp.
#ifndef NSCC_SCAN_HPP
#define NSCC_SCAN_HPP

#include <cstdint>

#include <scamp5.hpp>

namespace nscc {

// Converts a column of an analog register from the top, a byte a pixel: the converter's code.
// Columns count from the left. False where it cannot.
bool port_scan(const areg_t &reg, uint32_t column, uint8_t *codes);

// Reads so many rows of a digital register from `row` on, from the left, a bit a pixel, the first
// one in the lowest bit. False where it cannot.
bool port_scan_bits(const dreg_t &reg, uint32_t row, uint32_t rows, uint8_t *bits);

}  // namespace nscc

#endif
