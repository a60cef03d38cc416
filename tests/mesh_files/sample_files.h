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

/// Corners (0 0 0), (2 0 0), (0 3 0), (0 0 4), sound, in all formats and variants.
const std::vector<Sample>& tetrahedra();

/// Of a closed mesh; 4 for the tetrahedra.
double volume(const laplacian_lines::TriangleMesh& mesh);
/// All triangles have vertices.
bool is_sound(const laplacian_lines::TriangleMesh& mesh);

/// Little- or big-endian.
template <class Number>
std::string packed(Number number, bool big = false) {
    const char* begin = reinterpret_cast<const char*>(&number);
    const std::string bytes(begin, begin + sizeof number);
    return big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

}  // namespace sample_files
