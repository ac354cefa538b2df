// What the loader has room for on an emulated microcontroller: what it has on the SCAMP-5d's.
#ifndef NSCC_LIMITS_HPP
#define NSCC_LIMITS_HPP

#include <cstddef>
#include <cstdint>

#define NSCC_SHARED_RAM [[gnu::section(".bss.shared")]]

namespace nscc::limits {

constexpr char firmware[] = "nscc-loader 2 (QEMU)";
constexpr uint32_t most_kernels = 256;
constexpr uint32_t most_rows = 1024;
constexpr uint32_t most_runs = 64;
constexpr uint32_t most_frame = 1u << 20;
constexpr uint32_t most_kept = 8192;
constexpr uint32_t window = 4096;
constexpr size_t most_out = 2304;
constexpr uint32_t ticks_per_us = 25;
constexpr bool exact = false;
constexpr bool gains = true;

}  // namespace nscc::limits

#endif
