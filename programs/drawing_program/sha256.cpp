// SPDX-License-Identifier: GPL-3.0-or-later
#include "sha256.h"

#include <array>
#include <cstdint>

namespace {

using State = std::array<std::uint32_t, 8>;

constexpr std::size_t kBlock = 64;
constexpr int kRounds = 64;

struct Constants {
    State first = {};  ///< the state to begin with
    std::array<std::uint32_t, kRounds> rounds = {};
};

/// The largest number whose power is no more than value * 2^(32 power).
constexpr std::uint64_t scaled_root(std::uint64_t value, int power) {
    std::uint64_t root = 0;
    for (std::uint64_t bit = std::uint64_t(1) << 36; bit; bit /= 2) {
        unsigned __int128 product = 1, limit = value;
        for (int i = 0; i < power; ++i)
            product *= root + bit, limit <<= 32;
        if (product <= limit) root += bit;
    }
    return root;
}

/// First 32 bits of the fractions of square and cube roots of the first primes.
constexpr Constants constants() {
    Constants result;
    std::size_t count = 0;
    for (std::uint64_t n = 2; count < result.rounds.size(); ++n) {
        bool is_prime = true;
        for (std::uint64_t d = 2; d * d <= n; ++d)
            is_prime &= n % d != 0;
        if (!is_prime) continue;
        if (count < result.first.size()) result.first[count] = std::uint32_t(scaled_root(n, 2));
        result.rounds[count++] = std::uint32_t(scaled_root(n, 3));
    }
    return result;
}

constexpr Constants kConstants = constants();

std::uint32_t turned(std::uint32_t x, int bits) {
    return x >> bits | x << (32 - bits);
}

void add_block(State& state, const unsigned char* bytes) {
    std::array<std::uint32_t, kRounds> w;
    for (std::size_t i = 0; i < 16; ++i, bytes += 4)
        w[i] = std::uint32_t(bytes[0]) << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
    for (std::size_t i = 16; i < w.size(); ++i) {
        const std::uint32_t a = w[i - 15], b = w[i - 2];
        w[i] = w[i - 16] + (turned(a, 7) ^ turned(a, 18) ^ a >> 3) + w[i - 7] +
               (turned(b, 17) ^ turned(b, 19) ^ b >> 10);
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < w.size(); ++i) {
        const std::uint32_t chosen = (e & f) ^ (~e & g), most = (a & b) ^ (a & c) ^ (b & c);
        const std::uint32_t one = h + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + chosen +
                                  kConstants.rounds[i] + w[i];
        const std::uint32_t two = (turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + most;
        h = g, g = f, f = e, e = d + one, d = c, c = b, b = a, a = one + two;
    }
    const State added = {a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < state.size(); ++i)
        state[i] += added[i];
}

}  // namespace

std::string sha256_of(std::string_view bytes) {
    State state = kConstants.first;
    const auto add = [&](std::string_view blocks) {
        for (std::size_t i = 0; i + kBlock <= blocks.size(); i += kBlock)
            add_block(state, reinterpret_cast<const unsigned char*>(blocks.data()) + i);
    };
    add(bytes);
    std::string end(bytes.substr(bytes.size() / kBlock * kBlock));
    end += '\x80';
    end.append((2 * kBlock - 8 - end.size()) % kBlock, '\0');
    for (int shift = 56; shift >= 0; shift -= 8)
        end += char(8 * std::uint64_t(bytes.size()) >> shift);
    add(end);
    std::string digits;
    for (const std::uint32_t word : state)
        for (int shift = 28; shift >= 0; shift -= 4)
            digits += "0123456789abcdef"[word >> shift & 15];
    return digits;
}
