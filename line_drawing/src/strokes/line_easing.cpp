// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/line_easing.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double step_share = 1.5;  // of the reach, between the places that are moved
constexpr int rounds = 100;         // with the steps, a deviation of some nine reaches

/// A stretch of a line whose ends stay, and all points of which are to be eased.
class EasedStretch {
public:
    EasedStretch(const std::vector<DrawnPoint>& points, double reach) : reach_(reach) {
        double length = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) length += (points[i].position - points[i - 1].position).norm();
            along_.push_back(length);
        }
        count_ = std::size_t(std::ceil(length / (step_share * reach)));
        if (count_ < 2) return;
        for (std::size_t i = 0; i <= count_; ++i)
            original_.push_back(placeAt(points, length * double(i) / double(count_)));
        eased_ = original_;
    }

    /// Whether it is so long that there is anything to ease.
    bool isLong() const { return count_ >= 2; }

    void ease(bool closed) {
        const std::size_t n = count_;
        for (int round = 0; round < rounds; ++round) {
            const std::vector<Vector2d> before = eased_;
            for (std::size_t i = closed ? 0 : 1; i < n; ++i) {
                const Vector2d middle = (before[i == 0 ? n - 1 : i - 1] + before[i + 1]) / 2;
                const Vector2d wanted = (before[i] + middle) / 2, off = wanted - original_[i];
                const double distance = off.norm();
                eased_[i] = original_[i] + (distance > reach_ ? reach_ / distance : 1) * off;
            }
            if (closed) eased_[n] = eased_[0];
        }
    }

    std::vector<DrawnPoint> result(const std::vector<DrawnPoint>& points) const {
        std::vector<DrawnPoint> eased;
        for (std::size_t i = 0; i <= count_; ++i)
            eased.push_back({eased_[i]});
        eased.front().node = points.front().node;
        eased.back().node = points.back().node;
        return eased;
    }

    /// Where a point of the line is now.
    Vector2d placeOf(std::size_t point) const {
        const double at = along_[point] / along_.back() * double(count_);
        const std::size_t i = std::min(std::size_t(at), count_ - 1);
        return eased_[i] + (at - double(i)) * (eased_[i + 1] - eased_[i]);
    }

private:
    Vector2d placeAt(const std::vector<DrawnPoint>& points, double length) const {
        const auto after = std::lower_bound(along_.begin(), along_.end(), length);
        const std::size_t i = std::min(std::size_t(after - along_.begin()), along_.size() - 1);
        if (i == 0) return points[0].position;
        const double t = (length - along_[i - 1]) / (along_[i] - along_[i - 1]);
        return points[i - 1].position + t * (points[i].position - points[i - 1].position);
    }

    const double reach_;
    std::vector<double> along_;  // of the points
    std::size_t count_ = 0;      // of steps
    std::vector<Vector2d> original_, eased_;
};

class Easing {
public:
    explicit Easing(double reach) : reach_(reach) {}

    void ease(DrawnLine& line) {
        const auto& points = line.points;
        const auto first = std::find_if(points.begin(), points.end() - 1,
                                        [](const DrawnPoint& p) { return p.is_exact; });
        if (line.closed && first == points.end() - 1) {
            line.points = easedStretch(points, true);
            return;
        }
        if (line.closed) {  // begins at a point that stays
            std::rotate(line.points.begin(), line.points.begin() + (first - points.begin()),
                        line.points.end() - 1);
            line.points.back() = line.points.front();
        }
        std::vector<DrawnPoint> eased;
        for (std::size_t begin = 0, end; begin + 1 < points.size(); begin = end) {
            for (end = begin + 1; end + 1 < points.size() && !points[end].is_exact; ++end) {
            }
            const std::vector<DrawnPoint> stretch(points.begin() + std::ptrdiff_t(begin),
                                                  points.begin() + std::ptrdiff_t(end) + 1);
            const auto part = easedStretch(stretch, false);
            eased.insert(eased.end(), part.begin() + (eased.empty() ? 0 : 1), part.end());
        }
        line.points = std::move(eased);
    }

    /// Moves the ends of lines to where lines that pass there have gone.
    void follow(DrawnLine& line) const {
        if (line.closed) return;
        for (DrawnPoint* end : {&line.points.front(), &line.points.back()}) {
            const auto moved = moved_.find(end->node);
            if (moved != moved_.end()) end->position = moved->second;
        }
    }

private:
    std::vector<DrawnPoint> easedStretch(const std::vector<DrawnPoint>& points, bool closed) {
        if (points.size() < 3) return points;
        EasedStretch stretch(points, reach_);
        if (!stretch.isLong()) return points;
        stretch.ease(closed);
        for (std::size_t i = closed ? 0 : 1; i + 1 < points.size(); ++i)
            if (points[i].node != laplacian_lines::kNoSightNode)
                moved_.try_emplace(points[i].node, stretch.placeOf(i));
        return stretch.result(points);
    }

    const double reach_;
    std::unordered_map<std::uint32_t, Vector2d> moved_;  // nodes
};

}  // namespace

void easeLines(std::vector<DrawnLine>& lines, double reach) {
    Easing easing(reach);
    for (const LineClass c : {LineClass::Outline, LineClass::Contour})
        for (DrawnLine& line : lines)
            if (line.line_class == c && line.points.size() > 2) easing.ease(line);
    for (DrawnLine& line : lines)
        easing.follow(line);
}

}  // namespace line_drawing
