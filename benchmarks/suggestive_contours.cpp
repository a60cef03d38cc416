// SPDX-License-Identifier: GPL-3.0-or-later
#include "suggestive_contours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace benchmarks {

using namespace laplacian_lines;
using Eigen::Vector3f;

namespace {

constexpr float kLeastDerivative = 0.1f;  // of the surface's usual squared curvature

float threshold_of(const std::vector<VertexCurvature>& curvatures) {
    std::vector<float> squared;
    for (const VertexCurvature& c : curvatures) {
        const auto& [k1, k2] = c.curvatures;
        squared.push_back((k1 * k1 + k2 * k2) / 2);
    }
    const auto middle = squared.begin() + std::ptrdiff_t(squared.size() / 2);
    std::nth_element(squared.begin(), middle, squared.end());
    return kLeastDerivative * *middle;
}

}  // namespace

SuggestiveContours::SuggestiveContours(const PlainMesh& mesh, const std::vector<Vector3f>& normals)
    : mesh_(mesh),
      normals_(normals),
      curvatures_(vertex_curvatures(mesh, normals)),
      threshold_(threshold_of(curvatures_)),
      seen_(normals.size()) {}

SuggestiveContours::Seen SuggestiveContours::look(const Vector3f& to_eye, const Vector3f& normal,
                                                  const VertexCurvature& curvature,
                                                  float threshold) {
    const auto& [k1, k2] = curvature.curvatures;
    const auto& c = curvature.derivative;
    const float facing = normal.dot(to_eye);
    float x = to_eye.dot(curvature.directions[0]), y = to_eye.dot(curvature.directions[1]);
    const float inverse = 1 / std::sqrt(x * x + y * y + std::numeric_limits<float>::min());
    x *= inverse;
    y *= inverse;
    // D_w κ_r = C(w, w, w) + 2 K cot θ, w of unit length, θ between n and l
    const float derivative = x * x * (c[0] * x + 3 * c[1] * y) + y * y * (3 * c[2] * x + c[3] * y) +
                             2 * k1 * k2 * facing * inverse;
    return {facing, k1 * x * x + k2 * y * y, derivative - threshold};
}

void SuggestiveContours::extract(const View& view, std::vector<Vector3f>& segments) {
    segments.clear();
    const Vector3f eye = view.eye.cast<float>();
    const float w = float(view.w);
    for (std::size_t v = 0; v < seen_.size(); ++v)
        seen_[v] = look(eye - w * mesh_.positions[v], normals_[v], curvatures_[v], threshold_);
    for (const Triangle& t : mesh_.triangles)
        add_segment(t, segments);
}

void SuggestiveContours::add_segment(const Triangle& t, std::vector<Vector3f>& segments) const {
    const bool negative[3] = {seen_[t[0]].curvature < 0, seen_[t[1]].curvature < 0,
                              seen_[t[2]].curvature < 0};
    if (negative[0] == negative[1] && negative[1] == negative[2]) return;
    for (std::uint32_t v : t)
        if (seen_[v].facing <= 0) return;
    Vector3f points[2];
    float above[2];
    int found = 0;
    for (int k = 0; k < 3; ++k) {
        if (negative[k] == negative[(k + 1) % 3]) continue;
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        const float s = seen_[a].curvature / (seen_[a].curvature - seen_[b].curvature);
        points[found] = (1 - s) * mesh_.positions[a] + s * mesh_.positions[b];
        above[found++] = (1 - s) * seen_[a].above_threshold + s * seen_[b].above_threshold;
    }
    if (above[0] > above[1]) {
        std::swap(above[0], above[1]);
        std::swap(points[0], points[1]);
    }
    if (!(above[1] > 0)) return;
    if (above[0] < 0) points[0] += above[0] / (above[0] - above[1]) * (points[1] - points[0]);
    segments.push_back(points[0]);
    segments.push_back(points[1]);
}

}  // namespace benchmarks
