// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace mesh_files {

/// Makes a mesh of vertices and of faces that name them, in whichever order they come.
class MeshBuilder {
public:
    void add(const Eigen::Vector3d& position) { mesh_.positions.push_back(position); }
    /// Adds one of three or more corners. @throws Defect if there are fewer, or if a number cannot
    /// be that of a vertex.
    void add(const std::vector<std::int64_t>& corners);
    void add_triangle(std::int64_t a, std::int64_t b, std::int64_t c);
    /// As many more are to be expected.
    void reserve_vertices(std::size_t count) { mesh_.positions.reserve(count); }
    void reserve_triangles(std::size_t count) { mesh_.triangles.reserve(count); }
    std::size_t vertex_count() const { return mesh_.positions.size(); }

    /// With triangles of all faces whose vertices are there. `defect` says which is the first that
    /// is not, unless it says something already.
    laplacian_lines::TriangleMesh finish(std::string& defect);

private:
    laplacian_lines::TriangleMesh mesh_;
    std::vector<std::uint32_t> corners_;  // of faces that are no triangles
    std::vector<std::size_t> ends_;       // in corners_, by face
};

/// Cuts off ears (Meisters 1975) of a polygon as it is in its plane, so that triangles of concave
/// ones stay inside; a polygon that crosses itself is cut up somehow. `work` is what may be done
/// yet, in looks at a corner. Whether that was enough.
bool triangulate(const std::vector<Eigen::Vector3d>& positions, const std::uint32_t* corners,
                 std::size_t count, std::size_t& work,
                 std::vector<laplacian_lines::Triangle>& triangles);

}  // namespace mesh_files
