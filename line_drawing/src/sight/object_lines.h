// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/progress.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// The lines within objects' faces, from fields as fine as the scale asks for. Objects outlive
/// this.
class ObjectLines {
public:
    explicit ObjectLines(const Objects& objects) : objects_(objects) {}

    /// Computes the fields for `scale`, mm on paper per mm of the object, unless given or kept.
    /// @throws laplacian_lines::Error, naming the object
    void makeReady(const SheetOptions& options, double scale,
                   const laplacian_lines::Progress& progress);

    /// One set per object, for LineVisibility.
    std::vector<laplacian_lines::LineSet> extract(const laplacian_lines::View& view,
                                                  const laplacian_lines::LineStyle& style);

    /// What users should know of the objects' meshes.
    std::vector<std::string> remarks() const { return remarks_; }

    /// The largest √h, mesh units.
    double kernelSize() const { return kernel_size_; }

private:
    const Objects& objects_;
    laplacian_lines::PrecomputeOptions made_;  ///< of the extractors
    std::vector<laplacian_lines::LineExtractor> extractors_;
    double kernel_size_ = 0;
    std::vector<std::string> remarks_;
    laplacian_lines::ExtractionScratch scratch_;
};

}  // namespace line_drawing
