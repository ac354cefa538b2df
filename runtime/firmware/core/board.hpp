// The chip below the loader: what a hardware layer has to supply.
#ifndef NSCC_BOARD_HPP
#define NSCC_BOARD_HPP

#include "words.hpp"

namespace nscc {

struct Readout {
    uint8_t reg;                    // place among the target's analog registers
    bool direct;                    // an image: values are signed, and not spread
    uint64_t gain;                  // the bits of a double
};

// What a frame holds, in this order: the codes of all readouts, their exposures, then the planes of
// digital registers, of those channels that are asked for.
struct Contents {
    const Readout *readouts;
    uint32_t readout_count;
    const uint8_t *states;          // digital registers
    uint32_t state_count;
    uint8_t channels;
    uint32_t kept;                  // analog registers that readout must leave as they are, a bit each
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
    // The program's words, which stay where they are: `run` is given parts of them.
    virtual void take_words(const uint32_t *words, uint32_t count) = 0;
    // The runs of a SCHEDULE object as they came: how many slots, and the microseconds of each.
    virtual void take_slots(const uint8_t *runs, uint32_t count) = 0;

    // A clock of limits::ticks_per_us ticks a microsecond, which goes from 2^32 - 1 to 0.
    virtual uint32_t ticks() = 0;
    virtual void begin_frame() = 0;
    // The light of so many slots falls before the next deadline.
    virtual void pass(uint32_t slots) = 0;
    // Waits for a deadline: by how many ticks it is past then. Below 0, and without a wait, where
    // more than so many ticks are left, in which the main loop has time for other things.
    virtual int32_t past(uint32_t deadline, uint32_t left) = 0;
    virtual void run(const uint32_t (*words)[5], uint32_t count) = 0;
    // IN is so many steps from here on, and `target::in_settle_us` pass until words may read it.
    virtual void set_in(int16_t steps) = 0;
    // Ends the frame: these contents are asked for from now on, until another frame begins.
    virtual void read_out(const Contents &contents) = 0;
    virtual Exposing exposing() = 0;
    // So many bytes of a frame: at most target::rows, which is a column, and so many times that
    // from its beginning, or from the beginning of a plane. False where it cannot.
    virtual bool convert(uint32_t offset, uint8_t *bytes, uint32_t count) = 0;

protected:
    ~Board() = default;
};

constexpr uint8_t codes_channel = 1, exposure_channel = 2, states_channel = 4;
constexpr uint8_t reports_channel = 8;      // for the host: a board reads planes as states

}  // namespace nscc

#endif
