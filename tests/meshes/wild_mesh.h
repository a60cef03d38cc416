// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "choices.h"
#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// A number that some code may not expect: not finite, huge, tiny, or of any bits at all.
double odd_number(Choices& choices);

/// A mesh of up to a few hundred triangles with nothing right about it, or only one thing wrong: a
/// form, and damages one after the other. Indices may be out of range if `bad_indices`.
laplacian_lines::TriangleMesh wild_mesh(Choices& choices, bool bad_indices = false);

/// Bytes that wild_mesh() makes this mesh of, as far as byte_mesh() holds it.
std::vector<std::uint8_t> wild_mesh_bytes(const laplacian_lines::TriangleMesh& mesh);

/// What a mesh of bytes can hold.
constexpr std::size_t kByteVertices = 255, kByteTriangles = 511;

/// Vertices and triangles one by one: coordinates in −32..32 by two bytes each, or NaN; indices in
/// range by one.
laplacian_lines::TriangleMesh read_byte_mesh(Choices& choices);

/// The bytes from which read_byte_mesh() reads this mesh, scaled to its range; of a larger mesh the
/// first triangles that fit.
std::vector<std::uint8_t> byte_mesh(const laplacian_lines::TriangleMesh& mesh);

}  // namespace test_meshes
