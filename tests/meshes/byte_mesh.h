// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "choices.h"
#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// What a mesh of bytes can hold.
constexpr std::size_t kByteVertices = 255, kByteTriangles = 511;

/// Vertices and triangles one by one: coordinates in −32..32 by two bytes each, or NaN; indices in
/// range by one.
laplacian_lines::TriangleMesh read_byte_mesh(Choices& choices);

/// The bytes from which read_byte_mesh() reads this mesh, scaled to its range; of a larger mesh the
/// first triangles that fit.
std::vector<std::uint8_t> byte_mesh(const laplacian_lines::TriangleMesh& mesh);

}  // namespace test_meshes
