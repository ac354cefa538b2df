// Which words the target takes. The tables are generated (target.hpp); nothing else is believed.
#ifndef NSCC_WORDS_HPP
#define NSCC_WORDS_HPP

#include "bytes.hpp"

namespace nscc {

struct Word {
    uint32_t part[5];
};

enum Effect : uint8_t {
    NOTHING, RESET_PIX, BUS, FLAG_ALL, FLAG_ANALOG, FLAG_DIGITAL, DIGITAL, DIGITAL_NEIGHBOURS,
    PROPAGATION
};
enum Phase : uint8_t { WHOLE, FIRST_HALF, SECOND_HALF };

// A row of the table of operations. Counts of 255 have no limit; `pair` tells apart the in-place
// forms, whose two halves share it.
struct Operation {
    Word fixed;
    uint8_t clock, effect, phase, pair;
    uint8_t fewest_destinations, most_destinations, fewest_sources, most_sources;
};

// A register: its control lines as words (zeros if it cannot be read, or written). `directed`: NEWS
// connected to the bus of a neighbour. `bit`: the register's bit among the digital registers.
struct Register {
    Word read, written;
    bool analog, known, flag, directed, news;
    uint32_t bit;
};

struct Meaning {
    bool legal;
    uint8_t effect, phase, pair;
    bool analog;
    uint32_t written;               // digital registers, a bit each
};

// What a word does on this target; not legal where it is no word of it.
Meaning meaning_of(const Word &word);

// Whether a word of the target's runs on the analog clock.
inline bool is_analog(const uint32_t (&word)[5]) { return (word[0] >> 19 & 7) == 0; }

}  // namespace nscc

#endif
