// SPDX-License-Identifier: GPL-3.0-or-later
// The path from the tested edge E over the facets on one side, with centres c, d, e, bends a, b:
//
//     E      c      a      d      b      e
//     |------.------|------.------|------.---
//     0    half()
//
// An arc of curvature k turns at each bend by k times the distance of the centres beside it, so k
// is turn(a) / (d - c); the side is an arc if turn(b) / (e - d) is alike. E, between the first
// centres of both sides, then turns by the sum of their k half(): see explained(). Where a fillet
// ends at a, tangentially, turn(a) is k (a - c).
#include "fixed/crease_edges.h"

#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

constexpr int kMostTriangles = 40;  // of a walk
constexpr int kMostAtCorner = 256;  // of a vertex; rims of disks have corners of many
// Shares of the edge's angle: bends up to the first are within a facet, from the second on a
// curvature can be measured.
constexpr float kWithinFacet = 0.25f, kMeasurable = 0.5f;
// Facets of one face are alike: curvatures and widths from one to the next differ less.
constexpr float kAlike = 3;
// Degrees at which three facets between two edges are an arc. Flanks of teeth, which are modelled
// by a few flat faces, turn less, and arcs that do are given more facets. Flat roofs turn more,
// arcs hardly, see kEdgeAngle.
constexpr float kLeastOfThree = 12, kMostOfThree = 35;

bool are_alike(float a, float b) {
    return a <= kAlike * b && b <= kAlike * a;
}

/// Whether exactly three edges of at least this angle, an edge among them, meet at its vertex
/// `end`, and not both others have kEdgeAngle.
bool is_corner(const Surface& surface, std::uint32_t side, std::uint32_t end, float least) {
    int edges = 0, sharp = 0;
    std::uint32_t at = side;
    for (int i = 0; i < kMostAtCorner; ++i) {
        // the other side there
        at = surface.begin(at) == end ? previous_side(at) : next_side(at);
        if (!surface.has_neighbour(at)) return false;
        const float angle = std::abs(signed_angle(surface, at));
        edges += angle >= least;
        sharp += angle >= kEdgeAngle;
        at = surface.across(at);
        if (at / 3 == side / 3) return edges == 3 && sharp < 2;
    }
    return false;
}

/// Whether an edge may be between facets of an arc that has only three: such facets are strips,
/// which do not have such corners at both ends.
bool may_be_of_three(const Surface& surface, std::uint32_t side, float angle) {
    const float least = kWithinFacet * std::abs(angle);
    return !is_corner(surface, side, surface.begin(side), least) ||
           !is_corner(surface, side, surface.end(side), least);
}

/// Nearly coplanar triangles.
struct Facet {
    float centre, end;  // along the path
    float turn;         // at its end, degrees: 0, or more if it turns as the tested edge
    bool is_flat;       // has several triangles, on the path or beside it
    bool bends_back;    // the first: is one triangle; at another side the surface bends back
};

/// The facets on one side, up to an edge of the form, a border, or where the surface bends back.
class FacetWalk {
public:
    /// `angle`: by which the path turns at the tested edge; angles are signed like it.
    FacetWalk(const Surface& surface, std::uint32_t from, float lean, float angle)
        : walk_(surface, from, lean),
          sign_(angle > 0 ? 1.f : -1.f),
          least_(kWithinFacet * std::abs(angle)) {}

    enum class End { None, Edge, Back };
    End end() const { return end_; }

    /// The next one; false if there is none.
    bool next(Facet& facet) {
        if (is_over_) return false;
        float area = 0, moment = 0;
        const float begin = walk_.begin();
        facet = {0, 0, 0, false, false};
        for (;;) {
            area += walk_.area();
            moment += walk_.area() * walk_.centre();
            facet.is_flat = facet.is_flat || walk_.has_side_within(least_);
            ++count_;
            facet.bends_back = count_ == 1 && has_side_bent_back();  // not of two triangles
            if (ends_facet(facet)) break;
            walk_.advance();
        }
        facet.centre = moment / area;
        facet.end = walk_.end();
        // the path may pass only a corner of a long facet
        if (facet.turn > 0 && !(facet.centre > begin && facet.centre < facet.end))
            facet.centre = (begin + facet.end) / 2;
        if (!is_over_) walk_.advance();
        return true;
    }

private:
    bool has_side_bent_back() const {
        const float least = kMeasurable / kWithinFacet * least_.degrees;
        return sign_ > 0 ? walk_.has_side_between(-kEdgeAngle, -least)
                         : walk_.has_side_between(least, kEdgeAngle);
    }
    /// Whether the facet ends with this triangle; sets its turn, and whether the walk is over.
    bool ends_facet(Facet& facet) {
        if (walk_.continues_within(least_)) {
            is_over_ = count_ == kMostTriangles;
            return is_over_;
        }
        const float turn = walk_.is_at_border() ? 0 : sign_ * walk_.turn();
        if (walk_.is_at_border() || std::abs(walk_.angle()) >= kEdgeAngle)
            end_ = End::Edge;
        else if (turn <= -least_.degrees)
            end_ = End::Back;
        is_over_ = end_ != End::None || count_ == kMostTriangles;
        if (is_over_) return true;
        facet.turn = turn >= least_.degrees ? turn : 0;
        return turn >= least_.degrees;
    }

    SurfaceWalk walk_;
    const float sign_;
    const SmallAngle least_;
    int count_ = 0;
    bool is_over_ = false;
    End end_ = End::None;
};

/// The curvature on one side of the tested edge.
class FacetSide {
public:
    FacetSide(const Surface& surface, std::uint32_t from, float lean, float angle, bool of_three)
        : walk_(surface, from, lean, angle),
          telling_(kMeasurable * std::abs(angle)),
          of_three_(of_three) {
        Facet facet;
        if (!walk_.next(facet)) return;
        half_ = facet.centre;
        is_flat_ = facet.is_flat || (walk_.end() == FacetWalk::End::Edge && !facet.bends_back);
        Bend first;
        if (!advance(facet, first)) return;
        curvature_ = first.turn / least_distance(facet.centre - half_);
        judge_beyond(facet, first, std::abs(angle));
    }

    float half() const { return half_; }            ///< from the edge to the first facet's centre
    float curvature() const { return curvature_; }  ///< beyond that, degrees/D; 0: none
    bool is_arc() const { return is_arc_; }         ///< the surface beyond is curved like this
    /// Curvature of a fillet that ends, tangentially, with the first bend; 0: none does.
    float last_curvature() const { return last_curvature_; }
    bool is_clear() const { return is_flat_ || is_arc_ || last_curvature_ > 0; }

private:
    /// Successive edges at which the surface turns.
    struct Bend {
        float turn = 0;  ///< degrees
        float end = 0;   ///< the last of them, along the path
    };

    static float least_distance(float distance) { return std::max(distance, 1e-12f); }  // not 0

    /// Advances until the surface has turned enough to measure a curvature.
    bool advance(Facet& facet, Bend& bend) {
        while (bend.turn < telling_) {
            if (!(facet.turn > 0)) return false;
            bend.turn += facet.turn;
            bend.end = facet.end;
            if (!walk_.next(facet)) return false;
        }
        return true;
    }

    /// Compares the first bend with the surface behind it, which begins with `facet`. If that is
    /// curved likewise, both are an arc. If it is less curved, or turns no more and its facet is
    /// over kAlike times as wide as the first one, a fillet ends with the bend.
    void judge_beyond(Facet facet, const Bend& first, float angle) {
        const float behind = facet.centre;
        Bend next;
        bool is_end = true;
        if (advance(facet, next)) {
            const float beyond = next.turn / least_distance(facet.centre - behind);
            is_arc_ = are_alike(beyond, curvature_);
            is_end = !is_arc_ && !(beyond > curvature_);
        } else {
            const float width = behind - first.end, own = first.end - half_;
            is_arc_ = of_three_ && walk_.end() != FacetWalk::End::None && angle >= kLeastOfThree &&
                      angle <= kMostOfThree && are_alike(width, own);
            is_end = !(width <= kAlike * own);
        }
        if (is_end) last_curvature_ = first.turn / least_distance(first.end - half_);
    }

    FacetWalk walk_;
    const float telling_;  // degrees, from which on a curvature can be measured
    const bool of_three_;  // whether it may be an arc of three facets
    float half_ = 0, curvature_ = 0, last_curvature_ = 0;
    bool is_arc_ = false, is_flat_ = false;
};

/// By how much the edge would turn if it only separated facets of a curved face, degrees.
float explained(const FacetSide& a, const FacetSide& b) {
    if (a.is_arc() && b.is_arc()) return a.curvature() * a.half() + b.curvature() * b.half();
    if (a.is_arc() || b.is_arc()) {
        const FacetSide& arc = a.is_arc() ? a : b;
        const FacetSide& other = a.is_arc() ? b : a;
        const float own = arc.curvature() * arc.half();
        // the other side's is the last facet of the arc, if it is not much wider than the others
        return other.half() <= kAlike * arc.half() ? own + arc.curvature() * other.half() : own;
    }
    // Two facets in all: a fillet, tangent at both ends.
    if (a.last_curvature() > 0 && b.last_curvature() > 0 &&
        are_alike(a.last_curvature(), b.last_curvature()))
        return a.last_curvature() * a.half() + b.last_curvature() * b.half();
    return 0;
}

}  // namespace

CreaseJump crease_jump(const Surface& surface, std::uint32_t side, float angle) {
    const float sign = surface.sign_across(side);
    const bool of_three = may_be_of_three(surface, side, angle);
    const float lean = lean_of_boundaries(surface, side), turn = angle * std::sqrt(1 - lean * lean);
    const FacetSide here(surface, side, lean, turn, of_three),
        there(surface, surface.across(side), sign * lean, sign * turn, of_three);
    return {std::abs(angle) * (1 - explained(here, there) / std::abs(turn)),
            here.is_clear() && there.is_clear()};
}

}  // namespace laplacian_lines
