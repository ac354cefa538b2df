// A stand-in for the SCAMP-7 devkit's library: the SCAMP-5d's under other names, with more registers.
#ifndef DEVKIT_STUB_SCAMP7_HPP
#define DEVKIT_STUB_SCAMP7_HPP

#include "scamp5.hpp"

// Their lines are not public: those that nscc gives them.
namespace SCAMP7_PE {
using namespace SCAMP5_PE;
static const dreg_t R13("R13", 80, 81), R14("R14", 82, 83), R15("R15", 84, 85), R16("R16", 86, 87),
    R17("R17", 88, 89), R18("R18", 90, 91), R19("R19", 92, 93), R20("R20", 94, 95),
    R21("R21", 96, 97), R22("R22", 98, 99);
}  // namespace SCAMP7_PE

#define scamp7_kernel_begin() scamp5_kernel_begin()
#define scamp7_kernel_end() scamp5_kernel_end()
#define scamp7_load_in scamp5_load_in
#define scamp7_load_pattern scamp5_load_pattern
#define scamp7_draw_begin scamp5_draw_begin
#define scamp7_draw_pixel scamp5_draw_pixel
#define scamp7_draw_end scamp5_draw_end
#define scamp7_output_image scamp5_output_image

#endif
