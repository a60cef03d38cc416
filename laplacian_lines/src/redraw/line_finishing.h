// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/extractor_data.h"
#include "redraw/strip_tracing.h"

namespace laplacian_lines {

/// Where parts of whole lines turn back sharply. Beyond a hairpin a line is its own companion on
/// the convex side, which is drawn only as far as it is clear by itself.
class Hairpins {
public:
    /// Points [begin, end) of a line.
    struct Range {
        std::uint32_t begin, end;
    };

    /// Whether there are any among `count` points.
    bool find(const LineColumns& line, std::uint32_t count, float kernel_size);
    /// Lets opacities fade towards what find() found and beyond it, and finds the ranges between
    /// hairpins. `starts`: how clear the line is by itself, by point.
    void fade(const float* starts, float* opacities);
    const std::vector<Range>& ranges() const { return ranges_; }

private:
    /// Points between the sharpest ones of two turns.
    struct Limb {
        std::uint32_t begin, end;
        float passes;  ///< how much goes on from the limb before
        float carried;
    };
    void measure(const LineColumns& line);
    void split(const float* starts);
    float carry();

    std::vector<float> lengths_;  ///< from the first point to each
    std::vector<float> passes_;   ///< 0 at a hairpin, 1 away from any, by point
    std::vector<Limb> limbs_;
    std::vector<Range> ranges_;
};

/// What a thread finishes lines in; keeps its memory.
struct FinishingThread {
    static constexpr std::size_t kUnitFloats = kCacheUnit / sizeof(float);
    struct alignas(kCacheUnit) Unit {
        float floats[kUnitFloats];
    };
    std::vector<Unit> columns;
    Hairpins hairpins;
    std::vector<std::uint32_t> cut_lines;  ///< first points of lines that hairpins cut
    std::vector<Polyline> cut_parts;       ///< what is left of them
};
using FinishingMemory = std::vector<FinishingThread>;

/// Replaces `lines` by the traced lines: their points in mesh coordinates, tapered and smoothed.
void finish_lines(const ExtractorData& data, const TracedLines& traced, FinishingMemory& memory,
                  LineSet& lines);

}  // namespace laplacian_lines
