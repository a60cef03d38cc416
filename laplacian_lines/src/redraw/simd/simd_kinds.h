// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of lines that are zeros of functions of the vertices. Each is a type without members:
//  - kKind; kForms: a bit for each VertexForm that it reads, and kCurvatures;
//    kHasLeastFacing: nothing is wanted of triangles with n·eye below ExtractionTask's bound at
//    all corners,
//  - may_hold(least_facing, low, high): whether a cluster can hold a line where n·eye is within
//    these bounds, which may be NaN,
//  - find_signs(task, place, facing, values): writes the values of the function at the vertices of
//    a cluster and tells where they are negative, given where n·eye is,
//  - values(batch, number): the function's values in the whole batch,
//  - unwanted(rules, cluster, group): a bit for each triangle of the group that holds no line,
//  - source(task): the eye or light l whose S l is the gradient at a crossing,
//  - test(rules, task, batch, crossings, count): opacities of crossings, and which are accepted
//    if the rules use slopes,
//  - kSlope: what a segment's slope is.
#pragma once

#include "redraw/kinds/contours_simd.h"
#include "redraw/kinds/laplacian_lines_simd.h"
#include "redraw/kinds/photic_extrema_simd.h"
#include "redraw/kinds/suggestive_contours_simd.h"

namespace laplacian_lines {
namespace SIMD_SET {

/// The kinds of a pass.
template <unsigned Pass, class... Kinds>
struct KindList {
    static constexpr unsigned kFirst = kStripPasses[Pass].first;  ///< in kStripKinds
    static constexpr unsigned kCount = sizeof...(Kinds);
    static constexpr bool kReadsCurvatures = ((Kinds::kForms | ...) & kCurvatures) != 0;

    static constexpr bool is_as_declared() {
        unsigned number = kFirst;
        return kCount == kStripPasses[Pass].count && kCount <= kMostKindsOfPass &&
               ((Kinds::kKind == kStripKinds[number++]) && ...);
    }

    /// Calls visit(kind, number) for each kind with its place in the pass.
    template <class Visit>
    static inline void for_each(const Visit& visit) {
        unsigned number = 0;
        (visit(Kinds{}, number++), ...);
    }
};

using StandardKinds = KindList<0, LaplacianLines, Contours>;
using SuggestiveKinds = KindList<1, SuggestiveContours, SuggestiveHighlights>;
using PhoticKinds = KindList<2, PhoticExtrema>;
static_assert(StandardKinds::is_as_declared() && SuggestiveKinds::is_as_declared() &&
                  PhoticKinds::is_as_declared(),
              "the same kinds in the same order");

}  // namespace SIMD_SET
}  // namespace laplacian_lines
