// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "choices.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/triangle_mesh.h"

/// What the core promises for any input whatsoever. All functions return the first broken promise
/// in words, or nothing.
namespace wild {

std::string complaint(const laplacian_lines::TriangleMesh& mesh,
                      const laplacian_lines::Field& field);
std::string complaint(const laplacian_lines::LineSet& lines);

/// A mesh and options that the bytes choose, through precompute(). Its errors are as good as a
/// field.
std::string precompute_case(test_meshes::Choices& choices);
/// A mesh, a field that may be its own or made up, and views and styles, through extract() and
/// LineVisibility.
std::string extract_case(test_meshes::Choices& choices);

/// Bytes from which a fuzzer may start: precompute_case() takes of them this mesh, as far as a
/// wild_mesh() can be it, with its own options, or with one that `changed_option` tells from
/// others.
std::vector<std::uint8_t> precompute_seed(const laplacian_lines::TriangleMesh& mesh);
std::vector<std::uint8_t> precompute_seed(const laplacian_lines::TriangleMesh& mesh,
                                          unsigned changed_option);
/// The same for extract_case(), with views and styles that `seed` chooses.
std::vector<std::uint8_t> extract_seed(const laplacian_lines::TriangleMesh& mesh, unsigned seed);

}  // namespace wild
