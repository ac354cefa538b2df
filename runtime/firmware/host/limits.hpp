// What the loader has room for when it runs on a computer.
#ifndef NSCC_LIMITS_HPP
#define NSCC_LIMITS_HPP

#include <cstddef>
#include <cstdint>

namespace nscc::limits {

constexpr char firmware[] = "nscc-loader 2 (host)";
constexpr uint32_t most_kernels = 1024;
constexpr uint32_t most_rows = 16384;
constexpr uint32_t most_runs = 4096;
constexpr uint32_t most_frame = 1u << 23;
constexpr uint32_t most_kept = 1u << 17;        // bytes of a frame, until the host has them
constexpr uint32_t ticks_per_us = 1;
constexpr uint32_t window = 16384;
constexpr size_t most_out = 8192;
constexpr bool exact = true;        // hands out exposures in electrons beside the codes
constexpr bool gains = true;        // multiplies readouts by gains other than 1

}  // namespace nscc::limits

#endif
