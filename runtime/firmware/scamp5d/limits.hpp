// What the loader has room for on the SCAMP-5d's microcontroller (README.md adds it up).
#ifndef NSCC_LIMITS_HPP
#define NSCC_LIMITS_HPP

#include <cstddef>
#include <cstdint>

// What is too large for a core's own memory lies in the one that the cores share (*.ld).
#define NSCC_SHARED_RAM [[gnu::section(".bss.shared")]]

namespace nscc::limits {

constexpr char firmware[] = "nscc-loader 2 (SCAMP-5d)";
constexpr uint32_t most_kernels = 256;
constexpr uint32_t most_rows = 1024;
constexpr uint32_t most_runs = 64;
constexpr uint32_t most_frame = 7u << 16;       // seven readouts of 256 x 256 codes
constexpr uint32_t most_kept = 8192;            // bytes of a frame, until the host has them
constexpr uint32_t window = 4096;               // no more than the port's own buffer takes
constexpr size_t most_out = 2304;               // two packets
constexpr uint32_t ticks_per_us = 1;
constexpr bool exact = false;
constexpr bool gains = false;

}  // namespace nscc::limits

#endif
