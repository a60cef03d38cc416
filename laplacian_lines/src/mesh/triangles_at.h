// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// The triangles at each vertex.
class TrianglesAt {
public:
    TrianglesAt(std::size_t vertices, const std::vector<Triangle>& triangles)
        : starts_(vertices + 2, 0), triangles_(3 * triangles.size()) {
        for (const Triangle& t : triangles)
            for (const std::uint32_t v : t)
                ++starts_[v + 2];
        for (std::size_t v = 2; v < starts_.size(); ++v)
            starts_[v] += starts_[v - 1];
        for (std::uint32_t i = 0; i < triangles.size(); ++i)
            for (const std::uint32_t v : triangles[i])
                triangles_[starts_[v + 1]++] = i;
    }
    const std::uint32_t* begin(std::size_t v) const { return triangles_.data() + starts_[v]; }
    const std::uint32_t* end(std::size_t v) const { return triangles_.data() + starts_[v + 1]; }
    std::size_t count(std::size_t v) const { return starts_[v + 1] - starts_[v]; }

private:
    std::vector<std::uint32_t> starts_, triangles_;
};

}  // namespace laplacian_lines
