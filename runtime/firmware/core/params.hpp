// What the host sets before a frame: the values of a program's parameters, and what they change.
#ifndef NSCC_PARAMS_HPP
#define NSCC_PARAMS_HPP

#include "reader.hpp"
#include "verdict.hpp"

namespace nscc {

// How a row of the schedule changes: IN is `factor` times the parameter, or the row is executed
// `offset` + `factor` times the parameter, at least 0 times and at most as often as it says; or it
// is executed in the first frame only.
struct Change {
    enum What : uint8_t { LEVEL, TIMES, START };

    uint32_t row;
    uint8_t param, what;
    int16_t factor;
    int32_t offset;
};

// A PARAMS object.
class Params {
public:
    static constexpr uint32_t most_params = 16, most_changes = 64;
    static constexpr uint32_t param_size = 12, change_size = 12;
    static constexpr uint32_t most_bytes =
        8 + param_size * most_params + change_size * most_changes;

    void forget() { count_ = changes_ = 0; }
    // Where the bytes of the object go.
    uint8_t *bytes() { return raw_; }
    Verdict accept(uint32_t length);
    uint32_t count() const { return count_; }
    uint32_t changes() const { return changes_; }
    Change change(uint32_t number) const;
    // The lowest or the highest value of a parameter.
    int32_t end(uint8_t param, bool high) const;
    // What a change makes of the value that its parameter has, or of another one.
    int64_t result(const Change &change) const { return result(change, value_[change.param]); }
    static int64_t result(const Change &change, int32_t value) {
        return change.offset + int64_t(change.factor) * value;
    }
    // Takes a value for each parameter, an i32, where all are in their ranges.
    Verdict set(const uint8_t *values);

private:
    uint32_t count_ = 0, changes_ = 0;
    int32_t value_[most_params];
    uint8_t raw_[most_bytes];
};

}  // namespace nscc

#endif
