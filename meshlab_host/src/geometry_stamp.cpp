// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/geometry_stamp.h"

#include <omp.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "laplacian_lines/affordable_threads.h"
#include "meshlab_host/mesh_conversion.h"

namespace meshlab_host {
namespace {

/// A sum over 64-bit words, each mixed with its place, so that no word has to wait for the one
/// before. Not for adversaries; one bit changed anywhere in a mesh is all it has to notice.
class Hash {
public:
    explicit Hash(std::uint64_t seed) : place_(seed) {}

    void add(std::uint64_t word) {
        place_ += 0x9e3779b97f4a7c15u;
        std::uint64_t mixed = (word ^ place_) * 0xbf58476d1ce4e5b9u;
        mixed ^= mixed >> 32;
        sum_ += mixed * 0x94d049bb133111ebu;
    }
    std::uint64_t value() const { return sum_; }

private:
    std::uint64_t place_, sum_ = 0;
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

/// Hashes the elements that are not deleted: blocks of them, and then the results in their order.
/// `add(element, hash)` adds one.
template <class Elements, class Add>
std::uint64_t hashInBlocks(const Elements& elements, std::size_t live, std::uint64_t seed,
                           Add add) {
    constexpr std::size_t block = 16384;
    std::vector<std::uint64_t> hashes((live + block - 1) / block);
    const auto hashBlock = [&](std::size_t number, std::size_t slot) {
        Hash hash(seed);
        std::size_t left = std::min(live - number * block, block);
        for (; left > 0 && slot < elements.size(); ++slot) {
            if (elements[slot].IsD()) continue;
            add(elements[slot], hash);
            --left;
        }
        hashes[number] = hash.value();
        return slot;
    };
    if (elements.size() == live) {
        const int threads =
            hashes.size() > 1 ? laplacian_lines::affordable_threads(omp_get_max_threads()) : 1;
#pragma omp parallel for num_threads(threads) if (threads > 1)
        for (std::size_t number = 0; number < hashes.size(); ++number)
            hashBlock(number, number * block);
    } else {
        std::size_t slot = 0;
        for (std::size_t number = 0; number < hashes.size(); ++number)
            slot = hashBlock(number, slot);
    }
    Hash all(seed);
    for (std::uint64_t hash : hashes)
        all.add(hash);
    return all.value();
}

std::uint64_t hashVertices(const CMeshO& mesh) {
    return hashInBlocks(mesh.vert, std::size_t(mesh.vn), 1,
                        [](const CVertexO& vertex, Hash& hash) { hash.add(pack(vertex.cP())); });
}

/// `index(slot)` gives a vertex's number among the live ones.
template <class Index>
std::uint64_t hashFaces(const CMeshO& mesh, Index index) {
    const CVertexO* first = mesh.vert.data();
    return hashInBlocks(mesh.face, std::size_t(mesh.fn), 2, [&](const CFaceO& face, Hash& hash) {
        hash.add(pack(index(std::size_t(face.cV(0) - first)),
                      index(std::size_t(face.cV(1) - first)),
                      index(std::size_t(face.cV(2) - first))));
    });
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
