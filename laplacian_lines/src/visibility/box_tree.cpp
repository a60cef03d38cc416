// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/box_tree.h"

#include <algorithm>
#include <numeric>

namespace laplacian_lines {
namespace {

constexpr std::size_t kPartObjects = 32768;  // at most, in one of Eigen's trees
constexpr double kCut = 0.2;                 // about the part of the whole time that cutting takes

struct BoxCentre {
    Eigen::Vector3d at;
    int object;
};

/// Numbers of objects in parts of about the same size, neighbours in space together.
class Parts {
public:
    Parts(const std::vector<BoxTree::Box>& boxes, const StageProgress& stage)
        : centres_(boxes.size()) {
        for_each_element(boxes.size(), [&](std::size_t i) {
            centres_[i] = {boxes[i].center(), int(i)};
        });
        while (boxes.size() > kPartObjects << levels_)
            ++levels_;
        for (unsigned level = 0; level < levels_; ++level) {
            cut_in_halves(level);
            stage.report(double(level + 1) / levels_);
        }
    }

    std::size_t count() const { return std::size_t(1) << levels_; }

    std::vector<int> objects(std::size_t part) const {
        std::vector<int> result;
        for (std::size_t i = begin(part, levels_); i < begin(part + 1, levels_); ++i)
            result.push_back(centres_[i].object);
        return result;
    }

private:
    /// Of one of the 2^level pieces.
    std::size_t begin(std::size_t piece, unsigned level) const {
        return (centres_.size() * piece) >> level;
    }

    void cut_in_halves(unsigned level) {
        const auto at = [&](std::size_t i) { return centres_.begin() + std::ptrdiff_t(i); };
        in_parallel<NoScratch>(std::size_t(1) << level, [&](std::size_t i, NoScratch&) {
            std::nth_element(at(begin(i, level)), at(begin(2 * i + 1, level + 1)),
                             at(begin(i + 1, level)),
                             [axis = level % 3](const BoxCentre& a, const BoxCentre& b) {
                                 return a.at[axis] < b.at[axis];
                             });
        });
    }

    std::vector<BoxCentre> centres_;
    unsigned levels_ = 0;
};

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes, const StageProgress& stage) {
    if (boxes.empty()) return;
    stage.report(0);
    const Parts parts(boxes, stage.part(0, kCut));
    parts_.resize(parts.count());
    std::vector<Box> of_parts(parts.count());
    const auto build = [&](std::size_t p, NoScratch&) {
        const std::vector<int> objects = parts.objects(p);
        std::vector<Box> of_objects;
        for (const int object : objects) {
            of_objects.push_back(boxes[std::size_t(object)]);
            of_parts[p].extend(of_objects.back());
        }
        parts_[p].init(objects.begin(), objects.end(), of_objects.begin(), of_objects.end());
    };
    parallel_for<NoScratch>(parts.count(), stage.part(kCut, 1), build, 1);
    std::vector<int> numbers(parts.count());
    std::iota(numbers.begin(), numbers.end(), 0);
    tree_of_parts_.init(numbers.begin(), numbers.end(), of_parts.begin(), of_parts.end());
}

}  // namespace laplacian_lines
