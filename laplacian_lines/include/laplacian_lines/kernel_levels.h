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

/// The kernel sizes used when the kernel follows the size of the mesh on the screen: even steps
/// from the smallest, level 0, up to the largest that drawings have.
class KernelLevels {
public:
    KernelLevels() = default;
    /// Both in mesh units.
    KernelLevels(double mean_edge, double diagonal);

    int count() const { return steps_ + 1; }
    double size(int level) const;  ///< √h, mesh units

    /// The levels of a drawing that asks for this √h, the first in full: the nearest one, or two
    /// halfway between them, where the next comes in before the other goes, so that lines they
    /// share stay put. A continuous function of the size, without memory. NaN asks for level 0.
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

/// Replaces `lines` with those of one or two kernels: of the second only its Laplacian lines, since
/// the rest does not depend on the kernel. `others` is scratch. See LineExtractor::extract().
void extract_kernels(const LineExtractor& extractor, const View& view, const LineStyle& style,
                     const std::vector<DrawnKernel>& kernels, ExtractionScratch& scratch,
                     LineSet& others, LineSet& lines);

}  // namespace laplacian_lines
