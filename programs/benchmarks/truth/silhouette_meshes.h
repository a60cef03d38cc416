// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace benchmarks {

struct SilhouetteMesh {
    std::string name;
    std::function<laplacian_lines::TriangleMesh()> make;
};

/// The tests' meshes, wild ones that can be drawn, primitives, soups, cracks, mirrored, tiny, huge
/// and far ones.
std::vector<SilhouetteMesh> silhouette_meshes();

/// From a file, alone and beside its mirror image.
std::vector<SilhouetteMesh> scans_of(const std::string& file);

}  // namespace benchmarks
