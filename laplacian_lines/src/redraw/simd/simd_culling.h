// SPDX-License-Identifier: GPL-3.0-or-later
// Leaves out whole clusters by bounds of n·l.
#pragma once

#include <cstddef>
#include <cstdint>

#include "redraw/simd/simd_kinds.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// More than rounding does to a sum of products of about 1 with what it is a factor of.
constexpr float kRoundingMargin = 1e-5f;

struct Rows {
    Floats x, y, z;
};

/// Bounds of n·(e − w p) over the vertices of kFormGroup clusters.
struct FacingRange {
    alignas(kCacheUnit) float low[kFormGroup], high[kFormGroup];
};
static inline FacingRange bound_facing(const FacingBounds& bounds, const float eye[4],
                                       std::size_t first) {
    const float ex = eye[0], ey = eye[1], ez = eye[2], w = eye[3];
    const float summed =
        __builtin_fabsf(ex) + __builtin_fabsf(ey) + __builtin_fabsf(ez) + __builtin_fabsf(w);
    FacingRange range;
    for (unsigned i = 0; i < kFormGroup; i += kLanes) {
        const std::size_t c = first + i;
        const auto row = [&](const float* const vector[3]) {
            return Rows{load_anywhere(vector[0] + c), load_anywhere(vector[1] + c),
                        load_anywhere(vector[2] + c)};
        };
        const Rows centre = row(bounds.centre), n = row(bounds.normal);
        const Floats x = ex - w * centre.x, y = ey - w * centre.y, z = ez - w * centre.z;
        const auto towards = [&](const Rows& v) { return v.x * x + v.y * y + v.z * z; };
        Floats reach = w * load_anywhere(bounds.height_range + c);
        Floats size = absolute(n.x) + absolute(n.y) + absolute(n.z);
        for (const auto& axis : bounds.axes) {
            const Rows a = row(axis);
            reach += absolute(towards(a));
            size += absolute(a.x) + absolute(a.y) + absolute(a.z);
        }
        // The forms are summed from e and n·p, which may be larger than what is left of them.
        reach += kRoundingMargin * size * summed;
        const Floats middle = towards(n) - w * load_anywhere(bounds.height + c);
        store(range.low + i, middle - reach);
        store(range.high + i, middle + reach);
    }
    return range;
}

template <class Kinds>
static std::size_t cull(const ClusterStore& store, const ExtractionTask& task, std::size_t begin,
                        std::size_t end, KeptCluster* kept) {
    std::size_t count = 0;
    for (std::size_t first = begin; first < end; first += kFormGroup) {
        const FacingRange facing = bound_facing(store.facing, task.eye, first);
        for (unsigned i = 0; i < kFormGroup && first + i < end; ++i) {
            const float low = facing.low[i], high = facing.high[i];
            KeptCluster& cluster = kept[count];
            cluster.number = std::uint32_t(first + i);
            bool any = false, front = low >= 0;
            // Refused by what is certain, so that nothing is where numbers are out of range.
            Kinds::for_each([&](auto kind, unsigned number) {
                const ExtractionTask::Wanted& wanted = task.kinds[Kinds::kFirst + number];
                const bool may_hold =
                    wanted.lines & kind.may_hold(wanted.least_scaled_facing, low, high);
                cluster.may_hold[number] = may_hold;
                any |= may_hold;
                front &= low >= wanted.least_scaled_facing;
            });
            cluster.test_facing = !front;
            count += any;
        }
    }
    return count;
}

}  // namespace SIMD_SET
}  // namespace laplacian_lines
