// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/geometry_stamp.h"

#include <cstring>

#include "meshlab_host/mesh_conversion.h"

namespace meshlab_host {
namespace {

/// A chain of multiply-and-fold steps over 64-bit words, seeded apart for vertices and faces. Not
/// for adversaries; one bit changed anywhere in a mesh is all it has to notice.
class Hash {
public:
    explicit Hash(std::uint64_t seed) : state_(seed) {}

    void add(std::uint64_t word) {
        const std::uint64_t product = (state_ ^ word) * 0x9e3779b97f4a7c15u;
        state_ = product ^ (product >> 32);
    }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_;
};

template <class Scalar>
std::uint64_t bits(Scalar value) {
    std::uint64_t result = 0;
    std::memcpy(&result, &value, sizeof value);
    return result;
}

/// Three coordinates in one word. Each is spread by its own odd factor, so that swapping two of
/// them or shifting a value from one to another shows.
std::uint64_t pack(const Point3m& p) {
    return bits(p[0]) * 0xd6e8feb86659fd93u + bits(p[1]) * 0xa0761d6478bd642fu +
           bits(p[2]) * 0xe7037ed1a0b428dbu;
}

std::uint64_t pack(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
    return a * 0xd6e8feb86659fd93u + b * 0xa0761d6478bd642fu + c * 0xe7037ed1a0b428dbu;
}

std::uint64_t hashVertices(const CMeshO& mesh) {
    Hash hash(1);
    for (const CVertexO& vertex : mesh.vert)
        if (!vertex.IsD()) hash.add(pack(vertex.cP()));
    return hash.value();
}

/// `index(slot)` gives a vertex's number among the live ones.
template <class Index>
std::uint64_t hashFaces(const CMeshO& mesh, Index index) {
    Hash hash(2);
    const CVertexO* first = mesh.vert.data();
    for (const CFaceO& face : mesh.face) {
        if (face.IsD()) continue;
        hash.add(pack(index(std::size_t(face.cV(0) - first)),
                      index(std::size_t(face.cV(1) - first)),
                      index(std::size_t(face.cV(2) - first))));
    }
    return hash.value();
}

}  // namespace

GeometryStamp geometryStamp(const CMeshO& mesh) {
    GeometryStamp stamp;
    stamp.vertices = std::uint64_t(mesh.vn);
    stamp.faces = std::uint64_t(mesh.fn);
    Hash hash(hashVertices(mesh));
    if (hasDeletedVertices(mesh)) {
        const std::vector<std::uint32_t> indices = liveVertexIndices(mesh);
        hash.add(hashFaces(mesh, [&](std::size_t slot) { return indices[slot]; }));
    } else {
        hash.add(hashFaces(mesh, [](std::size_t slot) { return std::uint32_t(slot); }));
    }
    stamp.hash = hash.value();
    return stamp;
}

bool sameCounts(const GeometryStamp& stamp, const CMeshO& mesh) {
    return stamp.vertices == std::uint64_t(mesh.vn) && stamp.faces == std::uint64_t(mesh.fn);
}

}  // namespace meshlab_host
