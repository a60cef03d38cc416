// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/near_lines.h"

#include <algorithm>
#include <cmath>

#include "system/parallel.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr float kAlong = 0.5f;       // least squared cosine
constexpr float kMostPieces = 1e6f;  // of a segment, whatever the distance

/// 21 bits of each: far cells may share a key, which only costs time.
template <class Cell>
std::uint64_t key_of(const Cell& cell) {
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k)
        key = key << 21 | (std::uint32_t(cell[k]) & 0x1fffffu);
    return key;
}

template <class Cell>
Cell cell_at(const Eigen::Vector3f& p, float size) {
    return (p / size)
        .unaryExpr([](float x) { return std::floor(std::clamp(x, -1e9f, 1e9f)); })
        .template cast<std::int32_t>();
}

}  // namespace

NearLines::NearLines(const LineSet& lines, float distance) : distance_(distance) {
    if (!(distance > 0)) return;
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = 1; i < line.count; ++i) {
            const LinePoint* point = lines.points.data() + line.first + i;
            add(point[-1].position, point[0].position);
        }
}

/// In pieces no longer than a cell, by the cells of their middles: a neighbouring cell holds any
/// that is near.
void NearLines::add(const Eigen::Vector3f& begin, const Eigen::Vector3f& end) {
    const float count = std::clamp(std::ceil(length_of(end - begin) / distance_), 1.f, kMostPieces);
    for (float i = 0; i < count; ++i) {
        const Eigen::Vector3f a = begin + i / count * (end - begin);
        const Eigen::Vector3f b = begin + (i + 1) / count * (end - begin);
        const auto number = std::uint32_t(pieces_.size());
        const auto [place, is_new] =
            first_of_cell_.try_emplace(key_of(cell_at<Cell>((a + b) / 2, 2 * distance_)), number);
        pieces_.push_back({a, b, is_new ? kNone : place->second});
        place->second = number;
    }
}

bool NearLines::is_along(const Piece& piece, const Eigen::Vector3f& p,
                         const Eigen::Vector3f& direction) const {
    const Eigen::Vector3f span = piece.end - piece.begin;
    const float length = squared_length_of(span);
    const float t = length > 0 ? std::clamp(dot(p - piece.begin, span) / length, 0.f, 1.f) : 0.f;
    if (squared_length_of(piece.begin + t * span - p) > distance_ * distance_) return false;
    const float product = dot(span, direction);
    return product * product >= kAlong * length * squared_length_of(direction);
}

bool NearLines::any_along(const Eigen::Vector3f& p, const Eigen::Vector3f& direction) const {
    if (!(distance_ > 0) || !p.allFinite()) return false;
    const Cell middle = cell_at<Cell>(p, 2 * distance_);
    for (int i = 0; i < 27; ++i) {
        const Cell cell = middle + Cell(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const auto found = first_of_cell_.find(key_of(cell));
        if (found == first_of_cell_.end()) continue;
        for (std::uint32_t k = found->second; k != kNone; k = pieces_[k].next)
            if (is_along(pieces_[k], p, direction)) return true;
    }
    return false;
}

std::vector<std::uint8_t> points_along(const LineSet& lines, const NearLines& others) {
    std::vector<std::uint8_t> along(lines.points.size(), 0);
    in_parallel(lines.lines.size(), [&](std::size_t number) {
        const Polyline& line = lines.lines[number];
        const LinePoint* points = lines.points.data() + line.first;
        for (std::uint32_t i = 0; i < line.count; ++i) {
            const Eigen::Vector3f direction = points[std::min(i + 1, line.count - 1)].position -
                                              points[i > 0 ? i - 1 : 0].position;
            along[line.first + i] = others.any_along(points[i].position, direction);
        }
    });
    return along;
}

}  // namespace laplacian_lines
