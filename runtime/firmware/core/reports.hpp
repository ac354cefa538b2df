// Reports about planes: where their bits are 1, instead of the planes themselves.
#ifndef NSCC_REPORTS_HPP
#define NSCC_REPORTS_HPP

#include "board.hpp"
#include "reader.hpp"
#include "target.hpp"
#include "verdict.hpp"

namespace nscc {

class Reports {
public:
    static constexpr uint32_t most_bytes = 4 + 16 * target::digital_count, summary_bytes = 12;
    static constexpr uint32_t plane_bytes = (uint32_t(target::rows) * target::cols + 7) / 8;

    explicit Reports(Board &board) : board_(board) {}

    void forget() { count_ = 0; }
    // Where the bytes of a REPORTS object go.
    uint8_t *bytes() { return raw_; }
    // Checks an object that is whole; the registers in the bit mask `sent` cannot be reported.
    Verdict accept(uint32_t length, uint32_t sent);
    uint32_t count() const { return count_; }
    uint8_t reg(uint32_t report) const { return entry(report)[0]; }
    uint32_t length() const;

    // A frame whose reported planes begin at this offset of what the board converts.
    void begin(uint32_t planes_at);
    // The next bytes of the frame's reports; false where the board cannot read a plane.
    bool make(uint8_t *bytes, uint32_t count);

private:
    const uint8_t *entry(uint32_t report) const { return raw_ + 4 + 16 * report; }
    uint32_t most() const { return get32(entry(report_) + 4); }
    void begin_report();
    // Goes on to the next byte of the plane, or to the next bit of it that is 1.
    bool go_on();
    void found(uint32_t x, uint32_t y);
    void put(uint16_t first, uint16_t second);

    Board &board_;
    uint32_t count_ = 0, planes_at_ = 0, report_ = 0;
    uint32_t byte_ = 0, bits_ = 0;          // of the plane: the next byte, bits left of the last one
    uint32_t found_ = 0, told_ = 0;         // bits that are 1, and coordinates made
    uint16_t box_[4] = {};
    uint8_t made_[summary_bytes] = {};
    uint32_t made_count_ = 0, made_at_ = 0;
    uint8_t piece_[target::rows];
    uint8_t raw_[most_bytes];
};

}  // namespace nscc

#endif
