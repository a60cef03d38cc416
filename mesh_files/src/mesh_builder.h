// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace mesh_files {

/// Takes vertices and faces in any order.
class MeshBuilder {
public:
    void add(const Eigen::Vector3d& position) { mesh_.positions.push_back(position); }
    /// Skips those with fewer than three corners.
    /// @throws Defect for a number that no vertex can have
    void add(const std::vector<std::int64_t>& corners);
    void add_triangle(std::int64_t a, std::int64_t b, std::int64_t c);
    /// Faces may use vertices of any number below `count`, also such as follow later.
    void expect_vertices(std::uint64_t count) { expected_ = count; }
    void reserve_vertices(std::size_t count) { mesh_.positions.reserve(count); }
    void reserve_triangles(std::size_t count) { mesh_.triangles.reserve(count); }
    std::size_t vertex_count() const { return mesh_.positions.size(); }

    std::size_t skipped_faces() const { return skipped_faces_; }

    /// Takes the mesh, with all faces whose vertices exist as triangles. `defect`, unless set,
    /// names a polygon that is too intricate; those after it are missing.
    laplacian_lines::TriangleMesh finish(std::string& defect);

private:
    std::uint32_t vertex(std::int64_t number) const;

    laplacian_lines::TriangleMesh mesh_;
    std::uint64_t expected_ = std::numeric_limits<std::uint32_t>::max();
    std::size_t skipped_faces_ = 0;
    std::vector<std::uint32_t> corners_;  // of faces that are no triangles
    std::vector<std::size_t> ends_;       // in corners_, by face
};

// Feed the builder, and say in a part of a sentence what they skip. @throws Defect where the bytes
// are malformed
std::string read_ply(std::string_view bytes, MeshBuilder& mesh);
std::string read_stl(std::string_view bytes, MeshBuilder& mesh);
std::string read_obj(std::string_view bytes, MeshBuilder& mesh);
std::string read_off(std::string_view bytes, MeshBuilder& mesh);

}  // namespace mesh_files
