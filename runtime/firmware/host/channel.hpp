// Records to and from the process that emulates the chip: a type, a length, bytes.
#ifndef NSCC_CHANNEL_HPP
#define NSCC_CHANNEL_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nscc {

enum Record : uint8_t {
    PORT = 'P',         // to the emulator: the name of our pseudo-terminal
    JOB = 'J',          // a frame to expose
    OUTPUT = 'O',       // whether there is more to do, then bytes for the line
    RESULT = 'R',       // from the emulator: 1 and a frame, or 0
    INPUT = 'I',        // u64 microseconds, u32 room, then bytes from the line
    RESTART = 'B',
};

constexpr int channel_in = 0, channel_out = 1;

void put_record(uint8_t type, const uint8_t *data, size_t size);

// Collects records from bytes as they come.
class Records {
public:
    // Reads what is there, or waits for something to be there; false at the end of the channel.
    bool fill();
    // The next record that is whole; false where there is none.
    bool next(uint8_t &type, std::vector<uint8_t> &data);

private:
    std::vector<uint8_t> held_;
};

}  // namespace nscc

#endif
