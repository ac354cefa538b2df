// What a chip's main loop needs of the chip, besides the board.
#ifndef NSCC_PORT_HPP
#define NSCC_PORT_HPP

#include <cstddef>
#include <cstdint>

namespace nscc {

// Bytes that have arrived, at most `room`: how many. Does not wait. Between two calls the port
// has to keep at least limits::window bytes.
size_t port_read(uint8_t *data, size_t room);

// Sends bytes; how many were taken. Does not wait.
size_t port_write(const uint8_t *data, size_t count);

// Microseconds since power on.
uint64_t port_micros();

// Has the chip start anew unless it is called again within four seconds. The main loop calls it,
// and nothing else does.
void port_feed_watchdog();

}  // namespace nscc

#endif
