// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/curvature_records.h"

#include "clusters/bounded.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr double kLargestDerivative = 1e16;

}  // namespace

std::vector<CurvatureRecord> curvature_records(const PreparedMesh& mesh, const Field& field,
                                               const ExtractorData& data) {
    std::vector<CurvatureRecord> records(data.vertices_of_clusters.size());
    const double d = data.diagonal;
    const std::vector<PlacedCluster> clusters = place_clusters(data);
    in_parallel(clusters.size(), [&](std::size_t c) {
        const Cluster& cluster = *clusters[c].cluster;
        for (unsigned i = 0; i < cluster.vertex_count; ++i) {
            const std::uint32_t v = mesh.original_vertex[clusters[c].vertices[i]];
            CurvatureRecord& record = records[cluster.first_vertex + i];
            const Eigen::Vector3f position = position_of(clusters[c].records[i]),
                                  normal = normal_of(clusters[c].records[i]);
            for (int k = 0; k < 3; ++k) {
                record.position[k] = position[k];
                record.normal[k] = normal[k];
                record.curvature[k] =
                    float(bounded(field.smooth_curvatures[v][k] * d, kLargestCurvature));
            }
            for (int k = 0; k < 4; ++k)
                record.derivative[k] =
                    float(bounded(field.curvature_derivatives[v][k] * d * d, kLargestDerivative));
        }
    });
    return records;
}

}  // namespace laplacian_lines
