// The main loop of a chip, a turn at a time.
#ifndef NSCC_TURN_HPP
#define NSCC_TURN_HPP

#include "loader.hpp"
#include "port.hpp"

namespace nscc {

class Turns {
public:
    explicit Turns(Loader &loader) : loader_(loader) {}

    // Feeds the watchdog, takes bytes from the port, goes on with what is being done, and sends.
    void take() {
        port_feed_watchdog();
        // Whoever never stops talking does not keep the loop from the rest of its work.
        for (int piece = 0; piece < pieces_a_turn; ++piece) {
            const size_t count = port_read(in_, sizeof in_);
            if (count == 0) {
                break;
            }
            loader_.receive(in_, count, port_micros());
        }
        if (sent_ == waiting_) {
            waiting_ = loader_.poll(out_, sizeof out_, port_micros());
            sent_ = 0;
        } else {
            loader_.poll(out_, 0, port_micros());
        }
        sent_ += port_write(out_ + sent_, waiting_ - sent_);
        while (loader_.hurries()) {
            const size_t count = port_read(in_, sizeof in_);
            loader_.glance(in_, count, port_micros());
        }
    }

private:
    static constexpr int pieces_a_turn = 8;

    Loader &loader_;
    uint8_t in_[128], out_[256];
    size_t waiting_ = 0, sent_ = 0;
};

}  // namespace nscc

#endif
