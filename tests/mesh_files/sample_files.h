// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh_files/mesh_file.h"

namespace sample_files {

struct Sample {
    std::string name;
    mesh_files::Format format;
    std::string bytes;
};

/// A tetrahedron with corners (0 0 0), (2 0 0), (0 3 0), (0 0 4), whole, in all formats and kinds
/// of them.
const std::vector<Sample>& tetrahedra();

/// The volume that a closed mesh encloses: 4 of the tetrahedra.
double volume(const laplacian_lines::TriangleMesh& mesh);
/// Whether all triangles have vertices.
bool is_sound(const laplacian_lines::TriangleMesh& mesh);

/// The bytes of a number, the least first or the greatest.
template <class Number>
std::string packed(Number number, bool big = false) {
    const char* begin = reinterpret_cast<const char*>(&number);
    const std::string bytes(begin, begin + sizeof number);
    return big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

}  // namespace sample_files
