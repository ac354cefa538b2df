#include "words.hpp"

#include "target.hpp"

namespace nscc {

namespace {

constexpr uint32_t clock_mask = 7u << 19;
constexpr uint8_t no_limit = 255;

Word both(const Word &a, const Word &b) {
    Word found = a;
    for (int i = 0; i < 5; ++i) {
        found.part[i] &= b.part[i];
    }
    return found;
}

bool same(const Word &a, const Word &b) {
    for (int i = 0; i < 5; ++i) {
        if (a.part[i] != b.part[i]) {
            return false;
        }
    }
    return true;
}

bool empty(const Word &a) { return same(a, Word{}); }

// Whether a word raises all of these control lines; false for no lines.
bool raised(const Word &word, const Word &lines) {
    return !empty(lines) && same(both(word, lines), lines);
}

void raise(Word &to, const Word &lines) {
    for (int i = 0; i < 5; ++i) {
        to.part[i] |= lines.part[i];
    }
}

bool within(unsigned count, uint8_t fewest, uint8_t most) {
    return count >= fewest && (most == no_limit || count <= most);
}

// What one row of the table makes of a word: whether raising the row's lines and those of the
// operands found in the word gives the word again, and whether the target takes it.
struct Attempt {
    const Word &word;
    const Operation &row;

    bool matches(bool &allowed, uint32_t &registers) const {
        const bool analog = row.clock == 0;
        const bool settles = row.effect == BUS || row.effect == RESET_PIX || row.effect == NOTHING;
        Word made = row.fixed;
        unsigned destinations = 0, sources = 0, joined = 0;
        bool overlap = false, reads_flag = false, directed = false, sends = false;
        allowed = true;
        registers = 0;
        for (const Register &reg : target::registers) {
            if (reg.analog != analog) {
                continue;
            }
            const bool written = raised(word, reg.written);
            bool read = raised(word, reg.read);
            if (settles && (written || !empty(both(row.fixed, reg.read)))) {
                read = false;
            }
            if (written) {
                ++destinations;
                raise(made, reg.written);
                registers |= reg.bit;
            }
            if (read) {
                ++sources;
                raise(made, reg.read);
                reads_flag = reads_flag || reg.flag;
            }
            overlap = overlap || (written && read);
            joined += (reg.directed || reg.news) && (written || read);
            directed = directed || (reg.directed && (written || read));
            sends = sends || (reg.directed && written);
            allowed = allowed && (reg.known || !(written || read));
        }
        if (!within(destinations, row.fewest_destinations, row.most_destinations) ||
            !within(sources, row.fewest_sources, row.most_sources) ||
            (row.phase == WHOLE && overlap) || !same(made, word)) {
            return false;
        }
        // NEWS connects to one bus at a time, so a word with a neighbour has further limits.
        if (directed && (joined > 1 || row.effect != BUS || (sends && destinations > 1))) {
            return false;
        }
        if (directed) {
            allowed = allowed && sources <= target::directed_sources &&
                      (target::directed_halving || destinations == 1);
        }
        if (row.effect == FLAG_DIGITAL) {
            allowed = allowed && sources <= target::where_sources &&
                      (target::where_reads_flag || !reads_flag);
        } else if (row.effect == DIGITAL) {
            allowed = allowed && sources <= target::or_sources;
        }
        return true;
    }
};

}  // namespace

Meaning meaning_of(const Word &word) {
    const uint32_t clock = (word.part[0] & clock_mask) >> 19;
    for (const Operation &row : target::operations) {
        const Word &kind = row.clock == 0 ? target::kind_analog : target::kind_digital;
        if (row.clock != clock || !same(both(word, kind), both(row.fixed, kind))) {
            continue;
        }
        bool allowed = false;
        uint32_t written = 0;
        if (Attempt{word, row}.matches(allowed, written)) {
            return {allowed, row.effect, row.phase, row.pair, row.clock == 0, written};
        }
    }
    return {false, NOTHING, WHOLE, 0, false, 0};
}

}  // namespace nscc
