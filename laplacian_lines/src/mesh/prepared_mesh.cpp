// SPDX-License-Identifier: GPL-3.0-or-later
// The usable part of a mesh:
//  1. Triangles without an area, or with corners that are not finite, are dropped.
//  2. T-junctions are cut, the copies of a doubled mesh dropped, and vertices at one place, or
//     across a crack, welded where they cut the surface open.
//  3. Used vertices are kept, in coordinates around the bounding box's centre and in units of its
//     diagonal D. Triangles that lose their area by rounding are dropped as well, and vertices
//     welded that nobody sees apart: a fold as narrow would be drawn as an edge.
//  4. Triangles folded over by a needle's width are unfolded, and all oriented, if asked for.
//  5. The mean edge is measured, what the mesh was made from, and whether coordinates are so coarse
//     that smooth surfaces bend.
#include "mesh/prepared_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "laplacian_lines/error.h"
#include "mesh/bounding_box.h"
#include "mesh/conforming.h"
#include "mesh/flat_faces.h"
#include "mesh/needles.h"
#include "mesh/orientation.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kUnused = 0xffffffffu;
// Height of a triangle, in its longest side; far below what float input can resolve.
constexpr double kLeastHeight = 1e-12;
// Diagonals for which D² and 1/D², floats in the field, stay far from overflow and underflow.
constexpr double kLeastDiagonal = 1e-15, kLargestDiagonal = 1e15;

// Of the mean edge: coarser coordinates bend smooth surfaces by some degrees at every edge.
constexpr double kCoarseStep = 0.1;
constexpr std::size_t kFewTriangles = 1000;  // coordinates of so few may be round by design
constexpr std::size_t kMostPerVertex = 3;    // closed surfaces have two triangles a vertex
// In steps: if no triangle is larger, the form consists of voxels or hexahedra.
constexpr double kCell = 2.5;

// Below these, a side has no length: of D, and of the mean edge, since D may be that of parts that
// lie far off.
constexpr double kShortOfDiagonal = 1e-6, kShortOfEdge = 1e-3;

using Positions = std::vector<Eigen::Vector3d>;

/// Also if a corner is not finite, or so far off that squares are not.
bool is_degenerate(const Positions& positions, const Triangle& t) {
    const double least = kLeastHeight * longest_squared(positions, t);
    return !(area_vector(positions, t).squaredNorm() > least * least);
}

void check_indices(const TriangleMesh& mesh) {
    const std::size_t count = mesh.positions.size();
    if (!mesh.normals.empty() && mesh.normals.size() != count)
        throw Error(ErrorCode::InvalidMesh, "A mesh has a normal for each vertex, or none.");
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            if (v >= count)
                throw Error(ErrorCode::InvalidMesh, "A triangle uses vertex " + std::to_string(v) +
                                                        ", but the mesh has " +
                                                        std::to_string(count) + " vertices.");
}

std::vector<Triangle> usable_triangles(const Positions& positions,
                                       const std::vector<Triangle>& triangles) {
    return kept(triangles,
                [&](std::uint32_t t) { return !is_degenerate(positions, triangles[t]); });
}

void expect_surface(const std::vector<Triangle>& usable) {
    if (usable.empty())
        throw Error(ErrorCode::EmptyMesh,
                    "The mesh has no triangle with an area. Laplacian lines need a surface: for a "
                    "point cloud, reconstruct one first.");
}

/// Gives vertices that only dropped triangles used the representative of another at their place.
void represent_copies(const TriangleMesh& mesh, const std::vector<std::uint32_t>& place_of,
                      PreparedMesh& prepared) {
    std::vector<std::uint32_t> used_at(place_of.size(), kUnused);
    std::vector<std::uint8_t> is_used(place_of.size());
    for (const Triangle& t : prepared.triangles)
        for (const std::uint32_t v : t)
            used_at[place_of[v]] = v, is_used[v] = 1;
    std::vector<std::uint32_t>& representative = prepared.representative;
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t) {
            if (is_used[v] || used_at[place_of[v]] == kUnused) continue;
            if (representative.empty()) representative = numbers_up_to(place_of.size());
            representative[v] = representative[used_at[place_of[v]]];
        }
}

/// Makes triangles use representatives, so that triangles at cuts become neighbours.
void stitch(const TriangleMesh& mesh, const std::vector<std::uint32_t>& place_of,
            PreparedMesh& prepared) {
    std::vector<std::uint32_t>& representative = prepared.representative;
    representative = stitch_cuts(mesh.positions, place_of, prepared.triangles);
    const std::size_t usable = mesh.triangles.size() - prepared.report.degenerate_triangles;
    if (prepared.triangles.size() < usable) represent_copies(mesh, place_of, prepared);
    if (representative.empty()) return;
    for (std::uint32_t v = 0; v < representative.size(); ++v)
        prepared.report.welded_vertices += representative[v] != v;
    prepared.triangles = with_places(std::move(prepared.triangles), representative);
}

/// Keeps these triangles, with the vertices of the input. Returns whether they are fewer.
bool restrict_to(std::vector<Triangle> usable, PreparedMesh& prepared) {
    const std::size_t lost = prepared.triangles.size() - usable.size();
    if (lost == 0) return false;
    expect_surface(usable);
    prepared.report.degenerate_triangles += lost;
    prepared.triangles = with_places(std::move(usable), prepared.original_vertex);
    return true;
}

/// Welds the ends of sides that have no length, and drops the triangles at these. Returns whether
/// there were any.
bool weld_short_sides(const TriangleMesh& mesh, PreparedMesh& prepared) {
    const Positions& positions = prepared.positions;
    std::vector<std::uint32_t> ends =
        ends_of_short_sides(positions, kShortOfDiagonal, prepared.triangles);
    if (ends.empty()) return false;  // the usual case, without a mean
    const double most = kShortOfEdge * mean_edge(positions, prepared.triangles);
    if (most < kShortOfDiagonal) ends = ends_of_short_sides(positions, most, prepared.triangles);
    if (ends.empty()) return false;
    std::vector<std::uint32_t> place = numbers_up_to(mesh.positions.size());
    for (std::uint32_t v = 0; v < ends.size(); ++v) {
        place[prepared.original_vertex[v]] = prepared.original_vertex[ends[v]];
        prepared.report.welded_vertices += ends[v] != v;
    }
    for (std::uint32_t& v : prepared.representative)
        v = place[v];
    if (prepared.representative.empty()) prepared.representative = std::move(place);
    return restrict_to(usable_triangles(positions, with_places(prepared.triangles, ends)),
                       prepared);
}

void keep_used_vertices(const TriangleMesh& mesh, PreparedMesh& prepared) {
    std::vector<std::uint32_t> number = large_array(mesh.positions.size(), kUnused);
    for_each_element(prepared.triangles.size(), [&](std::size_t t) {
        for (std::uint32_t v : prepared.triangles[t])
            __atomic_store_n(&number[v], 0, __ATOMIC_RELAXED);
    });
    prepared.original_vertex =
        numbers_where(number.size(), [&](std::uint32_t v) { return number[v] != kUnused; });
    prepared.report.non_finite_vertices = std::size_t(sum_of(
        number.size(), [&](std::size_t v) { return mesh.positions[v].allFinite() ? 0. : 1.; }));
    prepared.report.unreferenced_vertices =
        number.size() - prepared.original_vertex.size() - prepared.report.non_finite_vertices;
    if (prepared.original_vertex.size() == number.size()) return;
    for_each_element(prepared.original_vertex.size(), [&](std::size_t i) {
        number[prepared.original_vertex[i]] = std::uint32_t(i);
    });
    prepared.triangles = with_places(std::move(prepared.triangles), number);
}

void check_size(double diagonal) {
    if (diagonal >= kLeastDiagonal && diagonal <= kLargestDiagonal) return;
    std::ostringstream message;
    message << "The mesh's bounding box has a diagonal of " << diagonal
            << ", but it must be between " << kLeastDiagonal << " and " << kLargestDiagonal
            << ": scale the mesh, or delete vertices that lie far off.";
    throw Error(ErrorCode::InvalidMesh, message.str());
}

void to_local_coordinates(const TriangleMesh& mesh, PreparedMesh& prepared) {
    const std::vector<std::uint32_t>& original = prepared.original_vertex;
    const Eigen::AlignedBox3d box = bounding_box(
        original.size(),
        [&](std::size_t i) -> const Eigen::Vector3d& { return mesh.positions[original[i]]; });
    prepared.centre = box.min() / 2 + box.max() / 2;
    prepared.diagonal = box.sizes().stableNorm();
    check_size(prepared.diagonal);
    prepared.positions = large_array<Eigen::Vector3d>(original.size());
    for_each_element(original.size(), [&](std::size_t i) {
        prepared.positions[i] = (mesh.positions[original[i]] - prepared.centre) / prepared.diagonal;
    });
}

/// Greatest common divisor of the extents of all triangles' sides, by Euclid's algorithm; 0 if it
/// is less than `least`.
double common_step(const TriangleMesh& mesh, const PreparedMesh& prepared, double least) {
    constexpr double kOff = 0.01;  // tolerance, in steps, besides that for rounding
    const auto is_float = [&](std::uint32_t v) {
        return mesh.positions[v] == mesh.positions[v].cast<float>().cast<double>();
    };
    const bool are_floats =
        std::all_of(prepared.original_vertex.begin(), prepared.original_vertex.end(), is_float);
    const double rounding = (are_floats ? 0x1p-23 : 0x1p-50) *
                            (prepared.centre.cwiseAbs().maxCoeff() + prepared.diagonal / 2);
    double step = 0;
    const auto add = [&](double extent) {
        while (extent > std::max(rounding, kOff * step)) {
            if (step == 0) step = extent;
            const double times = std::round(extent / step), off = std::abs(extent - times * step);
            if (off <= kOff * step + times * rounding) return;
            extent = step;
            step = off;
        }
    };
    for (const Triangle& t : prepared.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d side = mesh.positions[prepared.original_vertex[t[(k + 1) % 3]]] -
                                         mesh.positions[prepared.original_vertex[t[k]]];
            for (const double x : side)
                add(std::abs(x));
            if (step > 0 && step < least) return 0;
        }
    return step;
}

/// MeshReport::coordinate_step.
double coarse_step(const TriangleMesh& mesh, PreparedMesh& prepared) {
    if (prepared.triangles.size() < kFewTriangles) return 0;
    const double edge = prepared.mean_edge * prepared.diagonal;
    const double step = common_step(mesh, prepared, kCoarseStep * edge);
    if (step == 0) return 0;
    const auto is_in_cell = [&](const Triangle& t) {
        const Eigen::Vector3d &a = prepared.positions[t[0]], &b = prepared.positions[t[1]],
                              &c = prepared.positions[t[2]];
        const Eigen::Vector3d extent = a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c);
        return extent.maxCoeff() * prepared.diagonal < kCell * step;
    };
    if (std::all_of(prepared.triangles.begin(), prepared.triangles.end(), is_in_cell)) return 0;
    return flat_faces(prepared, sides_of(prepared)).are_large() ? 0 : step;
}

}  // namespace

const CornerTable& sides_of(PreparedMesh& mesh) {
    if (!mesh.sides) mesh.sides.emplace(mesh.triangles, mesh.size());
    return *mesh.sides;
}

double mean_edge(const Positions& positions, const std::vector<Triangle>& triangles) {
    const double edges = sum_of(triangles.size(), [&](std::size_t i) {
        const Triangle& t = triangles[i];
        const Eigen::Vector3d &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
        return (b - a).norm() + (c - b).norm() + (a - c).norm();
    });
    return edges / double(3 * triangles.size());
}

std::vector<Triangle> conforming_triangles(const TriangleMesh& mesh) {
    check_indices(mesh);
    std::vector<Triangle> triangles = usable_triangles(mesh.positions, mesh.triangles);
    const std::vector<std::uint32_t> place_of =
        make_conforming(mesh.positions, nearness_of(mesh.positions, triangles), triangles);
    return with_places(std::move(triangles), place_of);
}

PreparedMesh prepare_geometry(const TriangleMesh& mesh, Cuts cuts, Facing facing) {
    check_indices(mesh);
    PreparedMesh prepared;
    prepared.report.vertices = mesh.positions.size();
    prepared.report.triangles = mesh.triangles.size();
    prepared.triangles = usable_triangles(mesh.positions, mesh.triangles);
    expect_surface(prepared.triangles);
    prepared.report.degenerate_triangles = mesh.triangles.size() - prepared.triangles.size();
    const bool may_be_doubled = prepared.triangles.size() > kMostPerVertex * mesh.positions.size();
    if (may_be_doubled || !is_closed(prepared.triangles) || are_two_sided(prepared.triangles)) {
        const std::vector<std::uint32_t> place_of = make_conforming(
            mesh.positions, nearness_of(mesh.positions, prepared.triangles), prepared.triangles);
        if (cuts == Cuts::Stitched) stitch(mesh, place_of, prepared);
    }
    do {
        keep_used_vertices(mesh, prepared);
        to_local_coordinates(mesh, prepared);
        // around the centre, coordinates may be coarser than around the origin
    } while (restrict_to(usable_triangles(prepared.positions, prepared.triangles), prepared) ||
             (cuts == Cuts::Stitched && weld_short_sides(mesh, prepared)));
    unfold_needles(prepared.positions, prepared.triangles);
    if (facing == Facing::Outwards) orient(prepared);
    prepared.report.unreferenced_vertices -= prepared.report.welded_vertices;
    return prepared;
}

PreparedMesh prepare_mesh(const TriangleMesh& mesh, Cuts cuts, Facing facing) {
    PreparedMesh prepared = prepare_geometry(mesh, cuts, facing);
    prepared.mean_edge = mean_edge(prepared.positions, prepared.triangles);
    prepared.known_edge = mesh.known_edge / prepared.diagonal;
    prepared.origin = origin_of(prepared);
    prepared.report.coordinate_step = coarse_step(mesh, prepared);
    return prepared;
}

}  // namespace laplacian_lines
