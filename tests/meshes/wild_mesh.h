// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "choices.h"
#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// Not finite, huge, tiny, or any bits at all.
double odd_number(Choices& choices);

/// Up to a few hundred triangles, all wrong or a form with damages one after the other.
/// `bad_indices` may be out of range.
laplacian_lines::TriangleMesh wild_mesh(Choices& choices, bool bad_indices = false);

/// Bytes from which wild_mesh() makes this mesh, as far as byte_mesh() holds it.
std::vector<std::uint8_t> wild_mesh_bytes(const laplacian_lines::TriangleMesh& mesh);

/// What a mesh of bytes can hold.
constexpr std::size_t kByteVertices = 255, kByteTriangles = 511;

/// One by one: coordinates in −32..32 by two bytes each, or NaN; valid indices by one.
laplacian_lines::TriangleMesh read_byte_mesh(Choices& choices);

/// For read_byte_mesh(), scaled to its range; of a larger mesh the first triangles.
std::vector<std::uint8_t> byte_mesh(const laplacian_lines::TriangleMesh& mesh);

}  // namespace test_meshes
