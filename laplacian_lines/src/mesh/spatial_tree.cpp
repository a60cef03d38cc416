// SPDX-License-Identifier: GPL-3.0-or-later
// A kd-tree with full leaves: points are halved along the longest axis of their box, so that points
// of a leaf, and leaves one after the other, are near in space. Points are compared as integers of
// 31 bits with their index: no two are equal, so that halves are the same whoever makes them. The
// first halvings are shared by threads, then subtrees.
#include "mesh/spatial_tree.h"

#include <algorithm>
#include <cmath>

#include "mesh/bounding_box.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kSmallSubtree = 8192;  // points; too few for several threads
// Leaves are sorted down to groups of this size, so that there, too, neighbours share cache lines.
constexpr std::uint32_t kGroupSize = 8;
constexpr int kSamples = 64;

typedef std::int32_t Int4 __attribute__((vector_size(16)));

/// A point in steps of a 2^31th of the longest side of all points' box, and its index.
struct alignas(16) Item {
    std::int32_t at[3];
    std::int32_t index;

    /// Different for all items.
    std::int64_t key(int axis) const { return std::int64_t(at[axis]) << 32 | index; }
};

std::vector<Item> make_items(const std::vector<Eigen::Vector3d>& points) {
    const Eigen::AlignedBox3d box = bounding_box(points);
    const double size = box.sizes().maxCoeff(), steps = size > 0 ? 2147483647 / size : 0;
    std::vector<Item> items = large_array<Item>(points.size());
    for_each_element(points.size(), [&](std::size_t i) {
        const Eigen::Vector3d p = steps * (points[i] - box.min());
        items[i] = {{std::int32_t(p.x()), std::int32_t(p.y()), std::int32_t(p.z())},
                    std::int32_t(i)};
    });
    return items;
}

int longest_axis(const Item* begin, const Item* end) {
    Int4 low = reinterpret_cast<const Int4&>(*begin), high = low;
    for (const Item* i = begin + 1; i < end; ++i) {
        const Int4 at = reinterpret_cast<const Int4&>(*i);
        low = at < low ? at : low;
        high = at > high ? at : high;
    }
    const Int4 size = high - low;
    return size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
}

/// A key, not the smallest, with about as many items before it as `middle`.
template <int Axis>
std::int64_t choose_pivot(const Item* begin, const Item* end, const Item* middle) {
    const std::ptrdiff_t size = end - begin;
    const int count = int(std::min<std::ptrdiff_t>(kSamples, size < 256 ? size / 8 + 3 : size));
    std::int64_t samples[kSamples];
    for (int i = 0; i < count; ++i)
        samples[i] = begin[size * i / count].key(Axis);
    // Slightly beyond the middle as seen from the nearer end, so that the smaller part is left.
    const double part = double(middle - begin) / double(size);
    const int rank = part < 0.5 ? int(std::ceil(part * count)) + 1 : int(part * count) - 1;
    std::int64_t* pivot = samples + std::clamp(rank, 1, count - 1);
    std::nth_element(samples, pivot, samples + count);
    return *pivot;
}

template <int Axis>
void sort_few(Item* begin, Item* end) {
    for (Item* i = begin; i < end; ++i)
        for (Item* j = i; j > begin && j->key(Axis) < j[-1].key(Axis); --j)
            std::swap(*j, j[-1]);
}

/// Puts the smallest items before `middle`: quickselect with Lomuto's partition, which needs no
/// branches on keys; O(n), or O(n²) if all samples mislead.
template <int Axis>
void select(Item* begin, Item* end, Item* middle) {
    while (end - begin > kGroupSize) {
        const std::int64_t pivot = choose_pivot<Axis>(begin, end, middle);
        Item* parting = begin;
        for (Item* i = begin; i < end; ++i) {
            const Item item = *i;
            *i = *parting;
            *parting = item;
            parting += item.key(Axis) < pivot;
        }
        if (parting == middle) return;
        (parting < middle ? begin : end) = parting;
    }
    sort_few<Axis>(begin, end);
}

void split(Item* begin, Item* end, Item* middle) {
    switch (longest_axis(begin, end)) {
        case 0:
            return select<0>(begin, end, middle);
        case 1:
            return select<1>(begin, end, middle);
        default:
            return select<2>(begin, end, middle);
    }
}

void order_leaf(Item* begin, Item* end) {
    if (end - begin <= kGroupSize) return;
    Item* middle = begin + (end - begin) / 2;
    split(begin, end, middle);
    order_leaf(begin, middle);
    order_leaf(middle, end);
}

}  // namespace

SpatialTree::FloatBox::FloatBox(const Eigen::AlignedBox3d& box) {
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::nextafter(float(box.min()[axis]), -HUGE_VALF);
        high[axis] = std::nextafter(float(box.max()[axis]), HUGE_VALF);
    }
}

/// Subtrees know their places in the tables from their numbers of points, so they can be built in
/// parallel.
class SpatialTree::Builder {
public:
    Builder(const std::vector<Eigen::Vector3d>& points, SpatialTree& tree,
            std::vector<std::uint32_t>& order)
        : points_(points), tree_(tree), order_(order), items_(make_items(points)) {}

    void run() {
        const std::uint32_t count = std::uint32_t(items_.size()), leaves = leaf_count(count);
        order_.resize(count);
        tree_.leaves_.resize(leaves);
        tree_.nodes_.resize(2 * leaves - 1);
        const std::vector<Subtree> subtrees =
            halve_in_parallel(Subtree{0, 0, 0, count}, kSmallSubtree,
                              [this](const Subtree& subtree) { return cut(subtree); });
        const std::size_t cuts = subtrees.size() / 2;
        in_parallel(subtrees.size() - cuts, [&](std::size_t i) { build(subtrees[cuts + i]); });
        for (std::size_t i = cuts; i-- > 0;)
            join(subtrees[i], subtrees[2 * i + 1], subtrees[2 * i + 2]);
    }

private:
    /// The places of its root and of its first leaf, and its points.
    struct Subtree {
        std::uint32_t node, leaf, begin, end;
        std::uint32_t size() const { return end - begin; }
    };

    static std::uint32_t leaf_count(std::uint32_t points) {
        return (points + kLeafSize - 1) / kLeafSize;
    }

    void build(const Subtree& subtree) {
        if (subtree.size() <= kLeafSize) return make_leaf(subtree);
        const auto [left, right] = cut(subtree);
        build(left);
        build(right);
        join(subtree, left, right);
    }

    std::pair<Subtree, Subtree> cut(const Subtree& whole) {
        // Whole leaves on the left keep all leaves but the last ones full.
        const std::uint32_t half = whole.size() / 2, half_leaves = half / kLeafSize;
        const std::uint32_t middle =
            whole.begin + (half_leaves > 0 ? half_leaves * kLeafSize : half);
        split(items_.data() + whole.begin, items_.data() + whole.end, items_.data() + middle);
        const std::uint32_t left_leaves = leaf_count(middle - whole.begin);
        return {{whole.node + 1, whole.leaf, whole.begin, middle},
                {whole.node + 2 * left_leaves, whole.leaf + left_leaves, middle, whole.end}};
    }

    void join(const Subtree& whole, const Subtree& left, const Subtree& right) {
        const FloatBox &a = tree_.nodes_[left.node].box, &b = tree_.nodes_[right.node].box;
        FloatBox box;
        box.low = a.low < b.low ? a.low : b.low;
        box.high = a.high > b.high ? a.high : b.high;
        tree_.nodes_[whole.node] = {box, right.node, kNoLeaf};
    }

    void make_leaf(const Subtree& subtree) {
        const auto [node, leaf, begin, end] = subtree;
        order_leaf(items_.data() + begin, items_.data() + end);
        Eigen::AlignedBox3d box;
        for (std::uint32_t i = begin; i < end; ++i) {
            order_[i] = std::uint32_t(items_[i].index);
            box.extend(points_[order_[i]]);
        }
        tree_.leaves_[leaf] = {begin, end, box};
        tree_.nodes_[node] = {FloatBox(box), 0, leaf};
    }

    const std::vector<Eigen::Vector3d>& points_;
    SpatialTree& tree_;
    std::vector<std::uint32_t>& order_;
    std::vector<Item> items_;
};

SpatialTree::SpatialTree(const std::vector<Eigen::Vector3d>& points,
                         std::vector<std::uint32_t>& order) {
    Builder(points, *this, order).run();
}

}  // namespace laplacian_lines
