// SPDX-License-Identifier: GPL-3.0-or-later
// The angles of candidates of ridges and valleys against the plain ones of plain_ridge_angles.h.
#include "plain_ridge_angles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixed/ridge_candidates.h"
#include "flaked_stone.h"
#include "generators.h"
#include "laplacian_lines/precompute.h"
#include "mesh_noise.h"

namespace {

using namespace laplacian_lines;
using reference::PlainRidgeAngles;
using reference::RidgeAngle;
using reference::RidgePoint;

constexpr double kAngleError = 0.02;  // degrees
constexpr double kPlaceError = 3e-5;  // D; the fast search of a middle ends at 2e-5

struct Count {
    std::size_t points = 0, others = 0;
    std::size_t clear = 0;  // of an angle that counts
};

/// Points of one line as the plain code takes them; all of them are of meshes without dirt.
std::vector<RidgePoint> points_of(const Polyline& line, const RidgeCandidates& found,
                                  const ExtractorData& data,
                                  const std::vector<PlacedCluster>& placed) {
    std::vector<RidgePoint> points;
    for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
        const RidgeCandidates::Form& form = found.forms[i];
        const PlacedCluster& cluster = placed[form.side.cluster];
        const auto& corners = cluster.triangle(form.side.triangle).corners;
        points.push_back({std::minmax(cluster.vertices[corners[form.side.side]],
                                      cluster.vertices[corners[(form.side.side + 1) % 3]]),
                          data.centre + data.diagonal * form.position.cast<double>(),
                          form.normal.cast<double>(), form.bend.cast<double>()});
    }
    return points;
}

Count compare(const TriangleMesh& mesh, Crest crest) {
    const Field field = precompute(mesh);
    const ExtractorData data = build_extractor_data(mesh, field);
    const std::vector<PlacedCluster> placed = place_clusters(data);
    RidgeCandidates found = find_ridge_candidates(data, placed, crest);
    measure_ridge_angles(data, placed, crest, found);
    const PlainRidgeAngles plain(mesh, field, crest.kind);
    Count count;
    for (const Polyline& line : found.lines.lines) {
        const auto angles = plain.measure(points_of(line, found, data, placed));
        for (std::uint32_t i = 0; i < line.count; ++i) {
            const LinePoint& fast = found.lines.points[line.first + i];
            const bool is_same = std::abs(double(fast.gradient) - angles[i].angle) <= kAngleError &&
                                 (fast.position.cast<double>() - angles[i].position).norm() <=
                                     kPlaceError * data.diagonal;
            ++count.points;
            count.others += !is_same;
            count.clear += angles[i].angle > 5;
        }
    }
    return count;
}

/// But for a few points: where rounding decides by which side a section leaves a triangle, or which
/// points are near enough to count.
TEST(PlainRidgeAngles, AreThoseOfCandidates) {
    const TriangleMesh meshes[] = {
        test_meshes::bumpy_sphere(5, 0.15).mesh, test_meshes::hills(48, 0.2).mesh,
        test_meshes::FlakedStone({}).mesh(4), test_meshes::rounded_cube(40, 0.08)};
    for (const TriangleMesh& mesh : meshes) {
        const TriangleMesh noisy = mesh_noise::with_noise(mesh, 0.1);
        for (const Crest crest : {kConvexCrest, kConcaveCrest}) {
            const bool is_valley = crest.kind == LineKind::Valley;
            const Count count = compare(is_valley ? test_meshes::cavity(noisy) : noisy, crest);
            EXPECT_GT(count.points, 100u);
            EXPECT_GT(count.clear, 30u);
            EXPECT_LE(count.others, count.points / 100);
        }
    }
}

}  // namespace
