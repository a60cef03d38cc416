// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "choices.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/triangle_mesh.h"

/// What the core promises for any input. All functions return the first broken promise in words, or
/// nothing.
namespace wild {

std::string complaint(const laplacian_lines::TriangleMesh& mesh,
                      const laplacian_lines::Field& field);
std::string complaint(const laplacian_lines::LineSet& lines);

/// Mesh and options from bytes, through precompute(); errors are fine.
std::string precompute_case(test_meshes::Choices& choices);
/// A mesh, its own or a made-up field, views and styles, through extract() and LineVisibility.
std::string extract_case(test_meshes::Choices& choices);

/// Seeds for a fuzzer: from these bytes precompute_case() makes this mesh, as far as a wild_mesh()
/// can, with its own options or one other.
std::vector<std::uint8_t> precompute_seed(const laplacian_lines::TriangleMesh& mesh);
std::vector<std::uint8_t> precompute_seed(const laplacian_lines::TriangleMesh& mesh,
                                          unsigned changed_option);
/// For extract_case(), with views and styles chosen by `seed`.
std::vector<std::uint8_t> extract_seed(const laplacian_lines::TriangleMesh& mesh, unsigned seed);

}  // namespace wild
