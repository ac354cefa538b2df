// What the devkit's owner supplies to the SCAMP-5d loader, for a test: the port is two pipes, and
// an analog register holds a pattern of its own.

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "port.hpp"
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

uint64_t port_micros() {
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return uint64_t(now.tv_sec) * 1000000 + uint64_t(now.tv_nsec) / 1000;
}

bool port_scan(const areg_t &reg, uint8_t *codes) {
    std::printf("scan %s\n", reg.name);
    for (int row = 0; row < target::rows; ++row) {
        for (int col = 0; col < target::cols; ++col) {
            *codes++ = uint8_t(3 * row + 5 * col + reg.name[0]);
        }
    }
    return true;
}

bool port_scan_bits(const dreg_t &reg, uint8_t *bits) {
    std::printf("scan_bits %s\n", reg.name);
    for (int byte = 0; byte < target::rows * target::cols / 8; ++byte) {
        *bits++ = uint8_t(7 * byte + reg.name[1]);
    }
    return true;
}

}  // namespace nscc
