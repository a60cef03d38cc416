// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <random>

#include "analytic_surface.h"
#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

/// On [0,1]² with `columns` x `rows` cells.
struct Grid {
    int columns = 10, rows = 10;
    bool wrap_u = false, wrap_v = false;
    /// Moves vertices by up to this part of a cell, by a fixed seed; those on borders along these
    /// only.
    double jitter = 0;
};

TriangleMesh grid_mesh(const Grid& grid,
                       const std::function<Eigen::Vector3d(double u, double v)>& point);
AnalyticMesh grid_mesh(const Grid& grid,
                       const std::function<SurfacePoint(double u, double v)>& point);

/// An icosahedron's triangles split into 4^level.
TriangleMesh icosphere(int level);

AnalyticMesh sphere(int level, double radius = 1, double jitter = 0);
AnalyticMesh ellipsoid(int level, double jitter = 0);  ///< half axes 1, 0.8, 0.6
AnalyticMesh bumpy_sphere(int level, double jitter = 0);
/// 2 · columns · rows triangles.
AnalyticMesh torus(int columns, int rows, double jitter = 0);
/// 0 <= u <= π: two borders.
AnalyticMesh half_torus(int columns, int rows, double jitter = 0);
AnalyticMesh hills(int cells, double jitter = 0);  ///< over [−1, 1]²
AnalyticMesh cylinder(int columns, int rows);      ///< open, around z, from -1 to 1
TriangleMesh plane(int cells, double jitter = 0);  ///< [−1, 1]², z = 0, facing +z
TriangleMesh cube(int cells);                      ///< [−1, 1]³, welded edges
/// Edges and corners of this radius are as finely divided as the faces.
TriangleMesh rounded_cube(int cells, double radius);

/// A closed solid of rectangles of these half sides and heights, one on the other, each face cut
/// along the one diagonal or the other, by bits that repeat after 32 faces.
TriangleMesh stacked(const std::vector<Eigen::Vector3d>& rectangles, unsigned diagonals = 0);

/// Unit radius, width 0.6, one half turn: not orientable.
TriangleMesh moebius_strip(int columns, int rows);
/// Half planes that meet in the z axis, equally spaced.
TriangleMesh fan_of_sheets(int sheets, int cells);
/// Squares z = 0 facing down and z = `distance` facing up: a thin wall without rim.
TriangleMesh parallel_sheets(int cells, double distance);

TriangleMesh star(int triangles);  ///< around one vertex
TriangleMesh book(int pages);      ///< triangles on one edge
/// Each triangle gets vertices of its own.
TriangleMesh cut_apart(const TriangleMesh& mesh);

void append(TriangleMesh& mesh, const TriangleMesh& other);
void flip_triangles(TriangleMesh& mesh, int every);  ///< reverses each `every`-th triangle
TriangleMesh inside_out(TriangleMesh mesh);
TriangleMesh cavity(TriangleMesh mesh);  ///< in a box: what is read as inside out, closed or not
TriangleMesh moved(TriangleMesh mesh, const Eigen::Vector3d& by,
                   double factor = 1);  ///< scaled first
/// Each triangle cut in four at the middles of its sides.
TriangleMesh subdivided(TriangleMesh mesh, int times = 1);

inline double signed_unit(std::mt19937& random) {  ///< −1..1
    return 2 * double(random()) / double(std::mt19937::max()) - 1;
}
/// Each vertex moved by a share of the mean edge in a random direction, the same in every run.
TriangleMesh with_noise(TriangleMesh mesh, double share, unsigned seed = 1);

/// Adds what real files hold: NaN and infinite vertices with triangles, triangles without area or
/// with a repeated corner, unused vertices; in front, between and at the end. `clean_vertex[v]` is
/// where vertex v went.
TriangleMesh with_dirt(const TriangleMesh& mesh, std::vector<std::uint32_t>& clean_vertex);

}  // namespace test_meshes
