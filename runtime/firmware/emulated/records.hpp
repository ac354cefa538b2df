// Records to and from the process that emulates the chip: a type, a length, bytes.
#ifndef NSCC_RECORDS_HPP
#define NSCC_RECORDS_HPP

#include <cstddef>
#include <cstdint>

namespace nscc {

enum Record : uint8_t {
    // To the emulator.
    PORT = 'P',         // the name of our pseudo-terminal
    OUTPUT = 'O',       // whether there is more to do, then bytes for the line
    FORGOTTEN = 'F',    // the chip holds nothing any more
    DRAWN = 'D',        // a plane: register, bits
    WORDS = 'W',        // the program's words
    SLOTS = 'S',        // the runs of its schedule
    BEGUN = 'N',        // a frame begins
    EVENT = 'E',        // light_falls, slots; in_is_set, steps; or a kernel's place in WORDS, its words
    JOB = 'J',          // the frame is to be exposed: number, channels, readouts, states, kept
    WANTED = 'C',       // u32 job, u32 offset, u32 count: bytes of its frame
    // From the emulator.
    RESULT = 'R',       // u32 job, u8 whether there is a frame, and its bytes where they fit
    BYTES = 'B',        // those that were wanted
    INPUT = 'I',        // u64 microseconds, u32 room, then bytes from the line
    RESTART = 'X',
};
constexpr uint32_t light_falls = 0xffffffff, in_is_set = 0xfffffffe;

// A record in pieces: as many bytes have to follow as its beginning says.
void begin_record(uint8_t type, size_t size);
void put_bytes(const uint8_t *data, size_t size);

}  // namespace nscc

#endif
