#include "emulated_board.hpp"

#include <cstring>

#include "channel.hpp"

namespace nscc {

namespace {

constexpr uint32_t light_falls = 0xffffffff, in_is_set = 0xfffffffe;

void append32(std::vector<uint8_t> &to, uint32_t value) {
    uint8_t bytes[4];
    put32(bytes, value);
    to.insert(to.end(), bytes, bytes + 4);
}

void append_double(std::vector<uint8_t> &to, double value) {
    uint8_t bytes[8];
    std::memcpy(bytes, &value, sizeof bytes);
    to.insert(to.end(), bytes, bytes + 8);
}

void append(std::vector<uint8_t> &to, const std::vector<uint8_t> &data) {
    to.insert(to.end(), data.begin(), data.end());
}

}  // namespace

void EmulatedBoard::forget() {
    for (auto &plane : planes_) {
        plane.clear();
    }
    order_.clear();
    recording_ = false;
}

bool EmulatedBoard::load_plane(uint8_t reg, const uint8_t *bits, Refresher &others) {
    planes_[reg].assign(bits, bits + plane_bytes);
    order_.push_back(reg);
    others.refresh();
    return true;
}

void EmulatedBoard::begin_frame(const uint8_t *runs, uint32_t count) {
    runs_.clear();
    append32(runs_, count);
    runs_.insert(runs_.end(), runs, runs + 12 * size_t(count));
    kernels_.clear();
    events_.clear();
    event_count_ = 0;
    recording_ = true;
}

void EmulatedBoard::pass(uint32_t slots, double) {
    append32(events_, light_falls);
    append32(events_, slots);
    ++event_count_;
}

void EmulatedBoard::run(const uint32_t (*words)[5], uint32_t count) {
    if (!recording_) {
        return;                         // a refresh: what is emulated does not fade
    }
    uint32_t number = 0;
    while (number < kernels_.size() &&
           (kernels_[number].words != words || kernels_[number].count != count)) {
        ++number;
    }
    if (number == kernels_.size()) {
        kernels_.push_back({words, count});
    }
    append32(events_, number);
    append32(events_, 0);
    ++event_count_;
}

void EmulatedBoard::set_in(int16_t steps) {
    append32(events_, in_is_set);
    append32(events_, uint32_t(int32_t(steps)));
    ++event_count_;
}

void EmulatedBoard::read_out(const Contents &contents, uint8_t *frame, uint32_t size) {
    recording_ = false;
    std::vector<uint8_t> job;
    append32(job, contents.channels);
    append32(job, contents.readout_count);
    for (uint32_t i = 0; i < contents.readout_count; ++i) {
        append32(job, contents.readouts[i].reg);
        append_double(job, contents.readouts[i].gain);
    }
    append32(job, contents.state_count);
    for (uint32_t i = 0; i < contents.state_count; ++i) {
        append32(job, contents.states[i]);
    }
    append(job, runs_);
    append32(job, uint32_t(kernels_.size()));
    for (const Kernel &kernel : kernels_) {
        append32(job, kernel.count);
        for (uint32_t n = 0; n < kernel.count; ++n) {
            for (uint32_t part : kernel.words[n]) {
                append32(job, part);
            }
        }
    }
    append32(job, event_count_);
    append(job, events_);
    append32(job, uint32_t(order_.size()));
    for (uint8_t reg : order_) {
        append32(job, reg);
        append(job, planes_[reg]);
    }
    frame_ = frame;
    size_ = size;
    state_ = Exposing::BUSY;
    put_record(JOB, job.data(), job.size());
}

void EmulatedBoard::answered(const std::vector<uint8_t> &data) {
    if (state_ != Exposing::BUSY) {
        return;
    }
    const size_t planes = plane_bytes * order_.size();
    if (data.size() == 1 + size_t(size_) + planes && data[0] == 1) {
        copy(frame_, data.data() + 1, size_);
        const uint8_t *plane = data.data() + 1 + size_;
        for (uint8_t reg : order_) {
            planes_[reg].assign(plane, plane + plane_bytes);
            plane += plane_bytes;
        }
        state_ = Exposing::DONE;
    } else {
        state_ = Exposing::BROKEN;
    }
}

Exposing EmulatedBoard::exposing() { return state_; }

}  // namespace nscc
