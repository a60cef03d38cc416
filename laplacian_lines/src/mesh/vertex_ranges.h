// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/prepared_mesh.h"
#include "system/cache.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// The vertices of a mesh in ranges of neighbours, each with the triangles at them: sums at
/// vertices can run range by range without a table of triangles by vertex. A triangle may be in
/// several ranges.
class VertexRanges {
    struct Shared {
        std::uint32_t range, triangle;
    };

public:
    /// `mesh` is sorted in space and outlives this.
    explicit VertexRanges(const PreparedMesh& mesh);

    class Range {
    public:
        std::uint32_t begin() const { return begin_; }
        std::uint32_t end() const { return end_; }
        bool holds(std::uint32_t vertex) const { return vertex - begin_ < end_ - begin_; }

        /// Prefetches the range's part of an array: triangles read it in no simple order.
        template <class T>
        void prefetch(const std::vector<T>& values) const {
            const char* end = reinterpret_cast<const char*>(values.data() + end_);
            for (auto at = reinterpret_cast<const char*>(values.data() + begin_); at < end;
                 at += kCacheUnit)
                __builtin_prefetch(at);
        }

        /// Calls visit(triangle) in the order of the mesh.
        template <class Visit>
        void for_each_triangle(Visit visit) const {
            for (const Shared* s = shared_; s < shared_end_; ++s)
                visit(mesh_->triangles[s->triangle]);
            for (const Triangle* t = own_; t < own_end_; ++t)
                visit(*t);
        }

    private:
        friend class VertexRanges;
        const PreparedMesh* mesh_;
        std::uint32_t begin_, end_;
        const Triangle *own_, *own_end_;      // whose smallest vertex is in the range
        const Shared *shared_, *shared_end_;  // others at its vertices, all before
    };

    /// Calls body(range) on several threads; it may write only to its range's vertices.
    template <class Body>
    void for_each(const StageProgress& stage, Body body) const {
        const std::size_t count = (mesh_.size() + kSize - 1) / kSize;
        parallel_for<NoScratch>(
            count, stage, [&](std::size_t r, NoScratch&) { body(range(std::uint32_t(r))); }, 1);
    }

private:
    // Large enough that few triangles lie in two ranges, small enough for many threads.
    static constexpr std::uint32_t kSize = 2048;

    Range range(std::uint32_t r) const;

    const PreparedMesh& mesh_;
    std::vector<Shared> shared_;  // by range
};

}  // namespace laplacian_lines
