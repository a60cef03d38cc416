// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/line_style.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

/// The extraction written down plainly: one loop over all triangles, crossings and chains by maps.
/// What LineExtractor is compared with.
namespace reference {

struct PlainLine {
    std::vector<laplacian_lines::LinePoint> points;
    laplacian_lines::Polyline polyline;
    bool uncertain;  ///< a sum is so near to its threshold that rounding decides
};

/// The lines of a view, those of uncertain acceptance included.
std::vector<PlainLine> extract_plainly(const laplacian_lines::TriangleMesh& mesh,
                                       const laplacian_lines::Field& field,
                                       const laplacian_lines::View& view,
                                       const laplacian_lines::LineStyle& style);

}  // namespace reference
