// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#include "sums/block_rows.h"
#include "sums/simd_grid.h"
#include "system/large_array.h"

namespace laplacian_lines {

/// Uninitialized nodes. Growing loses them.
template <class Node>
class NodeBuffer {
public:
    Node* grow(std::size_t count) {
        if (count > size_) {
            nodes_.reset();
            size_ = count + count / 4;
            nodes_.reset(static_cast<Node*>(
                ::operator new(size_ * sizeof(Node), std::align_val_t(alignof(Node)))));
            advise_huge_pages(nodes_.get(), size_ * sizeof(Node));
        }
        return nodes_.get();
    }
    Node* get() const { return nodes_.get(); }

private:
    struct Free {
        void operator()(Node* nodes) const {
            ::operator delete(nodes, std::align_val_t(alignof(Node)));
        }
    };
    std::unique_ptr<Node, Free> nodes_;
    std::size_t size_ = 0;
};

/// The blocks of a slab that hold anything.
template <class Node>
class BlockSlab {
public:
    std::vector<BlockMask>& masks() { return masks_; }  ///< by site; set them, then allocate()
    BlockMask mask(std::size_t site) const { return masks_.empty() ? 0 : masks_[site]; }

    void allocate() {
        sites_.clear();
        slots_.resize(masks_.size());
        for (std::size_t c = 0; c < masks_.size(); ++c)
            if (masks_[c]) {
                slots_[c] = std::uint32_t(sites_.size());
                sites_.push_back(std::uint32_t(c));
            }
        nodes_.grow(sites_.size() * kBlockNodes);
    }

    const std::vector<std::uint32_t>& sites() const { return sites_; }
    /// Null if empty.
    Node* block(std::size_t site) const {
        return mask(site) ? nodes_.get() + std::size_t(slots_[site]) * kBlockNodes : nullptr;
    }

private:
    std::vector<BlockMask> masks_;
    std::vector<std::uint32_t> sites_, slots_;
    NodeBuffer<Node> nodes_;
};

}  // namespace laplacian_lines
