// SPDX-License-Identifier: GPL-3.0-or-later
// Redraws have the same bits with every instruction set that this processor runs.
#include <gtest/gtest.h>

#include "helpers.h"
#include "redraw/simd/simd_functions.h"

namespace {

using namespace laplacian_lines;

class WithInstructionSet {
public:
    explicit WithInstructionSet(InstructionSet set)
        : before_(simd_functions().instruction_set), is_there(use_instruction_set(set)) {}
    ~WithInstructionSet() { use_instruction_set(before_); }

private:
    const InstructionSet before_;

public:
    const bool is_there;
};

TEST(InstructionSets, GiveTheSameBits) {
    LineStyle whole = helpers::all_kinds();
    whole.whole_lines = true;
    int others = 0;
    for (const char* name :
         {"bumpy_sphere", "half_torus", "three_sheets", "flipped_torus", "cube"}) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        const LineExtractor extractor(mesh, helpers::complete_field(mesh));
        for (const View& view : helpers::random_views(mesh, 12))
            for (const LineStyle& style :
                 {LineStyle(), whole, helpers::all_crossings_of_all_kinds()}) {
                const LineSet best = helpers::extract(extractor, view, style);
                for (const InstructionSet set : {InstructionSet::Baseline, InstructionSet::Avx2}) {
                    const WithInstructionSet scope(set);
                    if (!scope.is_there) continue;
                    ++others;
                    EXPECT_TRUE(helpers::same_lines(best, helpers::extract(extractor, view, style)))
                        << name << ", instruction set " << int(set);
                }
            }
    }
    EXPECT_GT(others, 0);
}

}  // namespace
