// What the loader has room for on the SCAMP-5d: about 115 kB of the microcontroller's memory.
#ifndef NSCC_LIMITS_HPP
#define NSCC_LIMITS_HPP

#include <cstddef>
#include <cstdint>

namespace nscc::limits {

constexpr char firmware[] = "nscc-loader 1 (SCAMP-5d)";
constexpr uint32_t most_kernels = 256;
constexpr uint32_t most_rows = 1024;
constexpr uint32_t most_runs = 64;
constexpr uint32_t most_frame = 1u << 16;       // one readout of 256 x 256 codes
constexpr uint32_t window = 4096;               // no more than the port's own buffer takes
constexpr size_t most_out = 4096;
constexpr bool exact = false;
constexpr bool gains = false;

}  // namespace nscc::limits

#endif
