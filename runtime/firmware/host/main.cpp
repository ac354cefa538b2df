// The loader on a computer, behind a pseudo-terminal (`loader --pty`), or a step at a time on the
// clock of whoever drives it (`loader --lockstep`). Its standard input and output are a channel to
// the process that emulates the chip.

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include "channel.hpp"
#include "emulated_board.hpp"
#include "loader.hpp"

namespace {

using namespace nscc;

// A chip whose words take what the target's figures say, on a clock of its own, and whose frames
// come whole.
class Chip final : public EmulatedBoard {
public:
    uint32_t ticks() override { return uint32_t(now_ >> 32); }
    void begin_frame() override {
        EmulatedBoard::begin_frame();
        now_ = Time(ticks()) << 32;
    }
    int32_t past(uint32_t deadline, uint32_t) override {
        const int32_t late = int32_t(ticks() - deadline);
        now_ = (late < 0 ? Time(deadline) << 32 : now_) + time_of(target::wait_us);
        return late < 0 ? 0 : late;
    }
    void run(const uint32_t (*words)[5], uint32_t count) override {
        EmulatedBoard::run(words, count);
        now_ += time_of(target::launch_us);
        for (uint32_t i = 0; i < count; ++i) {
            const bool analog = is_analog(words[i]);
            now_ += time_of(analog ? target::analog_word_us : target::digital_word_us);
        }
    }
    void set_in(int16_t steps) override {
        EmulatedBoard::set_in(steps);
        now_ += time_of(target::in_settle_us);
    }
    bool convert(uint32_t offset, uint8_t *bytes, uint32_t count) override {
        if (offset + count > frame_.size()) {
            return false;
        }
        copy(bytes, frame_.data() + offset, count);
        return true;
    }

    void take_result(const std::vector<uint8_t> &data) {
        if (data.size() < 5) {
            std::exit(1);
        }
        if (get32(data.data()) == job_) {
            frame_.assign(data.begin() + 5, data.end());
        }
        answered(get32(data.data()), data[4] != 0);
    }

private:
    Time now_ = 0;
    std::vector<uint8_t> frame_;
};

Chip board;
Loader loader(board);
Records records;

constexpr size_t most_bytes = 4096;
constexpr int idle_ms = 250, nobody_ms = 10, busy_ms = 1;

uint64_t now_us() {
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return uint64_t(now.tv_sec) * 1000000 + uint64_t(now.tv_nsec) / 1000;
}

// Goes on with what is being done; frames have a clock of their own, on which nothing comes meanwhile.
size_t go_on(uint8_t *out, size_t room, uint64_t now) {
    const size_t count = loader.poll(out, room, now);
    loader.poll(nullptr, 0, now);       // a frame begins when its answer is out
    while (loader.hurries()) {
        loader.glance(nullptr, 0, now);
    }
    return count;
}

// A step: bytes from the line at a time, and what the loader has for the line then.
void step(const std::vector<uint8_t> &data) {
    if (data.size() < 12) {
        std::exit(1);
    }
    const uint64_t now = get64(data.data());
    const size_t room = get32(data.data() + 8);
    loader.receive(data.data() + 12, data.size() - 12, now);
    std::vector<uint8_t> out(1 + (room < most_bytes ? room : most_bytes));
    const size_t count = go_on(out.data() + 1, out.size() - 1, now);
    out[0] = loader.busy();
    put_record(OUTPUT, out.data(), 1 + count);
    flush_records();
}

void obey() {
    uint8_t type;
    std::vector<uint8_t> data;
    while (records.next(type, data)) {
        if (type == RESULT) {
            board.take_result(data);
        } else if (type == RESTART) {
            loader.start();
        } else if (type == INPUT) {
            step(data);
        } else {
            std::exit(1);
        }
    }
}

int open_terminal() {
    const int master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) {
        return -1;
    }
    const char *name = ptsname(master);
    const int slave = name ? open(name, O_RDWR | O_NOCTTY) : -1;
    termios mode;
    if (slave < 0 || tcgetattr(slave, &mode) != 0) {
        return -1;
    }
    cfmakeraw(&mode);
    tcsetattr(slave, TCSANOW, &mode);
    put_record(PORT, reinterpret_cast<const uint8_t *>(name), std::strlen(name));
    flush_records();
    close(slave);
    return master;
}

int serve() {
    const int master = open_terminal();
    if (master < 0) {
        return 1;
    }
    uint8_t in[most_bytes], out[most_bytes];
    size_t waiting = 0;
    while (true) {
        flush_records();
        const short wanted = short(POLLIN | (waiting > 0 ? POLLOUT : 0));
        pollfd watched[] = {{channel_in, POLLIN, 0}, {master, wanted, 0}};
        poll(watched, 2, waiting > 0 ? idle_ms : loader.busy() ? busy_ms : idle_ms);
        if (watched[0].revents != 0 && !records.fill()) {
            return 0;                   // the emulator ended, and so do we
        }
        obey();
        if (watched[1].revents & POLLHUP) {
            waiting = 0;                // nobody listens
            go_on(out, sizeof out, now_us());
            poll(watched, 1, nobody_ms);
            continue;
        }
        const ssize_t count = read(master, in, sizeof in);
        loader.receive(in, count > 0 ? size_t(count) : 0, now_us());
        if (waiting == 0) {
            waiting = go_on(out, sizeof out, now_us());
        }
        const ssize_t sent = waiting > 0 ? write(master, out, waiting) : 0;
        if (sent > 0) {
            waiting -= size_t(sent);
            std::memmove(out, out + sent, waiting);
        }
    }
}

}  // namespace

int main(int count, char **arguments) {
    if (count == 2 && std::strcmp(arguments[1], "--pty") == 0) {
        return serve();
    }
    if (count == 2 && std::strcmp(arguments[1], "--lockstep") == 0) {
        while (records.fill()) {
            obey();
        }
        return 0;
    }
    return 2;
}
