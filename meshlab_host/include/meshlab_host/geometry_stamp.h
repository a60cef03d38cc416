// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Identifies a mesh's geometry: counts and a hash of coordinates and corners of what is not
/// deleted. Compacting keeps it, moving one vertex changes it. Plain data, comparable between
/// plugins.
struct GeometryStamp {
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
    std::uint64_t hash = 0;

    bool operator==(const GeometryStamp& other) const {
        return vertices == other.vertices && faces == other.faces && hash == other.hash;
    }
    bool operator!=(const GeometryStamp& other) const { return !(*this == other); }
};

/// 2 to 3 ms for 0.9 million triangles.
GeometryStamp geometry_stamp(const CMeshO& mesh);

/// The cheap part of a comparison, for every redraw.
bool same_counts(const GeometryStamp& stamp, const CMeshO& mesh);

}  // namespace meshlab_host
