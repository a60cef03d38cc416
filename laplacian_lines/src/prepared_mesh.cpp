// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <sstream>
#include <string>

#include "laplacian_lines/error.h"
#include "parallel.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kUnused = 0xffffffffu;
// sin of the smallest angle a triangle may have; far below what float input can resolve.
constexpr double kLeastSine = 1e-12;
// Diagonals for which D² and 1/D², which the field holds as floats, keep far from the ends of the
// number range.
constexpr double kLeastDiagonal = 1e-15, kLargestDiagonal = 1e15;

using Positions = std::vector<Eigen::Vector3d>;

bool is_degenerate(const Positions& positions, const Triangle& t) {
    const Eigen::Vector3d &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
    if (!a.allFinite() || !b.allFinite() || !c.allFinite()) return true;
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    if (!(longest > 0)) return true;
    const Eigen::Vector3d u = (b - a) / longest, v = (c - a) / longest;
    return !(u.cross(v).norm() > kLeastSine);
}

void check_indices(const TriangleMesh& mesh) {
    for (const Triangle& t : mesh.triangles)
        for (std::uint32_t v : t)
            if (v >= mesh.positions.size())
                throw Error(ErrorCode::InvalidMesh,
                            "A triangle uses vertex " + std::to_string(v) + ", but the mesh has " +
                                std::to_string(mesh.positions.size()) + " vertices.");
}

/// In blocks, each of which first counts what it keeps.
std::vector<Triangle> usable_triangles(const Positions& positions,
                                       const std::vector<Triangle>& triangles) {
    const std::size_t count = triangles.size();
    std::vector<std::uint8_t> is_usable(count);
    std::vector<std::size_t> kept(block_count(count) + 1, 0);
    in_blocks(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            kept[begin / kBlockElements + 1] += is_usable[t] =
                !is_degenerate(positions, triangles[t]);
    });
    for (std::size_t b = 1; b < kept.size(); ++b)
        kept[b] += kept[b - 1];
    std::vector<Triangle> usable(kept.back());
    in_blocks(count, [&](std::size_t begin, std::size_t end) {
        std::size_t place = kept[begin / kBlockElements];
        for (std::size_t t = begin; t < end; ++t)
            if (is_usable[t]) usable[place++] = triangles[t];
    });
    if (usable.empty())
        throw Error(ErrorCode::EmptyMesh,
                    "The mesh has no triangle with an area. Laplacian lines need a surface: for a "
                    "point cloud, reconstruct one first.");
    return usable;
}

/// Around the mesh's centre, coordinates may be coarser than they were around the origin. Drops the
/// triangles that have no area there, and gives the others back their vertices of the input; false
/// if there are none to drop.
bool drop_lost_triangles(PreparedMesh& prepared) {
    std::vector<Triangle> usable = usable_triangles(prepared.positions, prepared.triangles);
    if (usable.size() == prepared.triangles.size()) return false;
    for (Triangle& t : usable)
        for (std::uint32_t& v : t)
            v = prepared.original_vertex[v];
    prepared.triangles.swap(usable);
    prepared.positions.clear();
    prepared.original_vertex.clear();
    prepared.report.non_finite_vertices = prepared.report.unreferenced_vertices = 0;
    return true;
}

/// Numbers the vertices that triangles use and rewrites the triangles' indices.
void keep_used_vertices(const TriangleMesh& mesh, PreparedMesh& prepared) {
    std::vector<std::uint32_t> number(mesh.positions.size(), kUnused);
    for (const Triangle& t : prepared.triangles)
        for (std::uint32_t v : t)
            number[v] = 0;
    prepared.original_vertex.reserve(number.size());
    for (std::uint32_t v = 0; v < number.size(); ++v) {
        if (!mesh.positions[v].allFinite())
            ++prepared.report.non_finite_vertices;
        else if (number[v] == kUnused)
            ++prepared.report.unreferenced_vertices;
        else {
            number[v] = std::uint32_t(prepared.original_vertex.size());
            prepared.original_vertex.push_back(v);
        }
    }
    if (prepared.original_vertex.size() == number.size()) return;
    in_blocks(prepared.triangles.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            for (std::uint32_t& v : prepared.triangles[t])
                v = number[v];
    });
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
    Eigen::Vector3d low = mesh.positions[original[0]], high = low;
    for (std::uint32_t v : original) {
        low = low.cwiseMin(mesh.positions[v]);
        high = high.cwiseMax(mesh.positions[v]);
    }
    prepared.centre = low / 2 + high / 2;
    prepared.diagonal = (high - low).stableNorm();
    check_size(prepared.diagonal);
    prepared.positions.resize(original.size());
    in_blocks(original.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            prepared.positions[i] =
                (mesh.positions[original[i]] - prepared.centre) / prepared.diagonal;
    });
}

void measure(PreparedMesh& mesh) {
    mesh.masses.assign(mesh.size(), 0);
    double edges = 0;
    for (const Triangle& t : mesh.triangles) {
        const double third_of_area = area_vector(mesh, t).norm() / 6;
        for (int k = 0; k < 3; ++k) {
            mesh.masses[t[k]] += third_of_area;
            edges += (mesh.positions[t[(k + 1) % 3]] - mesh.positions[t[k]]).norm();
        }
    }
    mesh.mean_edge = edges / double(3 * mesh.triangles.size());
}

/// Sorts triangles by their smallest vertex, which becomes the first.
void sort_triangles(PreparedMesh& mesh) {
    std::vector<std::uint32_t> place(mesh.size() + 1, 0);
    for (Triangle& t : mesh.triangles) {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        ++place[t[0] + 1];
    }
    for (std::size_t v = 1; v < place.size(); ++v)
        place[v] += place[v - 1];
    std::vector<Triangle> sorted(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        sorted[place[t[0]]++] = t;
    mesh.triangles.swap(sorted);
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
    std::vector<T> permuted(values.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        permuted[i] = values[order[i]];
    values.swap(permuted);
}

}  // namespace

Eigen::Vector3d area_vector(const PreparedMesh& mesh, const Triangle& t) {
    const Eigen::Vector3d& a = mesh.positions[t[0]];
    return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
}

PreparedMesh prepare_geometry(const TriangleMesh& mesh) {
    check_indices(mesh);
    PreparedMesh prepared;
    prepared.report.vertices = mesh.positions.size();
    prepared.report.triangles = mesh.triangles.size();
    prepared.triangles = usable_triangles(mesh.positions, mesh.triangles);
    do {
        keep_used_vertices(mesh, prepared);
        to_local_coordinates(mesh, prepared);
    } while (drop_lost_triangles(prepared));
    prepared.report.degenerate_triangles = mesh.triangles.size() - prepared.triangles.size();
    return prepared;
}

PreparedMesh prepare_mesh(const TriangleMesh& mesh) {
    PreparedMesh prepared = prepare_geometry(mesh);
    measure(prepared);
    return prepared;
}

SpatialTree sort_in_space(PreparedMesh& mesh) {
    std::vector<std::uint32_t> order;
    SpatialTree tree(mesh.positions, order);
    std::vector<std::uint32_t> place(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        place[order[i]] = i;
    permute(mesh.positions, order);
    permute(mesh.masses, order);
    permute(mesh.original_vertex, order);
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            v = place[v];
    sort_triangles(mesh);
    return tree;
}

}  // namespace laplacian_lines
