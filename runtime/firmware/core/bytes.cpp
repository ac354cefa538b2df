#include "bytes.hpp"

namespace nscc {

bool equal(const uint8_t *a, const uint8_t *b, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        if (a[i] != b[i]) {
            return false;
        }
    }
    return true;
}

void copy(uint8_t *to, const uint8_t *from, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        to[i] = from[i];
    }
}

void clear(uint8_t *at, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        at[i] = 0;
    }
}

const uint32_t crc_table[16] = {
    0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac, 0x76dc4190, 0x6b6b51f4,
    0x4db26158, 0x5005713c, 0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c,
    0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c,
};

void FrameSum::reset() {
    crc_ = crc_start;
    a_ = 1;
    b_ = 0;
}

void FrameSum::add(const uint8_t *data, size_t count) {
    constexpr uint32_t prime = 65521;
    constexpr size_t most = 5552;       // bytes until b may outgrow 32 bits
    while (count > 0) {
        const size_t some = count < most ? count : most;
        for (size_t i = 0; i < some; ++i) {
            crc_ = crc_with(crc_, data[i]);
            a_ += data[i];
            b_ += a_;
        }
        a_ %= prime;
        b_ %= prime;
        data += some;
        count -= some;
    }
}

namespace {

const uint32_t round_constants[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
};

inline uint32_t rotated(uint32_t value, int count) {
    return value >> count | value << (32 - count);
}

}  // namespace

void Sha256::reset() {
    static const uint32_t start[8] = {
        0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19,
    };
    for (int i = 0; i < 8; ++i) {
        state_[i] = start[i];
    }
    length_ = 0;
    held_ = 0;
}

void Sha256::add(const uint8_t *data, size_t count) {
    length_ += count;
    for (size_t i = 0; i < count; ++i) {
        pending_[held_++] = data[i];
        if (held_ == sizeof pending_) {
            block(pending_);
            held_ = 0;
        }
    }
}

void Sha256::finish(uint8_t (&digest)[size]) {
    const uint64_t bits = length_ * 8;
    const uint8_t one = 0x80, zero = 0;
    add(&one, 1);
    while (held_ != 56) {
        add(&zero, 1);
    }
    uint8_t tail[8];
    for (int i = 0; i < 8; ++i) {
        tail[i] = uint8_t(bits >> (56 - 8 * i));
    }
    add(tail, sizeof tail);
    for (int i = 0; i < 32; ++i) {
        digest[i] = uint8_t(state_[i / 4] >> (24 - 8 * (i % 4)));
    }
}

void Sha256::block(const uint8_t *at) {
    uint32_t w[64];
    for (int i = 0; i < 16; ++i, at += 4) {
        w[i] = uint32_t(at[0]) << 24 | uint32_t(at[1]) << 16 | uint32_t(at[2]) << 8 | at[3];
    }
    for (int i = 16; i < 64; ++i) {
        const uint32_t s0 = rotated(w[i - 15], 7) ^ rotated(w[i - 15], 18) ^ w[i - 15] >> 3;
        const uint32_t s1 = rotated(w[i - 2], 17) ^ rotated(w[i - 2], 19) ^ w[i - 2] >> 10;
        w[i] = w[i - 16] + s0 + w[i - 7] + s1;
    }
    uint32_t v[8];
    for (int i = 0; i < 8; ++i) {
        v[i] = state_[i];
    }
    for (int i = 0; i < 64; ++i) {
        const uint32_t s1 = rotated(v[4], 6) ^ rotated(v[4], 11) ^ rotated(v[4], 25);
        const uint32_t chosen = (v[4] & v[5]) ^ (~v[4] & v[6]);
        const uint32_t t1 = v[7] + s1 + chosen + round_constants[i] + w[i];
        const uint32_t s0 = rotated(v[0], 2) ^ rotated(v[0], 13) ^ rotated(v[0], 22);
        const uint32_t t2 = s0 + ((v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]));
        for (int k = 7; k > 0; --k) {
            v[k] = v[k - 1];
        }
        v[4] += t1;
        v[0] = t1 + t2;
    }
    for (int i = 0; i < 8; ++i) {
        state_[i] += v[i];
    }
}

}  // namespace nscc
