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
            for (const std::uint32_t* t = shared_begin_; t < shared_end_; ++t)
                visit(mesh_->triangles[*t]);
            for (std::uint32_t t = first_; t < last_; ++t)
                visit(mesh_->triangles[t]);
        }

    private:
        friend class VertexRanges;
        const PreparedMesh* mesh_;
        std::uint32_t begin_, end_;
        std::uint32_t first_, last_;  // triangles whose smallest vertex is in the range
        const std::uint32_t *shared_begin_, *shared_end_;  // others at its vertices, all before
    };

    /// Calls body(range) on several threads; it may write only to its range's vertices.
    template <class Body>
    void for_each(const StageProgress& stage, Body body) const {
        parallel_for<NoScratch>(
            count(), stage, [&](std::size_t r, NoScratch&) { body(range(r)); }, 1);
    }

private:
    std::size_t count() const { return shared_starts_.size() - 1; }
    Range range(std::size_t r) const;
    void collect_shared();

    const PreparedMesh& mesh_;
    std::vector<std::uint32_t> first_triangles_;  // [count + 1]
    std::vector<std::uint32_t> shared_starts_;    // [count + 1], into shared_
    std::vector<std::uint32_t> shared_;
};

}  // namespace laplacian_lines
