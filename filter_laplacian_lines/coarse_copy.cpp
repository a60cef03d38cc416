// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute_filter.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

#include "line_drawing/object.h"
#include "system/parallel.h"

using laplacian_lines::TriangleMesh;

namespace {

constexpr std::size_t copied_faces = 1 << 16;
constexpr double least_covered = 0.95;  // of the vertices' diagonal, by the copied faces

Eigen::Vector3d placeOf(const CVertexO& vertex) {
    return {vertex.cP()[0], vertex.cP()[1], vertex.cP()[2]};
}

TriangleMesh someTriangles(const CMeshO& mesh) {
    TriangleMesh copy;
    const std::size_t count = mesh.face.size();
    for (std::size_t i = 0; i < copied_faces; ++i) {
        const CFaceO& face = mesh.face[i * count / copied_faces];
        if (face.IsD()) continue;
        const auto first = std::uint32_t(copy.positions.size());
        for (int corner = 0; corner < 3; ++corner)
            copy.positions.push_back(placeOf(*face.cV(corner)));
        copy.triangles.push_back({first, first + 1, first + 2});
    }
    return copy;
}

/// Edges of a cube, diagonals of its sides and of itself.
constexpr std::size_t axes = 13;

std::array<Scalarm, axes> reachOf(const CVertexO& vertex) {
    const Scalarm x = vertex.cP()[0], y = vertex.cP()[1], z = vertex.cP()[2];
    return {x,     y,     z,         x + y,     x - y,     x + z,    x - z,
            y + z, y - z, x + y + z, x + y - z, x - y + z, x - y - z};
}

/// The first and last vertex along each axis, without those that are not finite.
class Farthest {
public:
    void add(const CVertexO& vertex) {
        const std::array<Scalarm, axes> reach = reachOf(vertex);
        if (!std::isfinite(reach[0] + reach[1] + reach[2])) return;
        for (std::size_t a = 0; a < axes; ++a) {
            if (reach[a] < least_[a]) least_[a] = reach[a], first_[a] = &vertex;
            if (reach[a] > most_[a]) most_[a] = reach[a], last_[a] = &vertex;
        }
    }

    template <class Visit>
    void forEach(Visit visit) const {
        for (const auto& vertices : {first_, last_})
            for (const CVertexO* vertex : vertices)
                if (vertex) visit(*vertex);
    }

private:
    static std::array<Scalarm, axes> all(Scalarm value) {
        std::array<Scalarm, axes> values;
        values.fill(value);
        return values;
    }

    std::array<Scalarm, axes> least_ = all(std::numeric_limits<Scalarm>::max());
    std::array<Scalarm, axes> most_ = all(std::numeric_limits<Scalarm>::lowest());
    std::array<const CVertexO*, axes> first_{}, last_{};
};

Farthest farthestVertices(const CMeshO& mesh) {
    const auto of_block = [&](std::size_t begin, std::size_t end) {
        Farthest found;
        for (std::size_t v = begin; v < end; ++v)
            if (!mesh.vert[v].IsD()) found.add(mesh.vert[v]);
        return found;
    };
    const auto join = [](Farthest all, const Farthest& more) {
        more.forEach([&](const CVertexO& vertex) { all.add(vertex); });
        return all;
    };
    return laplacian_lines::join_blocks(mesh.vert.size(), Farthest(), of_block, join);
}

}  // namespace

std::optional<TriangleMesh> coarseCopy(const CMeshO& mesh) {
    if (mesh.fn <= most_faces_looked_at) return std::nullopt;
    TriangleMesh copy = someTriangles(mesh);
    const double covered = line_drawing::boundsOf(copy).diagonal().norm();
    farthestVertices(mesh).forEach([&](const CVertexO& vertex) {
        const auto index = std::uint32_t(copy.positions.size());
        copy.positions.push_back(placeOf(vertex));
        copy.triangles.push_back({index, index, index});
    });
    if (!(covered >= least_covered * line_drawing::boundsOf(copy).diagonal().norm()))
        return std::nullopt;
    return copy;
}
