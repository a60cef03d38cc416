// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace mesh_files {

/// Takes vertices and faces in any order.
class MeshBuilder {
public:
    void add(const Eigen::Vector3d& position) { mesh_.positions.push_back(position); }
    /// @throws Defect for fewer than three corners, or a number that no vertex can have
    void add(const std::vector<std::int64_t>& corners);
    void add_triangle(std::int64_t a, std::int64_t b, std::int64_t c);
    void reserve_vertices(std::size_t count) { mesh_.positions.reserve(count); }
    void reserve_triangles(std::size_t count) { mesh_.triangles.reserve(count); }
    std::size_t vertex_count() const { return mesh_.positions.size(); }

    /// Triangulates all faces whose vertices exist. `defect`, unless set, names the first that does
    /// not.
    laplacian_lines::TriangleMesh finish(std::string& defect);

private:
    laplacian_lines::TriangleMesh mesh_;
    std::vector<std::uint32_t> corners_;  // of faces that are no triangles
    std::vector<std::size_t> ends_;       // in corners_, by face
};

/// Cuts ears (Meisters 1975) off a polygon in its plane; one that crosses itself is cut up somehow.
/// `work`, in looks at a corner, is what may still be spent; false if it ran out.
bool triangulate(const std::vector<Eigen::Vector3d>& positions, const std::uint32_t* corners,
                 std::size_t count, std::size_t& work,
                 std::vector<laplacian_lines::Triangle>& triangles);

}  // namespace mesh_files
