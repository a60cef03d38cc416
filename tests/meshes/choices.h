// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

namespace test_meshes {

/// Decisions by the bytes of a fuzzer, file or seed, which outlive this; 0 after the last byte.
class Choices {
public:
    Choices(const std::uint8_t* bytes, std::size_t size) : next_(bytes), end_(bytes + size) {}
    explicit Choices(const std::vector<std::uint8_t>& bytes)
        : Choices(bytes.data(), bytes.size()) {}

    bool exhausted() const { return next_ == end_; }
    std::uint8_t byte() { return next_ == end_ ? std::uint8_t(0) : *next_++; }
    unsigned below(unsigned count) { return byte() % count; }
    bool one_in(unsigned count) { return below(count) == 1; }
    unsigned word() {
        const unsigned high = byte();
        return high << 8 | byte();
    }
    double unit() { return word() / 65535.0; }  ///< 0..1
    double any_double() {
        std::uint64_t bits = 0;
        for (int i = 0; i < 4; ++i)
            bits = bits << 16 | word();
        double value;
        std::memcpy(&value, &bits, sizeof(value));
        return value;
    }

private:
    const std::uint8_t *next_, *end_;
};

/// The same on every machine.
inline std::vector<std::uint8_t> random_bytes(unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(count);
    for (std::uint8_t& byte : bytes)
        byte = std::uint8_t(random());
    return bytes;
}

}  // namespace test_meshes
