// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn instead of a mesh:
//  1. Subdivisions at the middles of edges are undone. Others follow for scans alone.
//  2. Vertices have the mean normals of their triangles, across cuts.
//  3. The middle of an edge is put on the cubic curve that leaves both ends normal to their
//     normals; its normal is their sum, mirrored at the plane half way between the ends.
//  4. Each triangle is cut in four at these middles, until edges are short, two cuts are made or
//     the next would make too many.
#include "laplacian_lines/refinement.h"

#include <algorithm>
#include <cmath>

#include "field/field_steps.h"
#include "laplacian_lines/error.h"
#include "mesh/bounding_box.h"
#include "mesh/midpoints.h"
#include "mesh/prepared_mesh.h"
#include "mesh/sides_by_edge.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

// Mean edges in √h from which on sums over vertices are those over the surface. After two cuts the
// least kernel, .6 of the edges before, has 2.4 of those after.
constexpr double kKernelEdges = 1.4;
constexpr int kMostCuts = 2;
// Forms of so few triangles are polyhedra by design; so many, once cut, take too long.
constexpr std::size_t kLeastTriangles = 1000, kMostTriangles = 1000000;
// Sine of the angle between an edge and the tangent plane at an end, from which the edge stays
// straight there: at the corners of a box it is .58 and .82, across its edges .71.
constexpr double kSharp = 0.5;
constexpr double kLongEdge = 3;  // mean edges; between such ends the surface is a guess

bool are_valid(const TriangleMesh& mesh) {
    return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
        return std::max({t[0], t[1], t[2]}) < mesh.positions.size();
    });
}

bool is_coarse(const TriangleMesh& mesh) {
    const std::size_t count = mesh.triangles.size();
    if (count < kLeastTriangles || 4 * count > kMostTriangles) return false;
    const double diagonal = bounding_box(mesh.positions, mesh.triangles).diagonal().norm();
    return kKernelEdges * mean_edge(mesh.positions, mesh.triangles) >
           automatic_kernel_size(0, diagonal);
}

/// Whether the surface between the vertices may be curved: edges and steps of the form are not.
bool is_of_curves(const TriangleMesh& mesh, const PreparedMesh& prepared) {
    // cut at T-junctions: curved sides would part
    const std::size_t usable = mesh.triangles.size() - prepared.report.degenerate_triangles;
    return prepared.report.coordinate_step == 0 && prepared.triangles.size() == usable &&
           prepared.origin == Origin::Scan;
}

class Refining {
public:
    /// `normals` are those of the prepared mesh.
    Refining(TriangleMesh mesh, const PreparedMesh& prepared, const std::vector<Vector3d>& normals,
             double roughness)
        : mesh_(std::move(mesh)), place_of_(prepared.representative) {
        extend_places();
        mesh_.known_edge = prepared.mean_edge * prepared.diagonal;
        mesh_.known_roughness = roughness;
        mesh_.known_vertices = mesh_.positions.size();
        mesh_.normals.assign(mesh_.positions.size(), Vector3d::Zero());
        for (std::size_t v = 0; v < normals.size(); ++v)
            mesh_.normals[prepared.original_vertex[v]] = normals[v];
        is_guessed_.resize(mesh_.positions.size());
        longest_ = kLongEdge * mesh_.known_edge;
        for (const Triangle& t : mesh_.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = place_of_[t[k]], b = place_of_[t[(k + 1) % 3]];
                if ((mesh_.positions[b] - mesh_.positions[a]).norm() > longest_)
                    is_guessed_[a] = is_guessed_[b] = 1;
            }
        copy_to_welded(place_of_, mesh_.normals, is_guessed_);
    }

    void cut_in_four() {
        const std::vector<std::uint32_t> middle = add_middles();
        std::vector<Triangle> parts;
        parts.reserve(4 * mesh_.triangles.size());
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            const auto [a, b, c] = mesh_.triangles[t];
            const std::uint32_t ab = middle[3 * t], bc = middle[3 * t + 1], ca = middle[3 * t + 2];
            parts.insert(parts.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh_.triangles.swap(parts);
        longest_ /= 2;
    }

    const TriangleMesh& mesh() const { return mesh_; }
    /// Without the normals of vertices whose surface is known well: those of the finer triangles
    /// are nearer to it.
    TriangleMesh take_mesh() {
        for (std::size_t v = 0; v < is_guessed_.size(); ++v)
            if (!is_guessed_[v]) mesh_.normals[v].setZero();
        return std::move(mesh_);
    }

private:
    void extend_places() {
        for (auto v = std::uint32_t(place_of_.size()); v < mesh_.positions.size(); ++v)
            place_of_.push_back(v);
    }

    /// The new vertex of each side.
    std::vector<std::uint32_t> add_middles() {
        const std::vector<Triangle>& triangles = mesh_.triangles;
        const auto place_edge = [&](std::uint32_t side) {
            return edge_between(place_of_[begin_of(triangles, side)],
                                place_of_[end_of(triangles, side)]);
        };
        std::vector<std::uint32_t> first(3 * triangles.size());  // by side: the first at its edge
        visit_edges<char>(first.size(), mesh_.positions.size(), place_edge,
                          [&](const std::uint32_t* begin, const std::uint32_t* end, char&) {
                              for (const std::uint32_t* side = begin; side != end; ++side)
                                  first[*side] = *begin;
                          });
        std::vector<std::uint32_t> middle(first.size());
        for (std::uint32_t side = 0; side < first.size(); ++side) {
            if (first[side] == side) {
                middle[side] = std::uint32_t(mesh_.positions.size());
                add_middle(begin_of(triangles, side), end_of(triangles, side));
            } else {
                middle[side] = middle[first[side]];
            }
        }
        extend_places();
        return middle;
    }

    void add_middle(std::uint32_t a, std::uint32_t b) {
        const Vector3d p = mesh_.positions[a], q = mesh_.positions[b], n = mesh_.normals[a],
                       m = mesh_.normals[b], d = q - p;
        const double length = d.norm();
        const auto bulge = [&](const Vector3d& normal, double along) -> Vector3d {
            if (length > longest_ || std::abs(along) > kSharp * length) return Vector3d::Zero();
            return along / 8 * normal;
        };
        mesh_.positions.push_back((p + q) / 2 - bulge(n, d.dot(n)) + bulge(m, d.dot(m)));
        const double turn = length > 0 ? 2 * d.dot(n + m) / (length * length) : 0;
        mesh_.normals.push_back((n + m - turn * d).stableNormalized());
        is_guessed_.push_back(is_guessed_[a] && is_guessed_[b]);
    }

    TriangleMesh mesh_;
    std::vector<std::uint32_t> place_of_;   // by vertex: that which it is welded to
    std::vector<std::uint8_t> is_guessed_;  // by vertex: at the end of a long edge
    double longest_ = 0;
};

void cut_finer(TriangleMesh& mesh, const StageProgress& stage) try {
    if (!is_coarse(mesh)) return;
    PreparedMesh prepared = prepare_mesh(mesh, Cuts::Stitched, Facing::Outwards);
    if (!is_of_curves(mesh, prepared)) return;
    const SpatialTree tree = sort_in_space(prepared);
    const VertexRanges ranges(prepared);
    const auto normals = vertex_normals(prepared, ranges, stage.part(0.2, 0.3));
    const double roughness =
        measure_roughness(prepared, ranges, tree, normals, stage.part(0.3, 0.5));
    Refining refining(mesh, prepared, normals, roughness);
    for (int cuts = 0; cuts < kMostCuts && is_coarse(refining.mesh()); ++cuts)
        refining.cut_in_four();
    mesh = refining.take_mesh();
} catch (const Error& error) {
    if (error.code() == ErrorCode::Cancelled) throw;
}

}  // namespace

TriangleMesh refined(TriangleMesh mesh, const Progress& progress) {
    const StageProgress stage(progress, 0, 1, "Refining the mesh");
    stage.report(0);
    if (!are_valid(mesh)) return mesh;
    undo_subdivisions(mesh);
    cut_finer(mesh, stage);
    return mesh;
}

}  // namespace laplacian_lines
