// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/surface.h"

#include <Eigen/Geometry>

#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

std::vector<Triangle> triangles_of(const std::vector<PlacedCluster>& clusters) {
    const PlacedCluster* last = clusters.empty() ? nullptr : &clusters.back();
    auto triangles = large_array<Triangle>(
        last ? last->first_triangle + std::size_t(last->cluster->triangle_count) : 0);
    in_parallel(clusters.size(), [&](std::size_t c) {
        for (unsigned t = 0; t < clusters[c].cluster->triangle_count; ++t)
            for (unsigned k = 0; k < 3; ++k)
                triangles[clusters[c].first_triangle + t][k] =
                    clusters[c].vertices[clusters[c].triangle(t).corners[k]];
    });
    return triangles;
}

/// By vertex; in several clusters a vertex has equal records.
std::vector<const VertexRecord*> records_of(const ExtractorData& data,
                                            const std::vector<PlacedCluster>& clusters) {
    std::vector<const VertexRecord*> records(data.vertex_count);
    for (const PlacedCluster& placed : clusters)
        for (unsigned v = 0; v < placed.cluster->vertex_count; ++v)
            records[placed.vertices[v]] = placed.records + v;
    return records;
}

}  // namespace

Surface::Surface(const ExtractorData& data)
    : triangles_(triangles_of(place_clusters(data))),
      records_(records_of(data, place_clusters(data))),
      sides_(triangles_, data.vertex_count),
      facets_(large_array<Facet>(triangles_.size())) {
    for_each_element(facets_.size(), [&](std::size_t t) {
        const Triangle& corners = triangles_[t];
        const Eigen::Vector3f a = position(corners[0]), b = position(corners[1]),
                              c = position(corners[2]);
        const Eigen::Vector3f product = (b - a).cross(c - a);
        const float length = length_of(product);
        facets_[t] = {length > 0 ? Eigen::Vector3f(product / length) : Eigen::Vector3f::Zero(),
                      (a + b + c) / 3, length / 2};
    });
}

}  // namespace laplacian_lines
