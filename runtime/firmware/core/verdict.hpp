// Whether something is accepted, and what is wrong with it: the faults of the protocol.
#ifndef NSCC_VERDICT_HPP
#define NSCC_VERDICT_HPP

#include <cstdint>

namespace nscc {

enum Fault : uint8_t {
    NO_FAULT = 0,
    NO_SESSION, VERSION, MALFORMED, WRONG_STATE, TARGET, TOO_LARGE, DIGEST, WORD, SCHEDULE,
    PLANE, READOUT, NO_PROGRAM, HARDWARE, NO_FRAME, UNKNOWN, BUSY_NOW, LATE, PARAM,
};

struct Verdict {
    Fault fault;
    uint32_t detail;
    bool good() const { return fault == NO_FAULT; }
};
constexpr Verdict fine = {NO_FAULT, 0};
inline Verdict refused(Fault fault, uint32_t detail = 0) { return {fault, detail}; }

}  // namespace nscc

#endif
