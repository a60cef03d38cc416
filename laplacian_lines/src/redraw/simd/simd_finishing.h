// SPDX-License-Identifier: GPL-3.0-or-later
// Weights, opacities and smoothed positions of whole lines, as columns.
#pragma once

#include "redraw/simd/redraw_loops.h"
#include "system/simd_vectors.h"

namespace laplacian_lines {
namespace SIMD_SET {

constexpr int kTaperingPasses = 2;  // slopes of neighbouring triangles differ visibly

static inline float within01(float v) {
    return v < 0 ? 0 : v > 1 ? 1 : v;
}
static inline Floats within01(Floats v) {
    return v < 0 ? Floats{} : v > 1 ? Floats{} + 1 : v;
}

/// 0 at the threshold, 1 at (1 + fading) times it; 1 where there is no threshold.
static inline float above(float value, float threshold, float fading) {
    const float range = threshold * fading;
    return range > 0 ? within01((value - threshold) / range) : 1.f;
}

/// What stands in for the point beyond an open end.
enum class LineEnd {
    Repeated,   ///< the last value again: values change evenly up to the end
    Reflected,  ///< the point before it, mirrored in the end: ends stay where they are
};

/// Fills in `reach` places before a column's values and after them. Values that places are filled
/// from may be such places themselves, where a line is short.
static inline void extend(float* values, std::size_t count, bool closed, LineEnd end, int reach) {
    float* const last = values + count - 1;
    for (int k = 1; k <= reach; ++k) {
        if (closed) {
            values[-k] = last[-k];
            last[k] = values[k];
        } else if (end == LineEnd::Repeated) {
            values[-k] = values[k - 1];
            last[k] = last[1 - k];
        } else {
            values[-k] = 2 * values[0] - values[k];
            last[k] = 2 * last[0] - last[-k];
        }
    }
}

/// Several passes of binomial smoothing (1-2-1) in one, of an extended column.
template <int Passes>
static inline void smooth_once(const float* from, std::size_t count, float* to) {
    constexpr float weights[3][4] = {{2 / 4.f, 1 / 4.f},
                                     {6 / 16.f, 4 / 16.f, 1 / 16.f},
                                     {20 / 64.f, 15 / 64.f, 6 / 64.f, 1 / 64.f}};
    for (std::size_t i = 0; i < count; i += kLanes) {
        Floats sum = weights[Passes - 1][0] * load(from + i);
        for (int k = 1; k <= Passes; ++k)
            sum += weights[Passes - 1][k] *
                   (load_anywhere(from + i - k) + load_anywhere(from + i + k));
        store(to + i, sum);
    }
}

/// Passes of binomial smoothing of a column of `count` values, which has places before and after
/// them, as `spare` does; the two may be swapped. A closed line's first value and its copy stay
/// equal. Values stay as they are where `exact`, a column like them, is not 0; none is if it is
/// null.
static inline void smooth(float*& values, float*& spare, std::size_t count, bool closed,
                          LineEnd end, int passes, const float* exact = nullptr) {
    while (passes > 0) {
        const int at_once = exact ? 1 : passes < 3 ? passes : 3;
        extend(values, count, closed, end, at_once);
        constexpr decltype(&smooth_once<1>) several[] = {smooth_once<1>, smooth_once<2>,
                                                         smooth_once<3>};
        several[at_once - 1](values, count, spare);
        if (exact)
            for (std::size_t i = 0; i < count; i += kLanes)
                store(spare + i, load(exact + i) != 0 ? load(values + i) : load(spare + i));
        float* const result = spare;
        spare = values;
        values = result;
        passes -= at_once;
    }
}

/// Weights that hold the slope of the segment that ends at a point become 0 where both of a point's
/// segments may be moved.
static inline void slopes_to_exact(std::size_t count, bool closed, float* weights) {
    const std::size_t last = count - 1;
    weights[0] = closed ? weights[last] : 0;
    for (std::size_t i = 0; i < last; ++i)
        weights[i] += weights[i + 1];
    if (closed) weights[last] = weights[0];
}

/// Weights hold the slope of the segment that ends at a point; then the means of its segments.
static inline void slopes_to_means(std::size_t count, bool closed, float* weights, float* spare) {
    const std::size_t last = count - 1;
    weights[0] = closed ? weights[last] : weights[1];
    weights[count] = closed ? weights[1] : weights[last];
    for (std::size_t i = 0; i < count; i += kLanes)
        store(spare + i, (load(weights + i) + load_anywhere(weights + i + 1)) / 2);
}

/// Lets open ends run out over `length`; `step` leads from the end to the inside.
static inline void fade_end(const LineColumns& c, std::ptrdiff_t from, std::ptrdiff_t to, int step,
                            float length) {
    float distance = 0;
    std::ptrdiff_t before = from;
    for (std::ptrdiff_t i = from; distance < length; i += step) {
        const float x = c.x[i] - c.x[before], y = c.y[i] - c.y[before], z = c.z[i] - c.z[before];
        distance += __builtin_sqrtf(x * x + y * y + z * z);
        before = i;
        const float faded = distance / length;
        c.opacity[i] *= faded < 1 ? faded : 1;
        if (i == to) return;
    }
}

/// Weights and opacities of a line from slopes and from the fading of its crossings. `whole` is
/// the opacity of the line as a whole.
static inline void taper(const LineRules& rules, std::size_t count, bool closed, float whole,
                         LineColumns& c) {
    const auto last = std::ptrdiff_t(count) - 1;
    const float first_opacity = c.opacity[0], last_opacity = c.opacity[last];
    slopes_to_means(count, closed, c.weight, c.spare);
    float* slopes = c.spare;
    const float range = rules.segment_slope * rules.fading;
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Floats over = load(slopes + i) - rules.segment_slope;
        const Floats faded = range > 0 ? within01(over / range) : Floats{} + 1;
        store(c.opacity + i, load(c.opacity + i) * (whole * faded));
        store(c.weight + i, within01(over / rules.full_slope));
    }
    for (float** column : {&c.weight, &c.opacity})
        smooth(*column, c.spare, count, closed, LineEnd::Repeated, kTaperingPasses);
    if (!closed && rules.end_length > 0) {
        // Where nothing is seen of the end itself, the line has faded before.
        if (first_opacity > 0) fade_end(c, 0, last, 1, rules.end_length);
        if (last_opacity > 0) fade_end(c, last, 0, -1, rules.end_length);
    }
}

typedef double FloatsAsDoubles __attribute__((vector_size(8 * kLanes)));
/// Columns to points in mesh coordinates, as LinePoint's six floats.
static inline void write_points(const LineColumns& c, std::size_t count, const double centre[3],
                                double diagonal, float* points) {
    float* const positions[3] = {c.x, c.y, c.z};
    for (int k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < count; i += kLanes) {
            const auto local = __builtin_convertvector(load(positions[k] + i), FloatsAsDoubles);
            store(positions[k] + i, __builtin_convertvector(centre[k] + diagonal * local, Floats));
        }
    const float* const columns[6] = {c.x, c.y, c.z, c.weight, c.gradient, c.opacity};
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 6; ++k)
            points[6 * i + k] = columns[k][i];
}

static void finish_line(const LineRules& rules, const LineSums& line, LineColumns& c,
                        const double centre[3], double diagonal, float* points) {
    const std::size_t count = line.count;
    const bool closed = line.closed;
    const float* exact = nullptr;
    if (rules.use_slope) {
        // A line that only just passes the tests on whole lines is hardly seen, so that it does
        // not jump into the picture when the view turns a little further.
        const float by_slope = above(line.slope, rules.line_slope, rules.fading);
        const float by_length = above(line.length, rules.least_length, rules.fading);
        const float by_strength = above(line.strength, rules.least_strength, rules.fading);
        const float least = by_slope < by_length ? by_slope : by_length;
        taper(rules, count, closed, least < by_strength ? least : by_strength, c);
    } else {
        float* const opacities = c.opacity;
        c.opacity = c.weight;
        c.weight = opacities;
        smooth(c.weight, c.spare, count, closed, LineEnd::Repeated, kTaperingPasses);
        if (line.has_exact) {
            slopes_to_exact(count, closed, c.opacity);
            exact = c.opacity;
        }
    }
    for (float** column : {&c.x, &c.y, &c.z})
        smooth(*column, c.spare, count, closed, LineEnd::Reflected, rules.smoothing_passes, exact);
    if (!rules.use_slope)
        for (std::size_t i = 0; i < count; i += kLanes)
            store(c.opacity + i, Floats{} + 1);
    write_points(c, count, centre, diagonal, points);
}

}  // namespace SIMD_SET
}  // namespace laplacian_lines
