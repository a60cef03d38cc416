// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Tells whether a mesh still has the geometry that something was computed from: its counts and a
/// hash over the coordinates and corners of all that is not deleted. Compacting a mesh keeps its
/// stamp, moving a single vertex changes it. Plain data, comparable between plugins.
struct GeometryStamp {
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
    std::uint64_t hash = 0;

    bool operator==(const GeometryStamp& other) const {
        return vertices == other.vertices && faces == other.faces && hash == other.hash;
    }
    bool operator!=(const GeometryStamp& other) const { return !(*this == other); }
};

/// One pass over the mesh; 2 to 3 ms for 0.9 million triangles.
GeometryStamp geometryStamp(const CMeshO& mesh);

/// Whether the counts still agree: the cheap part of a comparison, for use at every redraw.
bool sameCounts(const GeometryStamp& stamp, const CMeshO& mesh);

}  // namespace meshlab_host
