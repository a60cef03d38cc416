// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/ridge_candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "fixed/section_profile.h"
#include "system/parallel.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Sample = ZeroLines::Sample;

// How the angle of an edge is measured:
//  1. Walk over the surface across the line, every .3 % of D. T(d) is the angle by which the normal
//     turns within the distance d on one side of the line.
//  2. Average T over the sections within .75 % of D, not across the start of a closed line.
//  3. An edge does not turn beyond 2 % of D, a bump does: A = 2 T(2 %) - T(4 %) on either side.
//  4. The clear part of the turn is A1 + A2 - 1.5 |A1 - A2|. From .3 of the turn on, all of it
//     is the angle, below in proportion. Edges of details are measured likewise within 1 and 2 %
//     of D; their angle counts a quarter.
//  5. A groove turns back at its shoulders: of valleys, the largest turns to either side within 1 %
//     of D count half, by the rule of 4. The ribs between grooves show by these.

/// A width within which an edge turns, to each side, and which share of the turn counts.
struct Scale {
    float near;   ///< D
    float share;  ///< of the turn
};
constexpr Scale kScales[] = {{0.02f, 1}, {0.01f, 0.25f}};

// In D.
constexpr float kReach = 0.04f;        // of a section, to each side
constexpr float kStep = 0.003f;        // between the sections of a line
constexpr float kMeanReach = 0.0075f;  // along the line, of the mean of sections
constexpr float kGrooveReach = 0.01f;  // of a groove, to each side

constexpr float kGrooveShare = 0.5f;  // of the turns of a groove that counts
constexpr float kSkew = 1.5f;         // weight of the difference of the sides against their sum
constexpr float kClear = 0.3f;        // least clear share of the turn for all of it to count

/// The part of the turn `all` that is an edge's, where `a` and `b` are clear on the two sides.
float clear_angle(float a, float b, float all) {
    const float clear = a + b - kSkew * std::abs(a - b);
    return all > 0 ? all * std::clamp(clear / (kClear * all), 0.f, 1.f) : 0;
}

/// By how much the surface turns at a section, or at several on average, at one scale; degrees.
struct Turn {
    float near[2] = {0, 0};  ///< on either side
    float far[2] = {0, 0};   ///< within twice the distance

    Turn() = default;
    Turn(const SectionProfile& profile, float distance)
        : near{-profile.angle(-distance), profile.angle(distance)},
          far{-profile.angle(-2 * distance), profile.angle(2 * distance)} {}

    void add(const Turn& other, float share) {
        for (int side = 0; side < 2; ++side) {
            near[side] += share * other.near[side];
            far[side] += share * other.far[side];
        }
    }

    /// 0 where the surface turns evenly: far = 2 near.
    float edge_angle() const {
        return clear_angle(2 * near[0] - far[0], 2 * near[1] - far[1], near[0] + near[1]);
    }
};

/// The turns of a section, or of several on average.
struct Turns {
    Turn at_scale[std::size(kScales)];
    float groove = 0;  ///< its angle, degrees; 0 of ridges

    Turns() = default;
    Turns(const SectionProfile& profile, Crest crest) {
        for (std::size_t k = 0; k < std::size(kScales); ++k)
            at_scale[k] = Turn(profile, kScales[k].near);
        if (crest.sign > 0) return;
        const float a = profile.largest_turn(-kGrooveReach), b = profile.largest_turn(kGrooveReach);
        groove = clear_angle(a, b, a + b);
    }

    void add(const Turns& other, float share) {
        for (std::size_t k = 0; k < std::size(kScales); ++k)
            at_scale[k].add(other.at_scale[k], share);
        groove += share * other.groove;
    }

    float edge_angle() const {
        float angle = kGrooveShare * groove;
        for (std::size_t k = 0; k < std::size(kScales); ++k)
            angle = std::max(angle, kScales[k].share * at_scale[k].edge_angle());
        return angle;
    }
};

/// The angles of one line.
class LineAngles {
public:
    LineAngles(std::uint32_t count, const Sample* samples) : count_(count), points_(samples) {}

    void measure(const Surface& surface, Crest crest) {
        measure_arc_lengths();
        choose_sections();
        const std::size_t n = sections_.size();
        turns_.resize(n);
        SectionProfile profile;
        for (std::size_t s = 0; s < n; ++s) {
            profile.measure(surface, section(sections_[s]), crest.sign, kReach);
            turns_[s] = Turns(profile, crest);
        }
        angles_.resize(n);
        for (std::size_t s = 0; s < n; ++s)
            angles_[s] = mean_turns(s).edge_angle();
    }

    /// Linear between the sections.
    void write(LinePoint* points) const {
        std::size_t s = 0;
        for (std::uint32_t i = 0; i < count_; ++i) {
            while (s + 2 < sections_.size() && sections_[s + 1] < i)
                ++s;
            const float begin = arc_lengths_[sections_[s]], end = arc_lengths_[sections_[s + 1]];
            const float t = end > begin ? (arc_lengths_[i] - begin) / (end - begin) : 0;
            points[i].gradient = (1 - t) * angles_[s] + t * angles_[s + 1];
        }
    }

private:
    void measure_arc_lengths() {
        arc_lengths_.assign(1, 0);
        for (std::uint32_t i = 1; i < count_; ++i)
            arc_lengths_.push_back(arc_lengths_.back() +
                                   length_of(points_[i].position - points_[i - 1].position));
    }

    /// Both ends are among them.
    void choose_sections() {
        sections_.assign(1, 0);
        for (std::uint32_t i = 1; i + 1 < count_; ++i)
            if (arc_lengths_[i] - arc_lengths_[sections_.back()] >= kStep) sections_.push_back(i);
        sections_.push_back(count_ - 1);
    }

    /// Across the line, to its left.
    Section section(std::uint32_t i) const {
        const Sample& here = points_[i];
        const Eigen::Vector3f along =
            points_[std::min(i + 1, count_ - 1)].position - points_[i > 0 ? i - 1 : 0].position;
        const Eigen::Vector3f normal = unit(here.normal);
        const Eigen::Vector3f across = unit(here.bend - dot(normal, here.bend) * normal);
        const bool is_left = dot(across, normal.cross(along)) >= 0;
        return {here.side, here.position, normal, is_left ? across : -across};
    }

    Turns mean_turns(std::size_t s) const {
        const auto is_near = [&](std::size_t other) {
            return std::abs(arc_lengths_[sections_[other]] - arc_lengths_[sections_[s]]) <=
                   kMeanReach;
        };
        std::size_t begin = s, end = s + 1;
        while (begin > 0 && is_near(begin - 1))
            --begin;
        while (end < sections_.size() && is_near(end))
            ++end;
        Turns mean;
        for (std::size_t other = begin; other < end; ++other)
            mean.add(turns_[other], 1 / float(end - begin));
        return mean;
    }

    const std::uint32_t count_;
    const Sample* const points_;
    std::vector<float> arc_lengths_;       // lengths from the start of the line to its points, D
    std::vector<std::uint32_t> sections_;  // points that have a section
    std::vector<Turns> turns_;             // by section
    std::vector<float> angles_;            // degrees, by section
};

}  // namespace

void measure_ridge_angles(const Surface& surface, Crest crest, ZeroLines& candidates) {
    LineSet& lines = candidates.lines;
    in_parallel(lines.lines.size(), [&](std::size_t number) {
        const Polyline& line = lines.lines[number];
        LineAngles angles(line.count, candidates.samples.data() + line.first);
        angles.measure(surface, crest);
        angles.write(lines.points.data() + line.first);
    });
}

}  // namespace laplacian_lines
