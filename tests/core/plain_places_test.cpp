// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles without a form of their own have no Laplacian lines.
#include "clusters/plain_places.h"

#include <gtest/gtest.h>

#include "generators.h"
#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "machined_part.h"

namespace {

using namespace laplacian_lines;

std::size_t count_plain(const TriangleMesh& input) {
    const PreparedMesh mesh = prepare_mesh(input, Cuts::Left);
    const PlainPlaces places(mesh);
    std::size_t count = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        count += places.contain(t);
    return count;
}

TEST(PlainPlaces, TellFacesFromEdges) {
    const PreparedMesh mesh = prepare_mesh(test_meshes::cube(10), Cuts::Left);
    const PlainPlaces places(mesh);
    for (std::size_t v = 0; v < mesh.size(); ++v) {
        const double farthest = mesh.positions[v].cwiseAbs().maxCoeff();
        const auto at_end = (mesh.positions[v].cwiseAbs().array() > farthest - 1e-9).count();
        EXPECT_EQ(places.around(v), at_end > 1 ? Around::Sharp : Around::Flat);
    }
}

TEST(PlainPlaces, AreWholeFlatFaces) {
    for (const int cells : {1, 2, 10})  // triangles are long, those at edges too
        EXPECT_EQ(count_plain(test_meshes::cube(cells)), std::size_t(12 * cells * cells));
    const std::size_t cells = 64;  // those at edges are not
    EXPECT_EQ(count_plain(test_meshes::cube(64)), 12 * (cells - 2) * (cells - 2));
    EXPECT_EQ(count_plain(test_meshes::sharp_part()), 180u);
}

TEST(PlainPlaces, AreNotOnRoundFormsNorWithoutEdges) {
    for (const char* name : {"plane", "rounded_cube", "sphere", "torus_jittered", "ellipsoid",
                             "bumpy_sphere", "hills"})
        EXPECT_EQ(count_plain(test_meshes::mesh_named(name).mesh), 0u) << name;
}

std::size_t count_laplacian_lines(const TriangleMesh& mesh, bool creases) {
    LineStyle style = helpers::all_laplacian_lines();
    style.shows[LineKind::Crease] = creases;
    const LineExtractor extractor(mesh, precompute(mesh));
    std::size_t count = 0;
    for (const View& view : helpers::random_views(mesh, 6))
        for (const Polyline& line : helpers::extract(extractor, view, style).lines)
            count += line.kind == LineKind::Laplacian;
    return count;
}

TEST(PlainPlaces, HaveNoLaplacianLinesWhereCreasesAreShown) {
    for (const TriangleMesh& mesh :
         {test_meshes::cube(1), test_meshes::cube(10), test_meshes::sharp_part()}) {
        EXPECT_GT(count_laplacian_lines(mesh, false), 0u);
        EXPECT_EQ(count_laplacian_lines(mesh, true), 0u);
    }
}

/// Nor do triangles of both orientations make an edge.
TEST(PlainPlaces, AreNotWhereTrianglesFaceOtherWays) {
    EXPECT_EQ(count_plain(test_meshes::mesh_named("flipped_torus").mesh), 0u);
}

}  // namespace
