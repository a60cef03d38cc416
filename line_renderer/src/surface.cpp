// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/surface.h"

#include <algorithm>

namespace line_renderer {

using laplacian_lines::Field;
using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

SurfacePointer makeSurface(const TriangleMesh& mesh, const Field& field) {
    auto surface = std::make_shared<Surface>();
    surface->vertices.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        surface->vertices.push_back({mesh.positions[i].cast<float>(), field.normals.at(i)});

    const auto is_finite = [&](std::uint32_t corner) {
        return corner < surface->vertices.size() && surface->vertices[corner].position.allFinite();
    };
    surface->triangles.reserve(mesh.triangles.size());
    std::copy_if(mesh.triangles.begin(), mesh.triangles.end(),
                 std::back_inserter(surface->triangles), [&](const Triangle& triangle) {
                     return std::all_of(triangle.begin(), triangle.end(), is_finite);
                 });
    return surface;
}

std::size_t bytesOf(const Surface& surface) {
    return surface.vertices.capacity() * sizeof(SurfaceVertex) +
           surface.triangles.capacity() * sizeof(Triangle);
}

}  // namespace line_renderer
