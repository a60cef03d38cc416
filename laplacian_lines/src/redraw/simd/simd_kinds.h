// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of lines that are zeros of functions of the vertices. Each is a type without members:
//  - kKind; kForms: a bit for each VertexForm that it reads; kHasLeastFacing: nothing is wanted of
//    triangles with n·eye below ExtractionTask's bound at all corners,
//  - may_hold(least_facing, low, high): whether a cluster can hold a line where n·eye is within
//    these bounds, which may be NaN,
//  - find_signs(task, place, facing, values): writes the values of the function at the vertices of
//    a cluster and tells where they are negative, given where n·eye is,
//  - values(batch, number): the function's values in the whole batch,
//  - unwanted(rules, cluster, group): a bit for each triangle of the group that holds no line,
//  - source(task): the eye or light l whose S l is the gradient at a crossing,
//  - test(rules, task, records, crossings, count): opacities of crossings, and which are accepted
//    if the rules use slopes.
// Included once by each of the files simd_*.cpp.
#pragma once

#include "redraw/kinds/contours_simd.h"
#include "redraw/kinds/laplacian_lines_simd.h"

namespace laplacian_lines {
namespace SIMD_NAMESPACE {

template <class... Kinds>
struct KindList {
    static constexpr bool is(const LineKind (&order)[sizeof...(Kinds)]) {
        unsigned number = 0;
        return ((Kinds::kKind == order[number++]) && ...);
    }

    template <class Visit>
    static inline void for_each(const Visit& visit) {
        unsigned number = 0;
        (visit(Kinds{}, number++), ...);
    }
};

using StripKinds = KindList<LaplacianLines, Contours>;
static_assert(StripKinds::is(kStripKinds), "the same kinds in the same order");

/// Calls visit(kind, number) for each kind.
template <class Visit>
static inline void for_each_kind(const Visit& visit) {
    StripKinds::for_each(visit);
}

}  // namespace SIMD_NAMESPACE
}  // namespace laplacian_lines
