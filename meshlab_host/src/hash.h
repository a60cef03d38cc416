// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// A sum of 64-bit words, each mixed with its position, so that none has to wait for the one before
/// it. Not cryptographic, but sensitive to any changed bit of a mesh.
class Hash {
public:
    explicit Hash(std::uint64_t seed) : place_(seed) {}

    void add(std::uint64_t word) {
        place_ += 0x9e3779b97f4a7c15u;
        std::uint64_t mixed = (word ^ place_) * 0xbf58476d1ce4e5b9u;
        mixed ^= mixed >> 32;
        sum_ += mixed * 0x94d049bb133111ebu;
    }
    std::uint64_t value() const { return sum_; }

private:
    std::uint64_t place_, sum_ = 0;
};

template <class Scalar>
std::uint64_t bits(Scalar value) {
    std::uint64_t result = 0;
    std::memcpy(&result, &value, sizeof value);
    return result;
}

/// Each word has its own odd factor, so that swaps between them change the result.
inline std::uint64_t pack(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
    return a * 0xd6e8feb86659fd93u + b * 0xa0761d6478bd642fu + c * 0xe7037ed1a0b428dbu;
}

inline std::uint64_t pack(const Point3m& p) {
    return pack(bits(p[0]), bits(p[1]), bits(p[2]));
}

}  // namespace meshlab_host
