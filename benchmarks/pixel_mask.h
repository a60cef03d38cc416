// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace benchmarks {

/// A part of something that can be counted.
struct Share {
    std::size_t found = 0, all = 0;

    bool is_known() const { return all > 0; }
    double value() const { return double(found) / double(all); }  ///< if known
};

/// Some pixels of a square picture.
class PixelMask {
public:
    explicit PixelMask(int size) : size_(size), pixels_(std::size_t(size) * std::size_t(size)) {}

    int size() const { return size_; }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < size_ && y < size_; }
    bool has(int x, int y) const { return contains(x, y) && pixels_[index(x, y)]; }
    /// Pixels beside the picture are left out.
    void set(int x, int y) {
        if (contains(x, y)) pixels_[index(x, y)] = 1;
    }
    void clear(int x, int y) {
        if (contains(x, y)) pixels_[index(x, y)] = 0;
    }

    template <class Use>
    void for_each(Use use) const {
        for (int y = 0; y < size_; ++y)
            for (int x = 0; x < size_; ++x)
                if (pixels_[index(x, y)]) use(x, y);
    }

    /// With all pixels whose middles are within `radius` pixels of one of these.
    PixelMask grown(double radius) const {
        PixelMask result(size_);
        const int reach = int(radius);
        for_each([&](int x, int y) {
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx)
                    if (std::hypot(dx, dy) <= radius) result.set(x + dx, y + dy);
        });
        return result;
    }

    std::size_t count() const {
        std::size_t n = 0;
        for_each([&](int, int) { ++n; });
        return n;
    }

    /// How many of these pixels are also in `others`.
    Share share_in(const PixelMask& others) const {
        Share share;
        for_each([&](int x, int y) {
            ++share.all;
            share.found += others.has(x, y);
        });
        return share;
    }

private:
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(size_) + std::size_t(x);
    }

    int size_;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace benchmarks
