// The chip below the loader: what a hardware layer has to supply.
#ifndef NSCC_BOARD_HPP
#define NSCC_BOARD_HPP

#include "words.hpp"

namespace nscc {

struct Readout {
    uint8_t reg;                    // place among the target's analog registers
    double gain;
};

// What a frame holds, in this order: the codes of all readouts, their exposures, then the planes of
// digital registers, of those channels that are asked for.
struct Contents {
    const Readout *readouts;
    uint32_t readout_count;
    const uint8_t *states;          // digital registers
    uint32_t state_count;
    uint8_t channels;
};

// Writes the code planes back before they fade; a layer that takes long over a plane calls it.
class Refresher {
public:
    virtual void refresh() = 0;

protected:
    ~Refresher() = default;
};

enum class Exposing : uint8_t { BUSY, DONE, BROKEN };

class Board {
public:
    // Everything the chip held is of no value any more: another program comes.
    virtual void forget() = 0;
    // Bits as in a PLANE object. False where the chip cannot be loaded.
    virtual bool load_plane(uint8_t reg, const uint8_t *bits, Refresher &others) = 0;
    // `runs` as in a SCHEDULE object: how many slots, and the microseconds of each.
    virtual void begin_frame(const uint8_t *runs, uint32_t count) = 0;
    // The light of so many slots falls, until `wait_us` after the words before have ended.
    virtual void pass(uint32_t slots, double wait_us) = 0;
    virtual void run(const uint32_t (*words)[5], uint32_t count) = 0;
    // IN is so many steps from here on, and `target::in_settle_us` pass until words may read it.
    virtual void set_in(int16_t steps) = 0;
    // Ends the frame. `frame` stays as it is until `exposing` says that it has been written.
    virtual void read_out(const Contents &contents, uint8_t *frame, uint32_t size) = 0;
    virtual Exposing exposing() = 0;

protected:
    ~Board() = default;
};

constexpr uint8_t codes_channel = 1, exposure_channel = 2, states_channel = 4;

}  // namespace nscc

#endif
