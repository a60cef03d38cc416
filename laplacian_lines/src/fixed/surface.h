// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "clusters/extractor_data.h"
#include "mesh/corner_table.h"
#include "system/three_floats.h"

namespace laplacian_lines {

constexpr float kDegrees = 57.29577951308232f;  ///< in a radian

/// Between vectors of any length.
inline float degrees_between(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return arc_tangent(length_of(a.cross(b)), dot(a, b)) * kDegrees;
}

/// The triangles of all clusters, one cluster after the other, for single passes over the mesh.
/// Vertices are those of the prepared mesh, sides those of the corner table. Local coordinates.
class Surface {
public:
    struct Facet {
        Eigen::Vector3f normal;  ///< unit; zero where floats leave no area
        Eigen::Vector3f centre;
        float area;
    };

    /// The data outlives this. The number of threads does not matter.
    explicit Surface(const ExtractorData& data);

    const CornerTable& sides() const { return sides_; }
    std::uint32_t triangle_count() const { return std::uint32_t(triangles_.size()); }
    const Facet& facet(std::uint32_t triangle) const { return facets_[triangle]; }
    const VertexRecord& record(std::uint32_t vertex) const { return *records_[vertex]; }
    Eigen::Vector3f position(std::uint32_t vertex) const { return position_of(record(vertex)); }

    std::uint32_t begin(std::uint32_t side) const { return begin_of(triangles_, side); }
    std::uint32_t end(std::uint32_t side) const { return end_of(triangles_, side); }
    /// The third vertex of the triangle.
    std::uint32_t opposite(std::uint32_t side) const { return end(next_side(side)); }
    /// From the start of a side to its end.
    Eigen::Vector3f span(std::uint32_t side) const {
        return position(end(side)) - position(begin(side));
    }

    /// Whether the edge is of two triangles, of which the other one has an area; sides() counts
    /// those without, too.
    bool has_neighbour(std::uint32_t side) const {
        return sides_.has_neighbour(side) && beyond(side).area > 0;
    }
    // Only where sides().has_neighbour():
    std::uint32_t across(std::uint32_t side) const { return sides_.across(side); }
    const Facet& beyond(std::uint32_t side) const { return facets_[across(side) / 3]; }
    /// −1 if the triangle beyond has the opposite orientation; a factor of its normal.
    float sign_across(std::uint32_t side) const {
        return have_one_orientation(triangles_, side, across(side)) ? 1.f : -1.f;
    }
    float cosine_across(std::uint32_t side) const {
        return sign_across(side) * dot(facets_[side / 3].normal, beyond(side).normal);
    }

    /// Whether the triangle has a coplanar neighbour; `cosine`: the least between their normals.
    bool has_coplanar_neighbour(std::uint32_t triangle, float cosine) const {
        for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side)
            if (has_neighbour(side) && cosine_across(side) >= cosine) return true;
        return false;
    }

private:
    std::vector<Triangle> triangles_;
    std::vector<const VertexRecord*> records_;  // by vertex
    CornerTable sides_;
    std::vector<Facet> facets_;  // by triangle
};

}  // namespace laplacian_lines
