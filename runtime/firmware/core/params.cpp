#include "params.hpp"

namespace nscc {

Verdict Params::accept(uint32_t length) {
    forget();
    Reader reader(raw_, length);
    uint32_t count, changes;
    if (!reader.take_count(count)) {
        return refused(SCHEDULE, reader.at());
    }
    if (count > most_params) {
        return refused(TOO_LARGE, count);
    }
    if (!reader.take(param_size * count) || !reader.take_count(changes)) {
        return refused(SCHEDULE, reader.at());
    }
    if (changes > most_changes) {
        return refused(TOO_LARGE, changes);
    }
    if (!reader.take(change_size * changes) || !reader.ended()) {
        return refused(SCHEDULE, reader.at());
    }
    for (uint32_t i = 0; i < count; ++i) {
        value_[i] = int32_t(get32(raw_ + 4 + param_size * i + 8));
        if (value_[i] < end(uint8_t(i), false) || value_[i] > end(uint8_t(i), true)) {
            return refused(PARAM, i);
        }
    }
    count_ = count;
    changes_ = changes;
    return fine;
}

Change Params::change(uint32_t number) const {
    const uint8_t *at = raw_ + 8 + param_size * count_ + change_size * number;
    return {get32(at), at[4], at[5], int16_t(get16(at + 6)), int32_t(get32(at + 8))};
}

int32_t Params::end(uint8_t param, bool high) const {
    return int32_t(get32(raw_ + 4 + param_size * param + (high ? 4 : 0)));
}

Verdict Params::set(const uint8_t *values) {
    for (uint32_t i = 0; i < count_; ++i) {
        const int32_t value = int32_t(get32(values + 4 * i));
        if (value < end(uint8_t(i), false) || value > end(uint8_t(i), true)) {
            return refused(PARAM, i);
        }
    }
    for (uint32_t i = 0; i < count_; ++i) {
        value_[i] = int32_t(get32(values + 4 * i));
    }
    return fine;
}

}  // namespace nscc
