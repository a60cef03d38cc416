// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/midpoints.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "mesh/bounding_box.h"

namespace laplacian_lines {
namespace {

// Of the largest coordinate: what rounding to floats, twice, moves the middle of an edge by.
constexpr double kRounding = 5e-7;
constexpr std::uint32_t kNone = 0xffffffffu;

using Positions = std::vector<Eigen::Vector3d>;

double largest_coordinate(const Positions& positions, const std::vector<Triangle>& triangles) {
    const Eigen::AlignedBox3d box = bounding_box(positions, triangles);
    return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

class MidpointTest {
public:
    MidpointTest(const Positions& positions, double within)
        : positions_(positions), within_(within) {}

    bool operator()(std::uint32_t middle, std::uint32_t a, std::uint32_t b) const {
        return a != b &&
               ((positions_[a] + positions_[b]) / 2 - positions_[middle]).cwiseAbs().maxCoeff() <=
                   within_;
    }

private:
    const Positions& positions_;
    const double within_;
};

bool has(const Triangle& t, std::uint32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
}

/// Whether a vertex is in the middle between two others of the triangles that have it.
bool is_midpoint(std::uint32_t vertex, const std::vector<Triangle>& triangles,
                 const MidpointTest& is_middle) {
    std::vector<std::uint32_t> ring;
    for (const Triangle& t : triangles)
        if (has(t, vertex)) ring.insert(ring.end(), t.begin(), t.end());
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    for (const std::uint32_t a : ring)
        for (const std::uint32_t b : ring)
            if (a < b && a != vertex && b != vertex && is_middle(vertex, a, b)) return true;
    return false;
}

/// The triangles at each vertex.
class TrianglesAt {
public:
    TrianglesAt(std::size_t vertices, const std::vector<Triangle>& triangles)
        : starts_(vertices + 2, 0), triangles_(3 * triangles.size()) {
        for (const Triangle& t : triangles)
            for (const std::uint32_t v : t)
                ++starts_[v + 2];
        for (std::size_t v = 2; v < starts_.size(); ++v)
            starts_[v] += starts_[v - 1];
        for (std::uint32_t i = 0; i < triangles.size(); ++i)
            for (const std::uint32_t v : triangles[i])
                triangles_[starts_[v + 1]++] = i;
    }
    const std::uint32_t* begin(std::size_t v) const { return triangles_.data() + starts_[v]; }
    const std::uint32_t* end(std::size_t v) const { return triangles_.data() + starts_[v + 1]; }

private:
    std::vector<std::uint32_t> starts_, triangles_;
};

/// Puts quarters together, from one corner of a large triangle to the next.
class QuarterJoiner {
public:
    QuarterJoiner(const Positions& positions, const std::vector<Triangle>& triangles,
                  const MidpointTest& is_middle)
        : triangles_(triangles),
          is_middle_(is_middle),
          at_(positions.size(), triangles),
          role_(positions.size(), Role::Unknown),
          is_done_(triangles.size(), 0) {}

    bool run() {
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            if (is_done_[i]) continue;
            const std::optional<std::uint32_t> corner = find_corner(i);
            if (!corner || !join_from(*corner)) return false;
        }
        return 4 * joined_.size() == triangles_.size();
    }

    std::vector<Triangle> take_triangles() {
        std::sort(joined_.begin(), joined_.end(), [](const Joined& a, const Joined& b) {
            return a.first_quarter < b.first_quarter;
        });
        std::vector<Triangle> large;
        large.reserve(joined_.size());
        for (const Joined& j : joined_)
            large.push_back(j.triangle);
        return large;
    }
    const std::vector<Midpoint>& midpoints() const { return midpoints_; }

private:
    enum class Role : std::uint8_t { Unknown, Corner, Middle };
    struct Joined {
        Triangle triangle;
        std::uint32_t first_quarter;
    };

    /// Of a large triangle, by steps from triangle to triangle: vertices farthest to one side are
    /// no midpoints. The first one that is none.
    std::optional<std::uint32_t> find_corner(std::uint32_t triangle) {
        std::vector<std::uint32_t> reached = {triangle};
        std::vector<std::uint8_t>& seen = is_reached_;
        seen.resize(triangles_.size(), 0);
        seen[triangle] = 1;
        for (std::size_t i = 0; i < reached.size(); ++i)
            for (const std::uint32_t v : triangles_[reached[i]]) {
                if (!is_midpoint(v, triangles_around(v), is_middle_)) return v;
                for (const std::uint32_t* t = at_.begin(v); t != at_.end(v); ++t)
                    if (!seen[*t]) seen[*t] = 1, reached.push_back(*t);
            }
        return std::nullopt;
    }
    std::vector<Triangle> triangles_around(std::uint32_t v) const {
        std::vector<Triangle> around;
        for (const std::uint32_t* t = at_.begin(v); t != at_.end(v); ++t)
            around.push_back(triangles_[*t]);
        return around;
    }

    bool join_from(std::uint32_t corner) {
        if (!set_role(corner, Role::Corner)) return false;
        corners_ = {corner};
        while (!corners_.empty()) {
            const std::uint32_t next = corners_.back();
            corners_.pop_back();
            for (const std::uint32_t* t = at_.begin(next); t != at_.end(next); ++t)
                if (!is_done_[*t] && !join(next, *t)) return false;
        }
        return true;
    }

    /// The large triangle with a corner in this quarter.
    bool join(std::uint32_t corner, std::uint32_t quarter) {
        const Triangle q = turned(triangles_[quarter], corner);
        const std::uint32_t inner = across(quarter, q[1], q[2]);
        if (inner == kNone) return false;
        const std::uint32_t third = last_of(triangles_[inner], q[1], q[2]);
        const std::uint32_t second_quarter = across(inner, q[1], third),
                            third_quarter = across(inner, q[2], third);
        if (second_quarter == kNone || third_quarter == kNone) return false;
        const std::uint32_t b = last_of(triangles_[second_quarter], q[1], third),
                            c = last_of(triangles_[third_quarter], q[2], third);
        if (!add_midpoint(q[1], corner, b) || !add_midpoint(third, b, c) ||
            !add_midpoint(q[2], c, corner))
            return false;
        for (const std::uint32_t part : {quarter, inner, second_quarter, third_quarter})
            if (is_done_[part]++) return false;
        add({corner, b, c}, {quarter, second_quarter, third_quarter}, inner);
        return set_role(b, Role::Corner) && set_role(c, Role::Corner);
    }

    /// Begins with the corner of the first quarter.
    void add(const Triangle& large, const Triangle& quarters, std::uint32_t inner) {
        const auto first = std::min_element(quarters.begin(), quarters.end());
        const auto k = std::size_t(first - quarters.begin());
        joined_.push_back(
            {{large[k], large[(k + 1) % 3], large[(k + 2) % 3]}, std::min(*first, inner)});
    }

    bool set_role(std::uint32_t v, Role role) {
        if (role_[v] == Role::Unknown && role == Role::Corner) corners_.push_back(v);
        if (role_[v] == Role::Unknown) role_[v] = role;
        return role_[v] == role;
    }

    bool add_midpoint(std::uint32_t v, std::uint32_t a, std::uint32_t b) {
        if (!is_middle_(v, a, b)) return false;
        if (role_[v] == Role::Unknown) midpoints_.push_back({v, {a, b}});
        return set_role(v, Role::Middle);
    }

    static Triangle turned(const Triangle& t, std::uint32_t first) {
        return t[0] == first   ? t
               : t[1] == first ? Triangle{t[1], t[2], t[0]}
                               : Triangle{t[2], t[0], t[1]};
    }
    static std::uint32_t last_of(const Triangle& t, std::uint32_t a, std::uint32_t b) {
        return t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
    }
    /// kNone unless there is just one.
    std::uint32_t across(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const {
        std::uint32_t found = kNone;
        for (const std::uint32_t* t = at_.begin(a); t != at_.end(a); ++t) {
            if (*t == triangle || !has(triangles_[*t], b)) continue;
            if (found != kNone) return kNone;
            found = *t;
        }
        return found;
    }

    const std::vector<Triangle>& triangles_;
    const MidpointTest& is_middle_;
    const TrianglesAt at_;
    std::vector<Role> role_;                          // by vertex
    std::vector<std::uint8_t> is_done_, is_reached_;  // by triangle
    std::vector<std::uint32_t> corners_;              // to go on from
    std::vector<Joined> joined_;
    std::vector<Midpoint> midpoints_;
};

}  // namespace

bool undo_subdivision(const Positions& positions, std::vector<Triangle>& triangles,
                      std::vector<Midpoint>& midpoints) {
    if (triangles.empty() || triangles.size() % 4 != 0) return false;
    const MidpointTest is_middle(positions, kRounding * largest_coordinate(positions, triangles));
    QuarterJoiner joiner(positions, triangles, is_middle);
    if (!joiner.run()) return false;
    triangles = joiner.take_triangles();
    midpoints.insert(midpoints.end(), joiner.midpoints().begin(), joiner.midpoints().end());
    return true;
}

}  // namespace laplacian_lines
