// SPDX-License-Identifier: GPL-3.0-or-later
// C, the derivative of the shape operator S along the surface, and S̄, S smoothed, for the kinds of
// lines that need them:
//  1. Around each vertex, a linear function of the tangent plane is fitted to S of its neighbours:
//     S̄ is its value within a small radius, C its slope within a larger one (TensorFits).
//  2. Without a fit (too few neighbours, about on one line, or sums that take too long) S̄ is S, and
//     C the mean of the differences within the triangles at the vertex.
//  3. Both go back to the mesh's unit and vertices: welded ones get those of their representative,
//     those that were left out 0.
#include <algorithm>

#include "field/cubic_form.h"
#include "field/field_steps.h"
#include "field/tensor_fits.h"
#include "field/triangle_plane.h"
#include "laplacian_lines/tangent_frame.h"

namespace laplacian_lines {
namespace {

constexpr double kSmoothed = 0.3;  // part of the time at which S̄ is known

// Between a triangle's normal and a corner's; below, the corner's S is that of another side.
constexpr double kLeastCosine = 0.1;

/// A vertex whose S is differentiated, local units.
struct CurvedVertex {
    Eigen::Vector3d normal, u, v;  // orthonormal
    SymmetricTensor shape_operator;
};

CurvedVertex curved_vertex(const PreparedMesh& mesh, const Field& field, std::uint32_t v) {
    const std::uint32_t original = mesh.original_vertex[v];
    const Eigen::Vector3f& n = field.normals[original];
    const TangentFrame frame = tangent_frame(n);
    const ShapeOperator& s = field.shape_operators[original];
    SymmetricTensor local = {s.xx, s.yy, s.zz, s.yz, s.xz, s.xy};
    local.scale(mesh.diagonal);
    return {n.cast<double>(), frame.u.cast<double>(), frame.v.cast<double>(), local};
}

/// S(u,u), S(u,v), S(v,v) of a vertex.
Eigen::Vector3d entries_of(const CurvedVertex& v) {
    const Eigen::Vector3d su = v.shape_operator * v.u, sv = v.shape_operator * v.v;
    return {v.u.dot(su), v.u.dot(sv), v.v.dot(sv)};
}

/// S of a triangle's corner in the triangle's plane, turned there by the smallest angle.
struct CornerInPlane {
    double entries[3];               // S(t,t), S(t,b), S(b,b) of the plane
    std::complex<double> direction;  // of t, in the corner's frame
};
CornerInPlane corner_in_plane(const CurvedVertex& corner, const TrianglePlane& plane) {
    const Eigen::Vector3d t = turned(plane.t, plane.n, corner.normal),
                          b = turned(plane.b, plane.n, corner.normal);
    const Eigen::Vector3d st = corner.shape_operator * t, sb = corner.shape_operator * b;
    return {{t.dot(st), b.dot(st), b.dot(sb)}, {t.dot(corner.u), t.dot(corner.v)}};
}

/// Adds the derivative of S within a triangle, times twice its area, in the frames of its corners'
/// curved_vertex(): S is linear between corners, in the triangle's plane, and the result is made
/// symmetric, as on smooth surfaces (Codazzi). S. Rusinkiewicz, "Estimating Curvatures and Their
/// Derivatives on Triangle Meshes", 3DPVT 2004, section 4, without least squares. Adds nothing if
/// the triangle faces another way than one of its corners.
void add_differences(const PreparedMesh& mesh, const Field& field, const Triangle& t,
                     std::vector<CubicForm>& forms, std::vector<double>& areas) {
    const TrianglePlane plane(mesh.positions, t);
    double by_t[3] = {}, by_b[3] = {};  // of S(t,t), S(t,b), S(b,b), times twice the area
    CornerInPlane corners[3];
    for (int k = 0; k < 3; ++k) {
        const CurvedVertex corner = curved_vertex(mesh, field, t[k]);
        if (!(plane.n.dot(corner.normal) > kLeastCosine)) return;
        corners[k] = corner_in_plane(corner, plane);
        for (int i = 0; i < 3; ++i) {
            by_t[i] -= plane.edges[k].dot(plane.b) * corners[k].entries[i];
            by_b[i] += plane.edges[k].dot(plane.t) * corners[k].entries[i];
        }
    }
    const CubicForm form = CubicForm::of(by_t, by_b);
    for (int k = 0; k < 3; ++k) {
        forms[t[k]].add(form.turned(corners[k].direction));
        areas[t[k]] += plane.twice_area;
    }
}

/// C of the vertices without a fit, from the triangles at each; 0 where none of these counts.
void fill_in(const PreparedMesh& mesh, const Field& field, const std::vector<std::uint8_t>& missing,
             std::vector<CubicForm>& derivatives) {
    if (std::find(missing.begin(), missing.end(), 1) == missing.end()) return;
    std::vector<CubicForm> sums(mesh.size());
    std::vector<double> areas(mesh.size());
    for (const Triangle& t : mesh.triangles)
        if (missing[t[0]] || missing[t[1]] || missing[t[2]])
            add_differences(mesh, field, t, sums, areas);
    for (std::size_t v = 0; v < mesh.size(); ++v) {
        if (!missing[v]) continue;
        derivatives[v] = sums[v];
        if (areas[v] > 0) derivatives[v].scale(1 / areas[v]);
    }
}

/// Results in the mesh's unit, at the original mesh's vertices.
void write(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& smoothed,
           const std::vector<CubicForm>& forms, Field& field) {
    const double d = mesh.diagonal;
    auto& curvatures = field.smooth_curvatures;
    auto& derivatives = field.curvature_derivatives;
    curvatures = large_array(field.normals.size(), Eigen::Vector3f(Eigen::Vector3f::Zero()));
    derivatives = large_array(field.normals.size(), Eigen::Vector4f(Eigen::Vector4f::Zero()));
    for_each_element(mesh.size(), [&](std::size_t i) {
        const std::uint32_t v = mesh.original_vertex[i];
        curvatures[v] = (smoothed[i] / d).unaryExpr(&to_float);
        derivatives[v] = (forms[i].entries() / d / d).unaryExpr(&to_float);
    });
    copy_to_welded(mesh.representative, curvatures, derivatives);
}

}  // namespace

void fill_curvature_derivatives(const PreparedMesh& mesh, const SpatialTree& tree,
                                const StageProgress& stage, Field& field) {
    const TensorFits fits(mesh, tree, field);
    std::vector<Eigen::Vector3d> smoothed = large_array<Eigen::Vector3d>(mesh.size());
    for_each_element(mesh.size(), [&](std::size_t v) {
        smoothed[v] = entries_of(curved_vertex(mesh, field, std::uint32_t(v)));
    });
    fits.for_each(kSmoothReach, stage.part(0, kSmoothed),
                  [&](std::uint32_t v, const TensorFit& fit) { smoothed[v] = fit.value; });
    std::vector<CubicForm> forms = large_array<CubicForm>(mesh.size());
    std::vector<std::uint8_t> missing(mesh.size(), 1);
    fits.for_each(kDerivativeReach, stage.part(kSmoothed, 1),
                  [&](std::uint32_t v, const TensorFit& fit) {
                      forms[v] = fit.slopes;
                      missing[v] = 0;
                  });
    fill_in(mesh, field, missing, forms);
    write(mesh, smoothed, forms, field);
}

}  // namespace laplacian_lines
