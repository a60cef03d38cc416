// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The truth at a point; signs as in the core: outward normal, S = dn (sphere: +1/R), Δn = −2/R² n
/// on a sphere.
struct SurfacePoint {
    Eigen::Vector3d position, normal, laplacian_normal;
    Eigen::Matrix3d shape_operator;  ///< symmetric, S n = 0
    /// C = ∇S: of axis i, (y, z) -> C(i, y, z). Tangential and symmetric in all places.
    std::array<Eigen::Matrix3d, 3> shape_derivative;
};

/// Where the point of the unit sphere goes that is in this direction.
SurfacePoint ellipsoid_point(const Eigen::Vector3d& direction, const Eigen::Vector3d& half_axes);
/// On the ray from the origin: smooth bumps and grooves of about a tenth of the radius 1.
SurfacePoint bumpy_point(const Eigen::Vector3d& direction);

struct Torus {
    double large = 1, small = 0.4;  ///< radii; the axis is z
};
SurfacePoint torus_point(const Torus& torus, double u, double v);
/// torus_point() by closed formulas.
SurfacePoint closed_form_torus_point(const Torus& torus, double u, double v);

/// Hills z = f(x, y) with bumps of about 0.1.
SurfacePoint hills_point(double x, double y);

struct AnalyticMesh {
    TriangleMesh mesh;
    std::vector<SurfacePoint> truth;
};

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

/// `jitter`: vertices move by up to this part of an edge along each axis, before they are mapped.
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
/// A closed solid over a polygon, cut into triangles from its first corner.
TriangleMesh prism(const std::vector<Eigen::Vector2d>& corners, double low = 0, double high = 1);

using Ring = std::vector<Eigen::Vector3d>;
Ring circle(std::uint32_t sides, double radius, double z, double first_angle = 0);
TriangleMesh walls(const std::vector<Ring>& rings);  ///< between rings of as many places each

/// Unit radius, width 0.6, one half turn: not orientable.
TriangleMesh moebius_strip(int columns, int rows);
/// Bent sheets that meet in the z axis, equally spaced.
TriangleMesh fan_of_sheets(int sheets, int cells);
/// Squares z = 0 facing down and z = `distance` facing up: a thin wall without rim.
TriangleMesh parallel_sheets(int cells, double distance);

TriangleMesh star(int triangles);                  ///< around one vertex
TriangleMesh book(int pages, double opening = 3);  ///< triangles on one edge; radians
/// Triangles of vertices at so many places in turn: without area.
TriangleMesh on_a_line(std::uint32_t vertices, std::uint32_t places);
/// Each triangle gets vertices of its own.
TriangleMesh cut_apart(const TriangleMesh& mesh);

void append(TriangleMesh& mesh, const TriangleMesh& other);
TriangleMesh together(TriangleMesh mesh, const TriangleMesh& other);
TriangleMesh flipped(TriangleMesh mesh, int every = 1);  ///< reverses each `every`-th triangle
/// A box around the mesh, which is turned inside out: the inner wall of a hollow body.
TriangleMesh cavity(TriangleMesh mesh);
/// With `change` done to each vertex.
template <class Change>
TriangleMesh mapped(TriangleMesh mesh, const Change& change) {
    for (Eigen::Vector3d& p : mesh.positions)
        change(p);
    return mesh;
}
TriangleMesh moved(TriangleMesh mesh, const Eigen::Vector3d& by,
                   double factor = 1);  ///< scaled first
TriangleMesh rounded_to_floats(TriangleMesh mesh);
/// Each triangle cut in four at the middles of its sides.
TriangleMesh subdivided(TriangleMesh mesh, int times = 1);

/// A head of soft blobs and hollows, as a surface between size³ voxels: by exact values, or, like
/// segmented volumes, by labels alone, in terraces. W. Lorensen, H. Cline, "Marching Cubes",
/// SIGGRAPH 1987, but polygons are followed from face to face instead of a table.
TriangleMesh smooth_head(int size);
TriangleMesh terraced_head(int size);

struct VesselShape {
    int rings = 600, columns = 720;
    double relief = 1;  ///< factor of grooves, wave and traces of throwing; 0: smooth
};

/// From the underside's middle around the wall to the inside's middle: (radius, height), mm.
std::vector<Eigen::Vector2d> vessel_profile(int points);

/// A jar of 200 mm around the y axis: closed, a wall of 6 mm, two grooves and an incised wave
/// on the shoulder, throwing marks inside.
TriangleMesh thrown_vessel(const VesselShape& shape = {});

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
