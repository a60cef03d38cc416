// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/joined_surface.h"

namespace line_drawing {
namespace {

using laplacian_lines::TriangleMesh;

TriangleMesh join(const Objects& objects) {
    TriangleMesh all;
    if (objects.size() == 1) return all;
    for (const Object& object : objects) {
        const auto first = std::uint32_t(all.positions.size());
        all.positions.insert(all.positions.end(), object.mesh.positions.begin(),
                             object.mesh.positions.end());
        for (const laplacian_lines::Triangle& t : object.mesh.triangles)
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    return all;
}

}  // namespace

JoinedSurface::JoinedSurface(const Objects& objects)
    : joined_(join(objects)), mesh_(objects.size() == 1 ? objects.front().mesh : joined_) {}

}  // namespace line_drawing
