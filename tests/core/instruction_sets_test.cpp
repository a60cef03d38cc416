// SPDX-License-Identifier: GPL-3.0-or-later
// Redraws have the same bits with every instruction set that this processor runs.
#include <gtest/gtest.h>

#include "helpers.h"
#include "with_instruction_set.h"

namespace {

using namespace laplacian_lines;

TEST(InstructionSets, GiveTheSameBits) {
    if (narrower_sets().empty()) GTEST_SKIP() << "there is one";
    LineStyle whole = helpers::all_kinds();
    whole.whole_lines = true;
    for (const char* name :
         {"bumpy_sphere", "half_torus", "three_sheets", "flipped_torus", "cube"}) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        const LineExtractor extractor(mesh, helpers::complete_field(mesh));
        for (const View& view : helpers::random_views(mesh, 12))
            for (const LineStyle& style :
                 {LineStyle(), whole, helpers::all_crossings_of_all_kinds()}) {
                const LineSet best = helpers::extract(extractor, view, style);
                for (const InstructionSet set : narrower_sets()) {
                    const WithInstructionSet scope(set);
                    EXPECT_TRUE(helpers::same_lines(best, helpers::extract(extractor, view, style)))
                        << name << ", instruction set " << int(set);
                }
            }
    }
}

}  // namespace
