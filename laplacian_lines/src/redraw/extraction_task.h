// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_kind.h"
#include "rules/line_rules.h"

/// Plain data only, see cluster_data.h.
namespace laplacian_lines {

/// Kinds of lines that are found anew at each redraw, as strips in the clusters: the zeros of a
/// function of the vertices. Arrays by kind are in this order. What the kinds are: kinds/.
constexpr LineKind kStripKinds[] = {LineKind::Laplacian,         LineKind::Contour,
                                    LineKind::SuggestiveContour, LineKind::SuggestiveHighlight,
                                    LineKind::PhoticExtremum,    LineKind::ApparentRidge};
constexpr unsigned kStripKindCount = sizeof(kStripKinds) / sizeof(kStripKinds[0]);

/// Kinds that are found together, in one pass over the clusters: successive ones of kStripKinds. A
/// pass of which no kind is wanted costs nothing.
struct StripPass {
    unsigned first, count;
};
constexpr StripPass kStripPasses[] = {{0, 2}, {2, 2}, {4, 1}, {5, 1}};
constexpr unsigned kStripPassCount = sizeof(kStripPasses) / sizeof(kStripPasses[0]);
constexpr unsigned kMostKindsOfPass = 2;

/// Where the eye and the light are in homogeneous local coordinates (x, y, z, w), scaled so that
/// n·(eye − w p) is about in [−1, 1]; and which zeros become lines.
struct ExtractionTask {
    float eye[4], light[4];
    bool light_at_eye;
    struct Wanted {
        bool lines;                 ///< any of this kind
        float least_scaled_facing;  ///< vertices with n·eye below surely face away
        LineRules rules;
    } kinds[kStripKindCount];
};

}  // namespace laplacian_lines
