// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Numbered boxes by size and place, in space or in the picture: a level for each power of two has
/// the boxes of this size in a grid of cells no smaller than they are. What a small box meets is
/// found with a few cells of each level; so to find pairs, the smaller box asks for the larger one.
/// Thread-safe once built.
template <int Dim>
class BoxLevels {
public:
    using Box = Eigen::AlignedBox<float, Dim>;
    static constexpr int kEveryLevel = -1000;

    BoxLevels() = default;
    /// Of the boxes box_of(0), box_of(1), ...; empty ones are left out.
    template <class BoxOf>
    BoxLevels(std::size_t count, BoxOf box_of) {
        auto entries = large_array<Entry>(count);
        for_each_element(count, [&](std::size_t i) {
            entries[i] = {box_of(std::uint32_t(i)), std::uint32_t(i), 0};
        });
        entries.erase(std::remove_if(entries.begin(), entries.end(),
                                     [](const Entry& entry) { return entry.box.isEmpty(); }),
                      entries.end());
        if (!entries.empty()) sort_in(entries);
    }

    /// Of a box: the size of its level is 2^level.
    int level_of(const Box& box) const {
        const float size = box.sizes().maxCoeff();
        return size > 0 ? std::max(smallest_, std::ilogb(size) + 1) : smallest_;
    }

    /// Calls visit(number, box) for boxes that meet `box`, of its own level and of larger ones, or
    /// from `least_level` on. `box` is no larger than the boxes of that level.
    template <class Visit>
    void visit(const Box& box, Visit visit, int least_level = kEveryLevel) const {
        for (const int level : levels_) {
            if (level < least_level) continue;
            const float cell = cell_size(level);
            const Cell low = cell_of(box.min().array() - cell / 2, cell),
                       high = cell_of(box.max().array() + cell / 2, cell);
            for_each_cell(low, high, [&](const Cell& at) { visit_cell(level, at, box, visit); });
        }
    }

private:
    struct Entry {
        Box box;
        std::uint32_t number;
        std::uint32_t tag;  // of its cell, since a bucket may have several
    };
    using Cell = std::array<std::int32_t, Dim>;
    using Point = Eigen::Array<float, Dim, 1>;

    static float cell_size(int level) { return std::ldexp(1.f, level); }
    static Cell cell_of(const Point& point, float cell) {
        Cell result;
        for (int i = 0; i < Dim; ++i)
            result[std::size_t(i)] =
                std::int32_t(std::clamp(std::floor(point[i] / cell), -2147483000.f, 2147483000.f));
        return result;
    }

    template <class Visit>
    static void for_each_cell(const Cell& low, const Cell& high, Visit visit) {
        Cell at = low;
        for (;;) {
            visit(at);
            std::size_t i = 0;
            while (i < Dim && at[i] == high[i])
                at[i] = low[i], ++i;
            if (i == Dim) return;
            ++at[i];
        }
    }

    static std::uint64_t hash_of(int level, const Cell& cell) {
        std::uint64_t hash = std::uint64_t(level + 4096);
        for (const std::int32_t c : cell)
            hash = (hash ^ std::uint32_t(c)) * 0x9e3779b97f4a7c15u, hash ^= hash >> 29;
        return hash;
    }
    std::size_t bucket_of(std::uint64_t hash) const { return hash & (begins_.size() - 3); }
    static std::uint32_t tag_of(std::uint64_t hash) { return std::uint32_t(hash >> 32); }

    template <class Visit>
    void visit_cell(int level, const Cell& at, const Box& box, Visit& visit) const {
        const std::uint64_t hash = hash_of(level, at);
        const std::size_t bucket = bucket_of(hash);
        for (std::uint32_t e = begins_[bucket]; e < begins_[bucket + 1]; ++e) {
            const Entry& entry = entries_[e];
            if (entry.tag == tag_of(hash) && entry.box.intersects(box) &&
                level_of(entry.box) == level && cell_of(entry.box) == at)
                visit(entry.number, entry.box);
        }
    }

    /// That of the level of a box which has its middle.
    Cell cell_of(const Box& box) const {
        return cell_of(box.center().array(), cell_size(level_of(box)));
    }

    void sort_in(const std::vector<Entry>& entries) {
        const auto size_of = [&](std::size_t e) {
            return double(entries[e].box.sizes().maxCoeff());
        };
        const double mean = sum_of(entries.size(), size_of) / double(entries.size());
        // Smaller ones than the mean are not worth levels of their own.
        smallest_ = mean > 0 ? std::ilogb(mean) + 1 : -20;
        std::size_t size = 1;
        while (size < entries.size())
            size *= 2;
        begins_ = large_array<std::uint32_t>(size + 2, 0);
        auto hashes = large_array<std::uint64_t>(entries.size());
        for_each_element(entries.size(), [&](std::size_t e) {
            hashes[e] = hash_of(level_of(entries[e].box), cell_of(entries[e].box));
        });
        for (const std::uint64_t hash : hashes)
            ++begins_[bucket_of(hash) + 2];
        for (std::size_t b = 2; b < begins_.size(); ++b)
            begins_[b] += begins_[b - 1];
        entries_ = large_array<Entry>(entries.size());
        for (std::size_t e = 0; e < entries.size(); ++e)
            entries_[begins_[bucket_of(hashes[e]) + 1]++] = {entries[e].box, entries[e].number,
                                                             tag_of(hashes[e])};
        for (const Entry& entry : entries_)
            note_level(level_of(entry.box));
    }

    void note_level(int level) {
        const auto place = std::lower_bound(levels_.begin(), levels_.end(), level);
        if (place == levels_.end() || *place != level) levels_.insert(place, level);
    }

    int smallest_ = 0;
    std::vector<int> levels_;
    std::vector<std::uint32_t> begins_;  // of buckets, a power of two of them, and two ends
    std::vector<Entry> entries_;
};

}  // namespace laplacian_lines
