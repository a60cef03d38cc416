// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/geometry_stamp.h"

#include <algorithm>
#include <vector>

#include "hash.h"
#include "laplacian_lines/threads.h"
#include "meshlab_host/mesh_conversion.h"

namespace meshlab_host {
namespace {

/// Hashes live elements by add(element, hash): blocks, then their results in order.
template <class Elements, class Add>
std::uint64_t hash_in_blocks(const Elements& elements, std::size_t live, std::uint64_t seed,
                             Add add) {
    constexpr std::size_t block = 16384;
    std::vector<std::uint64_t> hashes((live + block - 1) / block);
    const auto hash_block = [&](std::size_t number, std::size_t slot) {
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
        laplacian_lines::in_parallel(
            hashes.size(), [&](std::size_t number) { hash_block(number, number * block); });
    } else {
        std::size_t slot = 0;
        for (std::size_t number = 0; number < hashes.size(); ++number)
            slot = hash_block(number, slot);
    }
    Hash all(seed);
    for (std::uint64_t hash : hashes)
        all.add(hash);
    return all.value();
}

std::uint64_t hash_vertices(const CMeshO& mesh) {
    return hash_in_blocks(mesh.vert, std::size_t(mesh.vn), 1,
                          [](const CVertexO& vertex, Hash& hash) { hash.add(pack(vertex.cP())); });
}

template <class Index>
std::uint64_t hash_faces(const CMeshO& mesh, Index index) {
    const CVertexO* first = mesh.vert.data();
    return hash_in_blocks(mesh.face, std::size_t(mesh.fn), 2, [&](const CFaceO& face, Hash& hash) {
        hash.add(pack(index(std::size_t(face.cV(0) - first)),
                      index(std::size_t(face.cV(1) - first)),
                      index(std::size_t(face.cV(2) - first))));
    });
}

}  // namespace

GeometryStamp geometry_stamp(const CMeshO& mesh) {
    GeometryStamp stamp;
    stamp.vertices = std::uint64_t(mesh.vn);
    stamp.faces = std::uint64_t(mesh.fn);
    Hash hash(hash_vertices(mesh));
    if (has_deleted_vertices(mesh)) {
        const std::vector<std::uint32_t> indices = live_vertex_indices(mesh);
        hash.add(hash_faces(mesh, [&](std::size_t slot) { return indices[slot]; }));
    } else {
        hash.add(hash_faces(mesh, [](std::size_t slot) { return std::uint32_t(slot); }));
    }
    stamp.hash = hash.value();
    return stamp;
}

bool same_counts(const GeometryStamp& stamp, const CMeshO& mesh) {
    return stamp.vertices == std::uint64_t(mesh.vn) && stamp.faces == std::uint64_t(mesh.fn);
}

}  // namespace meshlab_host
