// SPDX-License-Identifier: GPL-3.0-or-later
#include "sight_truth.h"

#include <cmath>
#include <limits>

#include "generators.h"

namespace benchmarks {
namespace {

using namespace test_meshes;
using Eigen::Vector3d;

constexpr int kFineLevel = 7;    // of icospheres: 327,680 triangles
constexpr int kNewtonSteps = 8;  // to the contour
// How far off the surface rays begin, by its size of about 1: more than the fine mesh's sagitta.
constexpr double kOffSurface = 1e-4;

/// A surface of revolution around x, with a waist.
JetVector peanut_map(const JetVector& d) {
    const Jet radius = 0.42 + 0.58 * (d[0] * d[0]);
    return {d[0] * radius, d[1] * radius, d[2] * radius};
}

SurfacePoint torus_foot(const Vector3d& p) {
    const double ring = std::hypot(p.x(), p.y()) - Torus{}.large;
    return closed_form_torus_point({}, std::atan2(p.y(), p.x()), std::atan2(p.z(), ring));
}

KnownForm around_the_origin(const std::string& name, JetVector (*map)(const JetVector&)) {
    KnownForm form{name, {}, [=] {
                       return SightTruth(mapped_icosphere(kFineLevel, map).mesh,
                                         [=](const Vector3d& p) { return surface_point(map, p); });
                   }};
    for (const int level : {4, 5, 6})
        form.meshes.push_back([=] { return mapped_icosphere(level, map, 0.2).mesh; });
    return form;
}

KnownForm ring() {
    KnownForm form{
        "torus", {}, [] { return SightTruth(test_meshes::torus(1000, 400).mesh, torus_foot); }};
    for (const int rows : {36, 72, 144})
        form.meshes.push_back([=] { return test_meshes::torus(2 * rows, rows, 0.2).mesh; });
    return form;
}

}  // namespace

SightTruth::SightTruth(const laplacian_lines::TriangleMesh& fine, Foot foot)
    : caster_(fine, {{}, 0, 1, ""}), foot_(std::move(foot)) {}

std::optional<SightTruth::Contour> SightTruth::contour_at(const Vector3d& place,
                                                          const Vector3d& towards_eye,
                                                          double reach) const {
    const Vector3d v = towards_eye.normalized();
    SurfacePoint at = foot_(place);
    for (int i = 0; i < kNewtonSteps; ++i) {
        const Vector3d slope = at.shape_operator * v;  // of n·v
        at = foot_(at.position - at.normal.dot(v) / slope.squaredNorm() * slope);
        if (!((at.position - place).norm() < reach)) return {};
    }
    const Vector3d turn = at.shape_operator * v;
    const double radial = v.dot(turn) / turn.norm();
    if (radial < 0) return Contour{false, radial};  // a cusp's far side: hidden by its own form
    laplacian_lines::RayCaster::Hint hint;
    const Vector3d start = at.position + kOffSurface * at.normal;
    return Contour{!caster_.is_hit({start, v, std::numeric_limits<double>::infinity()}, hint),
                   radial};
}

std::vector<KnownForm> known_forms() {
    return {ring(), around_the_origin("peanut", peanut_map),
            around_the_origin("bumpy sphere", bumpy_map)};
}

}  // namespace benchmarks
