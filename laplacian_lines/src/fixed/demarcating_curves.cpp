// SPDX-License-Identifier: GPL-3.0-or-later
// Demarcating curves: zeros of g·S̄ g, the curvature along g, where g is the direction in which
// C(g, g, g), its change along g, is largest: M. Kolomenkin, I. Shimshoni, A. Tal: "Demarcating
// Curves for Shape Illustration", SIGGRAPH Asia 2008. g points from concave to convex; no curve
// passes triangles in which g turns by more than 45 degrees. Curves that are strong enough are
// shown, with their weaker continuations.
#include <algorithm>

#include "fixed/fixed_lines.h"
#include "fixed/strong_lines.h"
#include "fixed/surface.h"
#include "laplacian_lines/tangent_frame.h"
#include "rules/line_rules.h"
#include "rules/thresholds.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr int kDirections = 36;    // that are tried; a cubic has at most three maxima
constexpr float kClear = 0.9f;     // most of the second largest maximum over the largest
constexpr float kMostStep = 0.1f;  // radians, of three; few maxima are over .09 from a sample
constexpr float kLeastAgreement = 0.7071f;  // cosine, of 45 degrees, between g at two corners
constexpr float kLeastLength = 0.02f;       // D, of a curve and of its strong part
constexpr float kShortestLines = 2;         // of a curve; noise makes longer zeros of derivatives
constexpr float kFading = 3;  // times the style's: a gentle relief is paler than a steep one

/// C(g, g, g) of g = (x, y).
float cubic(const Eigen::Vector4f& c, float x, float y) {
    return x * x * (c[0] * x + 3 * c[1] * y) + y * y * (3 * c[2] * x + c[3] * y);
}

/// A maximum of the cubic near an angle, by Newton's method.
float refined(const Eigen::Vector4f& c, float angle) {
    for (int step = 0; step < 3; ++step) {
        const float x = cosine_of(angle), y = sine_of(angle);
        // A third of the gradient and a sixth of the second derivatives.
        const float fx = c[0] * x * x + 2 * c[1] * x * y + c[2] * y * y;
        const float fy = c[1] * x * x + 2 * c[2] * x * y + c[3] * y * y;
        const float fxx = c[0] * x + c[1] * y, fxy = c[1] * x + c[2] * y, fyy = c[2] * x + c[3] * y;
        const float first = x * fy - y * fx;
        const float second = 2 * (fxx * y * y - 2 * fxy * x * y + fyy * x * x) - (fx * x + fy * y);
        if (!(second < 0)) break;
        angle -= std::clamp(first / second, -kMostStep, kMostStep);
    }
    return angle;
}

/// The direction in a tangent plane in which C(g, g, g) is largest.
struct CurvatureGradient {
    Eigen::Vector2f direction = Eigen::Vector2f::Zero();  ///< g in the frame of C, unit
    float slope = 0;  ///< C(g, g, g); 0: no maximum is clearly the largest
};

CurvatureGradient curvature_gradient(const Eigen::Vector4f& derivative) {
    constexpr float step = 2 * float(EIGEN_PI) / kDirections;
    float values[kDirections];
    for (int i = 0; i < kDirections; ++i)
        values[i] = cubic(derivative, cosine_of(float(i) * step), sine_of(float(i) * step));
    CurvatureGradient best;
    float second = 0;
    for (int i = 0; i < kDirections; ++i) {
        if (!(values[i] > values[(i + kDirections - 1) % kDirections] &&
              values[i] >= values[(i + 1) % kDirections]))
            continue;
        const float angle = refined(derivative, float(i) * step);
        const float x = cosine_of(angle), y = sine_of(angle), slope = cubic(derivative, x, y);
        second = std::max(second, std::min(slope, best.slope));
        if (slope > best.slope) best = {{x, y}, slope};
    }
    return second > kClear * best.slope ? CurvatureGradient() : best;
}

struct Demarcation {
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();  ///< g; 0: there is none
    Eigen::Vector3f bend = Eigen::Vector3f::Zero();       ///< S̄ g
    float curvature = 0;                                  ///< g·S̄ g
    float strength = 0;                                   ///< C(g, g, g), degrees/D²
};

Demarcation demarcation(const CurvatureRecord& record) {
    Demarcation result;
    const CurvatureGradient gradient =
        curvature_gradient(Eigen::Map<const Eigen::Vector4f>(record.derivative));
    if (!(gradient.slope > 0)) return result;
    const TangentFrame frame = tangent_frame(Eigen::Map<const Eigen::Vector3f>(record.normal));
    const float* const s = record.curvature;
    const Eigen::Vector2f& g = gradient.direction;
    const Eigen::Vector2f bend(s[0] * g.x() + s[1] * g.y(), s[1] * g.x() + s[2] * g.y());
    result.direction = g.x() * frame.u + g.y() * frame.v;
    result.bend = bend.x() * frame.u + bend.y() * frame.v;
    result.curvature = g.dot(bend);
    result.strength = kDegrees * gradient.slope;
    return result;
}

/// Finds the pieces in a cluster; the value of their zeros is C(g, g, g), degrees/D².
class ClusterCurves {
public:
    explicit ClusterCurves(const PlacedCluster& placed) : placed_(placed) {
        for (unsigned v = 0; v < placed.cluster->vertex_count; ++v)
            at_[v] = demarcation(placed.curvatures[v]);
    }

    void add(unsigned triangle, ZeroPieces& pieces) const {
        const auto& t = placed_.triangle(triangle).corners;
        bool is_negative[3];
        for (int k = 0; k < 3; ++k) {
            const Demarcation &a = at_[t[k]], &b = at_[t[(k + 1) % 3]];
            if (!(dot(a.direction, b.direction) > kLeastAgreement))
                return;  // also where there is none
            is_negative[k] = a.curvature < 0;
        }
        if (is_negative[0] == is_negative[1] && is_negative[0] == is_negative[2]) return;
        pieces.push_back(zero_piece(placed_, triangle, is_negative, [&](unsigned a, unsigned b) {
            return std::make_pair(end(at_[a]), end(at_[b]));
        }));
    }

private:
    static ZeroEnd end(const Demarcation& at) { return {at.curvature, at.bend, at.strength}; }

    const PlacedCluster& placed_;
    Demarcation at_[kClusterVertices];
};

ZeroLines find_demarcating_curves(const ExtractorData& data) {
    ZeroLines found =
        find_zero_lines<ClusterCurves>(data, LineKind::DemarcatingCurve, kLeastLength);
    for (std::size_t i = 0; i < found.samples.size(); ++i)
        found.lines.points[i].gradient = found.samples[i].value * float(data.squared_scale);
    return found;
}

class DemarcatingCurves : public FixedKindLines {
public:
    DemarcatingCurves(const ExtractorData& data, FixedLines&)
        : found_(find_demarcating_curves(data)) {}

    void append(const ExtractorData& data, FixedLines&, const LocalEye& eye, const LineStyle& style,
                LineSet& lines) const override {
        const Thresholds thresholds(style);
        const float clearance = style.shows[LineKind::Contour] ? float(style.contour_clearance) : 0;
        found_.append(data, eye,
                      {thresholds.demarcation, kFading * float(style.fading),
                       std::max(kLeastLength, kShortestLines * thresholds.shortest_line),
                       kLeastLength, clearance, smoothing_passes(style.line_smoothing)},
                      nullptr, lines);
    }

private:
    const StrongLines found_;
};

}  // namespace

const FixedKind kDemarcatingCurves = fixed_kind<DemarcatingCurves>(LineKind::DemarcatingCurve);

}  // namespace laplacian_lines
