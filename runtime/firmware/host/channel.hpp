// The channel to the process that emulates the chip, over standard input and output.
#ifndef NSCC_CHANNEL_HPP
#define NSCC_CHANNEL_HPP

#include <vector>

#include "records.hpp"

namespace nscc {

constexpr int channel_in = 0;

inline void put_record(uint8_t type, const uint8_t *data, size_t size) {
    begin_record(type, size);
    put_bytes(data, size);
}

// Sends what was put; it waits until then.
void flush_records();

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
