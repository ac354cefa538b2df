// What the devkit's owner supplies to the SCAMP-5d loader, for a test: the port is two pipes, and
// an analog register holds a pattern of its own.

#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "port.hpp"
#include "scan.hpp"
#include "target.hpp"

namespace nscc {

const int from_host = std::atoi(std::getenv("PORT_IN"));
const int to_host = std::atoi(std::getenv("PORT_OUT"));

size_t port_read(uint8_t *data, size_t room) {
    std::fflush(stdout);
    pollfd watched = {from_host, POLLIN, 0};
    if (poll(&watched, 1, 2) <= 0) {
        return 0;
    }
    const ssize_t count = read(from_host, data, room);
    if (count <= 0) {
        _exit(0);
    }
    return size_t(count);
}

size_t port_write(const uint8_t *data, size_t count) {
    const ssize_t sent = count > 0 ? write(to_host, data, count) : 0;
    return sent > 0 ? size_t(sent) : 0;
}

// Time passes while somebody looks at the clock.
uint64_t port_micros() {
    static uint64_t now = 0;
    return ++now;
}

void port_feed_watchdog() {}

bool port_scan(const areg_t &reg, uint32_t column, uint8_t *codes) {
    std::printf("scan %s %u\n", reg.name, unsigned(column));
    for (uint32_t row = 0; row < target::rows; ++row) {
        *codes++ = uint8_t(3 * row + 5 * column + uint32_t(reg.name[0]));
    }
    return true;
}

bool port_scan_bits(const dreg_t &reg, uint32_t row, uint32_t rows, uint8_t *bits) {
    std::printf("scan_bits %s %u\n", reg.name, unsigned(row));
    for (uint32_t byte = 0; byte < rows * target::cols / 8; ++byte) {
        *bits++ = uint8_t(7 * (byte + row * target::cols / 8) + uint32_t(reg.name[1]));
    }
    return true;
}

}  // namespace nscc
