// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/ring_derivatives.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace laplacian_lines {
namespace {

/// Between a triangle's normal and its corners': beyond, S is of another side.
constexpr double kLeastCosine = 0.1;

/// In the plane of a triangle with unit normal n.
struct PlaneFrame {
    Eigen::Vector3d n, t, b;  // orthonormal

    /// Turned from n to m the shortest way.
    PlaneFrame turned_to(const Eigen::Vector3d& m) const {
        const Eigen::Vector3d middle = (n + m) / (1 + n.dot(m));
        return {m, t - t.dot(m) * middle, b - b.dot(m) * middle};
    }
};

class TriangleDerivative {
public:
    /// False if the triangle does not count.
    bool fit(const Eigen::Vector3d* const p[3], const CurvedVertex corners[3]) {
        const Eigen::Vector3d edges[3] = {*p[2] - *p[1], *p[0] - *p[2], *p[1] - *p[0]};
        const Eigen::Vector3d area = edges[2].cross(-edges[1]);
        weight_ = area.norm();
        const double longest = edges[0].norm();
        if (!(weight_ > 0 && longest > 0)) return false;
        PlaneFrame plane;
        plane.n = area / weight_;
        plane.t = edges[0] / longest;
        plane.b = plane.n.cross(plane.t);
        // Derivatives along t and b of S(t, t), S(t, b), S(b, b), times the weight.
        double by_t[3] = {}, by_b[3] = {};
        for (int k = 0; k < 3; ++k) {
            const CurvedVertex& corner = corners[k];
            if (!(plane.n.dot(corner.normal) > kLeastCosine)) return false;
            const PlaneFrame turned = plane.turned_to(corner.normal);
            const Eigen::Vector3d st = corner.shape_operator * turned.t,
                                  sb = corner.shape_operator * turned.b;
            const double entries[3] = {turned.t.dot(st), turned.b.dot(st), turned.b.dot(sb)};
            for (int i = 0; i < 3; ++i) {
                by_t[i] -= edges[k].dot(plane.b) * entries[i];
                by_b[i] += edges[k].dot(plane.t) * entries[i];
            }
            first_directions_[k] = {turned.t.dot(corner.u), turned.t.dot(corner.v)};
        }
        form_ = CubicForm::of(by_t[0], (by_b[0] + 2 * by_t[1]) / 3, (by_t[2] + 2 * by_b[1]) / 3,
                              by_b[2]);
        return true;
    }

    double weight() const { return weight_; }  ///< twice the area
    /// Times the weight, in the frame of a corner.
    CubicForm at(int corner) const { return form_.turned(first_directions_[corner]); }

private:
    double weight_ = 0;
    CubicForm form_;
    std::complex<double> first_directions_[3];
};

}  // namespace

void set_ring_derivatives(const PreparedMesh& mesh, const VertexRanges& ranges, const Field& field,
                          const std::vector<std::uint8_t>& wanted, std::vector<CubicForm>& forms) {
    const Progress none;
    ranges.for_each({none, 0, 1, ""}, [&](const VertexRanges::Range& range) {
        const auto is_wanted = [&](std::uint32_t v) { return range.holds(v) && wanted[v]; };
        const std::uint8_t* const end = wanted.data() + range.end();
        if (std::find(wanted.data() + range.begin(), end, 1) == end) return;
        std::vector<CubicForm> sums(range.end() - range.begin());
        std::vector<double> weights(sums.size());
        TriangleDerivative derivative;
        range.for_each_triangle([&](const Triangle& t) {
            if (std::none_of(t.begin(), t.end(), is_wanted)) return;
            const Eigen::Vector3d* const p[3] = {&mesh.positions[t[0]], &mesh.positions[t[1]],
                                                 &mesh.positions[t[2]]};
            const CurvedVertex corners[3] = {curved_vertex(mesh, field, t[0]),
                                             curved_vertex(mesh, field, t[1]),
                                             curved_vertex(mesh, field, t[2])};
            if (!derivative.fit(p, corners)) return;
            for (int k = 0; k < 3; ++k) {
                if (!is_wanted(t[k])) continue;
                sums[t[k] - range.begin()].add(derivative.at(k), 1);
                weights[t[k] - range.begin()] += derivative.weight();
            }
        });
        for (std::uint32_t v = range.begin(); v < range.end(); ++v) {
            if (!wanted[v]) continue;
            const double weight = weights[v - range.begin()];
            forms[v] = sums[v - range.begin()];
            if (weight > 0) forms[v].scale(1 / weight);
        }
    });
}

}  // namespace laplacian_lines
