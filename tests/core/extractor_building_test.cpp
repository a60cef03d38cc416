// SPDX-License-Identifier: GPL-3.0-or-later
// Clusters: the same bits with any number of threads, and the neighbours that a plain count finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

#include "clusters/cluster_data.h"
#include "clusters/extractor_data.h"
#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"
#include "mesh/prepared_mesh.h"
#include "with_threads.h"

namespace {

using namespace laplacian_lines;

ExtractorData build(const TriangleMesh& mesh, const Field& field, int threads) {
    const test_meshes::WithThreads scope(threads);
    return build_extractor_data(mesh, field);
}

bool same_clusters(const ExtractorData& a, const ExtractorData& b) {
    const auto same = [](const Cluster& x, const Cluster& y) {
        return x.first_unit == y.first_unit && x.first_border_edge == y.first_border_edge &&
               x.vertex_count == y.vertex_count && x.triangle_count == y.triangle_count &&
               std::equal(std::begin(x.convex), std::end(x.convex), y.convex);
    };
    return std::equal(a.clusters.begin(), a.clusters.end(), b.clusters.begin(), b.clusters.end(),
                      same);
}

bool same_data(const ExtractorData& a, const ExtractorData& b) {
    return same_clusters(a, b) && a.bytes_of_clusters == b.bytes_of_clusters &&
           std::memcmp(a.memory_of_clusters.get(), b.memory_of_clusters.get(),
                       a.bytes_of_clusters) == 0 &&
           a.vertices_of_clusters == b.vertices_of_clusters && a.border_edges == b.border_edges &&
           a.border_edge_count == b.border_edge_count && a.bounds == b.bounds;
}

void expect_same_data(const TriangleMesh& mesh, const std::string& name) {
    const Field field = precompute(mesh);
    const ExtractorData one = build(mesh, field, 1);
    for (int threads : {1, 2, 3, 7})
        EXPECT_TRUE(same_data(one, build(mesh, field, threads))) << name << ", " << threads;
}

TEST(ExtractorBuilding, DoesNotDependOnTheNumberOfThreads) {
    for (const char* name : {"hills", "five_sheets", "flipped_torus", "dirty_torus",
                             "triangle_soup", "single_triangle"})
        expect_same_data(test_meshes::mesh_named(name).mesh, name);
    // Enough triangles for several threads.
    expect_same_data(test_meshes::bumpy_sphere(6, 0.15).mesh, "bumpy sphere");
}

/// Nor the rest of the large page they end in.
TEST(ExtractorBuilding, HoldsWhatClustersNeed) {
    const TriangleMesh mesh = test_meshes::bumpy_sphere(6, 0.15).mesh;
    const ExtractorData data = build(mesh, precompute(mesh), 2);
    const Cluster& last = data.clusters.back();
    EXPECT_EQ(data.bytes_of_clusters,
              last.first_unit * std::size_t(kCacheUnit) + cluster_layout(last).end);
}

/// As if the field had had them from the start.
TEST(ExtractorBuilding, DerivativesCanBeAddedLater) {
    for (const char* name : {"hills", "dirty_torus", "torus"}) {
        const TriangleMesh mesh = test_meshes::mesh_named(name).mesh;
        Field field = precompute(mesh);
        LineExtractor extractor(mesh, field);
        const std::size_t before = extractor.memory();
        const std::vector<View> views = helpers::random_views(mesh, 4);
        const LineStyle style = helpers::all_kinds();
        const LineSet without = helpers::extract(extractor, views[0], style);
        EXPECT_THROW(extractor.add_derivatives(mesh, field), Error) << "it has none";
        add_curvature_derivatives(mesh, field);
        EXPECT_THROW(
            extractor.add_derivatives(test_meshes::mesh_named("single_triangle").mesh, field),
            Error);
        EXPECT_TRUE(helpers::same_lines(helpers::extract(extractor, views[0], style), without));
        extractor.add_derivatives(mesh, field);
        EXPECT_GT(extractor.memory(), before);
        const LineExtractor whole(mesh, field);
        for (const View& view : views)
            EXPECT_TRUE(helpers::same_lines(helpers::extract(extractor, view, style),
                                            helpers::extract(whole, view, style)))
                << name;
        EXPECT_FALSE(helpers::same_lines(helpers::extract(extractor, views[0], style), without));
    }
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // from a vertex to the next one

Edge undirected(Edge edge) {
    return std::minmax(edge.first, edge.second);
}

struct Neighbours {
    std::map<Edge, int> ends;                           ///< sides where lines end
    std::map<Edge, int> inner;                          ///< sides with a neighbour in the cluster
    std::map<std::uint32_t, std::vector<Edge>> shared;  ///< by number
};

Neighbours read_neighbours(const ExtractorData& data) {
    Neighbours result;
    const std::uint32_t* vertices = data.vertices_of_clusters.data();
    for (const Cluster& cluster : data.clusters) {
        const ClusterTriangles triangles = triangles_of(data.store(), cluster);
        const auto side = [&](unsigned t, unsigned k) {
            const auto& corners = triangle_at(triangles, t).corners;
            return Edge(vertices[corners[k]], vertices[corners[(k + 1) % 3]]);
        };
        for (unsigned t = 0; t < cluster.triangle_count; ++t)
            for (unsigned k = 0; k < 3; ++k) {
                const unsigned next = triangle_at(triangles, t).neighbours[k];
                if (next == kNoNeighbour) {
                    ++result.ends[undirected(side(t, k))];
                } else if (next >= cluster.triangle_count) {
                    const std::size_t place =
                        cluster.first_border_edge + next - cluster.triangle_count;
                    result.shared[data.border_edges[place]].push_back(side(t, k));
                } else {
                    ++result.inner[undirected(side(t, k))];
                    const Edge back(side(t, k).second, side(t, k).first);
                    EXPECT_TRUE(side(next, 0) == back || side(next, 1) == back ||
                                side(next, 2) == back);
                }
            }
        vertices += cluster.vertex_count;
    }
    return result;
}

class ClusterNeighbours : public testing::TestWithParam<const test_meshes::MeshEntry*> {};

INSTANTIATE_TEST_SUITE_P(Meshes, ClusterNeighbours, testing::ValuesIn(test_meshes::meshes_with(0)),
                         [](const auto& info) { return info.param->name; });

TEST_P(ClusterNeighbours, AreTheTwoTrianglesOfAnEdge) {
    const TriangleMesh& mesh = GetParam()->get().mesh;
    std::map<Edge, int> count;
    for (const Triangle& t : prepare_mesh(mesh, Cuts::Stitched).triangles)
        for (std::size_t k = 0; k < 3; ++k)
            ++count[undirected({t[k], t[(k + 1) % 3]})];

    const Neighbours found = read_neighbours(build_extractor_data(mesh, precompute(mesh)));
    std::map<Edge, int> sides = found.ends;
    for (const auto& [edge, n] : found.ends)
        EXPECT_NE(count[edge], 2);
    for (const auto& [edge, n] : found.inner) {
        EXPECT_EQ(n, 2);
        sides[edge] += n;
    }
    for (const auto& [number, edges] : found.shared) {
        ASSERT_EQ(edges.size(), 2u);
        EXPECT_EQ(undirected(edges[0]), undirected(edges[1]));
        EXPECT_EQ(count[undirected(edges[0])], 2);
        sides[undirected(edges[0])] += 2;
    }
    EXPECT_EQ(sides, count);
}

}  // namespace
