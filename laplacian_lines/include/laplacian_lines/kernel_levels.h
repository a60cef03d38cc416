// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_extractor.h"

namespace laplacian_lines {

/// A level of KernelLevels in a drawing.
struct LevelShare {
    int level;
    double share;  ///< of its lines' full width and opacity, 0..1
};

/// The kernel sizes in which lines of one mesh are drawn where they follow its size on the screen:
/// even steps from the least one, level 0, to the largest that drawings have.
class KernelLevels {
public:
    KernelLevels() = default;
    /// Mesh units.
    KernelLevels(double mean_edge, double diagonal);

    int count() const { return steps_ + 1; }
    double size(int level) const;  ///< √h, mesh units

    /// The levels of a drawing that asks for this √h, the first one in full: the nearest one, or
    /// two in the middle between them. There the next one comes first and the other goes then, so
    /// that what both have stays as it is. A continuous function of the size and of nothing else,
    /// so passing to and fro needs no memory of the last redraw. Sizes that are no number ask for
    /// level 0.
    std::vector<LevelShare> at(double wanted) const;

private:
    double least_ = 0, step_ = 1;
    int steps_ = 0;
};

/// A kernel in a drawing.
struct DrawnKernel {
    double size = 0;                             ///< √h, mesh units; 0: the extractor's own
    const KernelLaplacian* laplacian = nullptr;  ///< null: likewise
    double share = 1;                            ///< as LevelShare::share, 1 of the first
};

/// Replaces `lines` with those of one or two kernels. What does not depend on the kernel comes with
/// the first; Laplacian lines of the second are appended. `others` is memory to work in. See
/// LineExtractor::extract().
void extract_kernels(const LineExtractor& extractor, const View& view, const LineStyle& style,
                     const std::vector<DrawnKernel>& kernels, ExtractionScratch& scratch,
                     LineSet& others, LineSet& lines);

}  // namespace laplacian_lines
