#include "reports.hpp"

namespace nscc {

namespace {

constexpr uint32_t piece = target::rows, pixels = uint32_t(target::rows) * target::cols;
constexpr uint16_t nowhere = 0xffff;

}  // namespace

Verdict Reports::accept(uint32_t length, uint32_t sent) {
    count_ = 0;
    Reader reader(raw_, length);
    uint32_t count;
    if (!reader.take_count(count)) {
        return refused(READOUT, reader.at());
    }
    if (count > target::digital_count) {
        return refused(READOUT, count);
    }
    for (uint32_t i = 0; i < count; ++i) {
        const uint8_t *at = reader.take(16);
        if (!at) {
            return refused(READOUT, reader.at());
        }
        if (at[0] >= target::digital_count || (sent >> at[0] & 1) != 0 || get32(at + 4) > pixels) {
            return refused(READOUT, at[0]);
        }
        sent |= 1u << at[0];
    }
    if (!reader.ended()) {
        return refused(READOUT, reader.at());
    }
    count_ = count;
    return fine;
}

uint32_t Reports::length() const {
    uint32_t length = 0;
    for (uint32_t i = 0; i < count_; ++i) {
        length += 4 * get32(entry(i) + 4) + summary_bytes;
    }
    return length;
}

void Reports::begin(uint32_t planes_at) {
    planes_at_ = planes_at;
    report_ = made_count_ = made_at_ = 0;
    begin_report();
}

void Reports::begin_report() {
    byte_ = bits_ = found_ = told_ = 0;
    box_[0] = box_[1] = nowhere;
    box_[2] = box_[3] = 0;
}

bool Reports::make(uint8_t *bytes, uint32_t count) {
    while (count > 0) {
        if (made_at_ == made_count_) {
            made_at_ = made_count_ = 0;
            if (report_ == count_ || !go_on()) {
                return false;
            }
            continue;
        }
        *bytes++ = made_[made_at_++];
        --count;
    }
    return true;
}

bool Reports::go_on() {
    if (bits_ != 0) {
        const uint32_t bit = uint32_t(__builtin_ctz(bits_)), pixel = 8 * (byte_ - 1) + bit;
        bits_ &= bits_ - 1;
        found(pixel % target::cols, pixel / target::cols);
    } else if (byte_ < plane_bytes) {
        const uint32_t at = byte_ % piece, left = plane_bytes - byte_;
        const uint32_t plane_at = planes_at_ + report_ * plane_bytes;
        if (at == 0 && !board_.convert(plane_at + byte_, piece_, left < piece ? left : piece)) {
            return false;
        }
        bits_ = piece_[at];
        ++byte_;
    } else if (told_ < most()) {
        ++told_;
        put(nowhere, nowhere);
    } else {
        put(uint16_t(found_), uint16_t(found_ >> 16));
        put(box_[0], found_ > 0 ? box_[1] : nowhere);
        put(found_ > 0 ? box_[2] : nowhere, found_ > 0 ? box_[3] : nowhere);
        ++report_;
        begin_report();
    }
    return true;
}

// A bit that is 1, which counts where it is not in the margins.
void Reports::found(uint32_t x, uint32_t y) {
    const uint8_t *margin = entry(report_) + 8;
    if (x < get16(margin) || x + get16(margin + 2) >= target::cols || y < get16(margin + 4) ||
        y + get16(margin + 6) >= target::rows) {
        return;
    }
    const uint16_t column = uint16_t(x), row = uint16_t(y);
    ++found_;
    box_[0] = column < box_[0] ? column : box_[0];
    box_[1] = row < box_[1] ? row : box_[1];
    box_[2] = column > box_[2] ? column : box_[2];
    box_[3] = row;
    if (told_ < most()) {
        ++told_;
        put(column, row);
    }
}

void Reports::put(uint16_t first, uint16_t second) {
    put16(made_ + made_count_, first);
    put16(made_ + made_count_ + 2, second);
    made_count_ += 4;
}

}  // namespace nscc
