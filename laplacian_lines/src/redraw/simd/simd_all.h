// SPDX-License-Identifier: GPL-3.0-or-later
// Included once by each of the files simd_*.cpp, which define SIMD_NAMESPACE and
// SIMD_SET. Nothing that is inlined elsewhere may be used here, or the linker could keep the
// copy that was compiled for a processor that is not there.
#include <initializer_list>

#include "redraw/kinds/apparent_ridges_simd.h"
#include "redraw/simd/simd_active.h"
#include "redraw/simd/simd_culling.h"
#include "redraw/simd/simd_finishing.h"
#include "redraw/simd/simd_strips.h"

namespace laplacian_lines {
namespace SIMD_NAMESPACE {

template <class Kinds>
static void extract_strips(const ClusterStore& store, const ExtractionTask& task,
                           const KeptCluster* clusters, std::size_t count, SimdMemory& memory,
                           StripOutput* outputs) {
    Batch& batch = memory.batch;
    begin_batch<Kinds>(store, clusters, count, batch);
    find_active<Kinds>(store, task, clusters, batch);
    std::uint32_t begins[Kinds::kCount];
    Kinds::for_each([&](auto kind, unsigned number) {
        begins[number] = outputs[number].strip_count;
        append_strips<Kinds, decltype(kind)>(store, task, number, memory, outputs[number]);
    });
    for (unsigned number = 0; number < Kinds::kCount; ++number)
        name_edges(store, begins[number], outputs[number]);
}

}  // namespace SIMD_NAMESPACE

extern const SimdFunctions SIMD_TABLE;
const SimdFunctions SIMD_TABLE = {
    SIMD_SET,
    {{SIMD_NAMESPACE::cull<SIMD_NAMESPACE::StandardKinds>,
      SIMD_NAMESPACE::extract_strips<SIMD_NAMESPACE::StandardKinds>},
     {SIMD_NAMESPACE::cull<SIMD_NAMESPACE::SuggestiveKinds>,
      SIMD_NAMESPACE::extract_strips<SIMD_NAMESPACE::SuggestiveKinds>},
     {SIMD_NAMESPACE::cull<SIMD_NAMESPACE::PhoticKinds>,
      SIMD_NAMESPACE::extract_strips<SIMD_NAMESPACE::PhoticKinds>},
     {SIMD_NAMESPACE::cull<SIMD_NAMESPACE::ApparentKinds>,
      SIMD_NAMESPACE::extract_apparent_strips}},
    SIMD_NAMESPACE::append_points,
    SIMD_NAMESPACE::finish_line};

}  // namespace laplacian_lines
