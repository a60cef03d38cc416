// SPDX-License-Identifier: GPL-3.0-or-later
#include <initializer_list>

#include "redraw/simd/simd_active.h"
#include "redraw/simd/simd_apparent.h"
#include "redraw/simd/simd_finishing.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace SIMD_SET {

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

}  // namespace SIMD_SET

template <>
const RedrawLoops& functions_of<RedrawLoops, InstructionSet::SIMD_SET>() {
    using namespace SIMD_SET;
    static constexpr RedrawLoops functions = {
        {{cull<StandardKinds>, extract_strips<StandardKinds>},
         {cull<SuggestiveKinds>, extract_strips<SuggestiveKinds>},
         {cull<PhoticKinds>, extract_strips<PhoticKinds>},
         {cull<ApparentKinds>, extract_apparent_strips}},
        append_points,
        finish_line};
    return functions;
}

}  // namespace laplacian_lines
