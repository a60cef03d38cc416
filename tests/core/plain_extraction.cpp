// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_extraction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "clusters/cluster_partition.h"
#include "clusters/coarseness.h"
#include "mesh/prepared_mesh.h"
#include "plain_kinds.h"
#include "redraw/kinds/strip_kinds.h"
#include "rules/convexity.h"

namespace reference {

using namespace laplacian_lines;

namespace {

float dot(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// A homogeneous point in local coordinates.
struct Eye {
    Eigen::Vector3f e;
    float w;
    Eigen::Vector3f towards(const Eigen::Vector3f& p) const { return e - w * p; }
};

Eye local_eye(const View& view, const PreparedMesh& mesh) {
    if (view.w == 0) return {view.eye.normalized().cast<float>(), 0};
    const Eigen::Vector3d eye = (view.eye / view.w - mesh.centre) / mesh.diagonal;
    const double scale = 1 / std::max(eye.norm(), 0.01);
    return {(eye * scale).cast<float>(), float(scale)};
}

struct Vertex {
    Eigen::Vector3f position;
    ShapeOperator shape_operator;
    float slope_scale;
    Eigen::Vector3f normal;
    float laplacian, illumination;  // ΔI, n·l
    float radial, photic;           // v·S v, Hess I(∇I, ∇I)
    ApparentCurvature apparent;
    double least_cosine = 1;  // between triangles around it
};

ShapeOperator interpolate(float t, const ShapeOperator& a, const ShapeOperator& b) {
    const auto between = [&](float ShapeOperator::*entry) {
        return (1 - t) * a.*entry + t * b.*entry;
    };
    using S = ShapeOperator;
    return {between(&S::xx), between(&S::yy), between(&S::zz),
            between(&S::yz), between(&S::xz), between(&S::xy)};
}

/// v·(e − w p), from v and v·p.
float linear_form(const Eigen::Vector3d& v, const Eigen::Vector3d& p, const Eye& eye) {
    return dot(v.cast<float>(), eye.e) - eye.w * float(v.dot(p));
}

struct Crossing {
    Eigen::Vector3f position, gradient;
    float gradient_norm, opacity;
    float concave = 0;  // ‖∇I‖ times the cosine between −∇I and the tangential part of l
    bool accepted;
};

struct Segment {
    std::pair<std::uint32_t, std::uint32_t> edges[2];  // sorted vertices; begin and end
    float slope;
    std::uint32_t cluster = 0;  // and whether it is coarse
    std::uint32_t place = 0;    // of its triangle, in the order of clusters
    bool accepted = true;
};

constexpr double kSharp = 0.7660444431189781;  // cos 40°

class PlainExtraction {
public:
    PlainExtraction(const TriangleMesh& mesh, const Field& field, const View& view)
        : mesh_(prepare_mesh(mesh, field.report.welded_vertices > 0 ? Cuts::Stitched : Cuts::Left,
                             {field.report.undone_subdivisions})),
          eye_(local_eye(view, mesh_)),
          light_(view.light ? Eye{view.light->normalized().cast<float>(), 0} : eye_) {
        for (std::uint32_t v = 0; v < mesh_.size(); ++v)
            vertices_.push_back(make_vertex(field, v));
        find_around();
        find_clusters(field);
        for (const Triangle& t : mesh_.triangles)
            for (int k = 0; k < 3; ++k)
                ++triangles_of_edge_[std::minmax(t[k], t[(k + 1) % 3])];
    }

    /// Has long borders, so it is seen from both sides.
    bool is_sheet() const {
        double borders = 0, area = 0;
        for (const Triangle& t : mesh_.triangles) {
            area += area_vector(mesh_, t).norm() / 2;
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                if (triangles_of_edge_.at(std::minmax(a, b)) != 2)
                    borders += (mesh_.positions[a] - mesh_.positions[b]).norm();
            }
        }
        return borders > 2 * std::sqrt(area);
    }

    void extract(const LineRules& rules, float Vertex::*function, std::vector<PlainLine>& lines) {
        function_ = function;
        crossings_.clear();
        segments_.clear();
        for (triangle_ = 0; triangle_ < mesh_.triangles.size(); ++triangle_) {
            const Triangle& t = mesh_.triangles[triangle_];
            for (int k = 0; k < 3; ++k)  // from the corner where the line leaves to the left
                if (value(t[k]) < 0 && !(value(t[(k + 1) % 3]) < 0))
                    add_segment(rules, t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
        }
        trace_all(rules, lines);
    }

    void extract_apparent(const LineRules& rules, std::vector<PlainLine>& lines) {
        crossings_.clear();
        segments_.clear();
        for (triangle_ = 0; triangle_ < mesh_.triangles.size(); ++triangle_)
            add_apparent_segment(rules, mesh_.triangles[triangle_]);
        direct_segments();
        segments_.erase(std::remove_if(segments_.begin(), segments_.end(),
                                       [](const Segment& s) { return !s.accepted; }),
                        segments_.end());
        trace_all(rules, lines);
    }

private:
    Vertex make_vertex(const Field& field, std::uint32_t prepared) const {
        const std::uint32_t v = mesh_.original_vertex[prepared];
        const double d = mesh_.diagonal;
        const ShapeOperator& s = field.shape_operators[v];
        const auto curvature = [&](float x) { return float(double(x) * d); };
        const Eigen::Vector3d& p = mesh_.positions[prepared];
        const double size = field.kernel_sizes[v] / d;
        const double sigma = field.scale.normal_sigma / d *
                             (size / (field.scale.kernel_size / field.scale.diagonal));
        Vertex vertex;
        vertex.position = p.cast<float>();
        vertex.shape_operator = {curvature(s.xx), curvature(s.yy), curvature(s.zz),
                                 curvature(s.yz), curvature(s.xz), curvature(s.xy)};
        vertex.slope_scale = float(std::pow(size * size + sigma * sigma / 2, 1.5));
        vertex.normal = field.normals[v];
        vertex.illumination = linear_form(vertex.normal.cast<double>(), p, eye_);
        vertex.laplacian =
            linear_form(field.laplacian_normals[v].cast<double>() * d * d, p, light_);
        if (!field.has_derivatives()) return vertex;
        const KindVertex at{vertex.position, vertex.normal,
                            (field.smooth_curvatures[v].cast<double>() * d).cast<float>(),
                            (field.curvature_derivatives[v].cast<double>() * d * d).cast<float>()};
        vertex.radial = radial(at, eye_.e, eye_.w);
        vertex.photic = photic(at, light_.e, light_.w);
        vertex.apparent = apparent_curvature(at, eye_.e, eye_.w);
        return vertex;
    }

    /// Each triangle's cluster and whether it is coarse; which vertices are convex all around.
    void find_clusters(const Field& field) {
        const std::vector<std::uint8_t> coarse = find_coarse_triangles(mesh_, field);
        const Partition clusters = partition(mesh_, coarse);
        clusters_.resize(mesh_.triangles.size());
        places_.resize(mesh_.triangles.size());
        for (std::uint32_t c = 0; c < clusters.ranges.size(); ++c)
            for (std::uint32_t p = clusters.ranges[c].begin; p < clusters.ranges[c].end; ++p) {
                clusters_[clusters.order[p]] = 2 * c + (coarse[clusters.order[p]] != 0);
                places_[clusters.order[p]] = p;
            }
        convex_around_.assign(mesh_.size(), true);
        for (const Triangle& t : mesh_.triangles)
            for (const std::uint32_t v : t)
                for (const std::uint32_t neighbour : t)
                    convex_around_[v] =
                        convex_around_[v] && is_convex(vertices_[neighbour].shape_operator);
    }

    /// The least cosine between the first triangle at a vertex and the others.
    void find_around() {
        std::vector<Eigen::Vector3d> first(mesh_.size(), Eigen::Vector3d::Zero());
        for (const Triangle& t : mesh_.triangles) {
            const Eigen::Vector3d normal = (mesh_.positions[t[1]] - mesh_.positions[t[0]])
                                               .cross(mesh_.positions[t[2]] - mesh_.positions[t[0]])
                                               .normalized();
            for (const std::uint32_t v : t) {
                if (first[v].isZero(0)) first[v] = normal;
                vertices_[v].least_cosine =
                    std::min(vertices_[v].least_cosine, std::abs(normal.dot(first[v])));
            }
        }
        for (const Vertex& v : vertices_)
            has_edges_ = has_edges_ || v.least_cosine <= kSharp;
    }

    bool is_plain(const Vertex& a, const Vertex& b, const Vertex& c) const {
        const double flat = std::cos(0.1 / 57.29577951308232);
        bool all_flat = true, all_plain = true;
        for (const Vertex* v : {&a, &b, &c}) {
            all_flat = all_flat && v->least_cosine >= flat;
            all_plain = all_plain && (v->least_cosine >= flat || v->least_cosine <= kSharp);
        }
        const float longest =
            std::max({(a.position - b.position).norm(), (b.position - c.position).norm(),
                      (c.position - a.position).norm()});
        return has_edges_ && (all_flat || (all_plain && longest > 0.02f));
    }

    float value(std::uint32_t v) const { return vertices_[v].*function_; }

    /// Between a vertex with a negative value and another.
    Crossing compute_crossing(const LineRules& rules, std::uint32_t below,
                              std::uint32_t above) const {
        const Vertex &a = vertices_[below], &b = vertices_[above];
        const float fa = std::abs(value(below)), sum = fa + std::abs(value(above));
        const float t = std::isfinite(sum) ? fa / sum : 0.5f;
        Crossing c;
        c.position = (1 - t) * a.position + t * b.position;
        const Eigen::Vector3f towards_eye = eye_.towards(c.position);
        const bool contour = rules.kind == LineKind::Contour;
        const bool of_eye = contour || is_suggestive(rules.kind);
        const Eigen::Vector3f l = of_eye ? towards_eye : light_.towards(c.position);
        const Eigen::Vector3f normal = (1 - t) * a.normal + t * b.normal;
        c.gradient = interpolate(t, a.shape_operator, b.shape_operator) * l;
        c.gradient_norm = std::sqrt(dot(c.gradient, c.gradient));
        c.opacity = 1;
        c.accepted = true;
        if (contour) {
            const float distance = std::sqrt(dot(l, l));
            const float gradient = c.gradient_norm + LineRules::kFlat * distance;
            const float concavity = -dot(l, c.gradient) / (distance * gradient);
            if (concavity > 0) c.opacity = 1 - std::min(concavity / rules.concave_thinning, 1.f);
            return c;
        }
        const float facing = dot(normal, towards_eye);
        if (is_suggestive(rules.kind)) {
            test_radial_zero(rules, facing, towards_eye, c);
            return c;
        }
        c.accepted = (rules.whole || c.gradient_norm >= rules.least_gradient) &&
                     facing >= rules.least_facing * std::sqrt(dot(towards_eye, towards_eye));
        if (rules.contour_clearance > 0) {
            const float distance = facing * std::abs(facing) / (2 * c.gradient_norm);
            c.opacity = facing > 0  // else 0 / 0 where the surface is flat
                            ? std::clamp(2 * distance / rules.contour_clearance - 1, 0.f, 1.f)
                            : 0;
        }
        const float lit = dot(normal, l);
        const float tangential = std::sqrt(std::max(dot(l, l) - lit * lit, 0.f));
        if (rules.whole && rules.concave_only) {
            const float concave = -dot(l, c.gradient) / tangential;
            c.concave = std::isnan(concave)
                            ? -c.gradient_norm
                            : std::clamp(concave, -c.gradient_norm, c.gradient_norm);
            c.accepted = c.accepted && c.concave >= rules.least_concavity * c.gradient_norm;
        } else if (rules.concave_only) {
            const float concavity = -dot(l, c.gradient) / (tangential * c.gradient_norm);
            const float begin = -rules.fading / 4, range = rules.fading / 2 - begin;
            c.accepted = c.accepted && concavity > begin;
            if (range > 0) c.opacity *= std::min((concavity - begin) / range, 1.f);
        }
        if (rules.kind == LineKind::PhoticExtremum)
            c.gradient /= c.gradient_norm * c.gradient_norm * c.gradient_norm;
        return c;
    }

    static bool is_suggestive(LineKind kind) {
        return kind == LineKind::SuggestiveContour || kind == LineKind::SuggestiveHighlight;
    }

    static float clearance(const LineRules& rules, float facing, float gradient) {
        if (!(rules.contour_clearance > 0)) return 1;
        const float distance = facing * std::abs(facing) / (2 * gradient);
        return std::isnan(distance)
                   ? 0
                   : std::clamp(2 * distance / rules.contour_clearance - 1, 0.f, 1.f);
    }

    /// With ∇f·(−gradient) the derivative of the radial curvature over the cosine.
    static void test_radial_zero(const LineRules& rules, float facing, const Eigen::Vector3f& v,
                                 Crossing& c) {
        const float distance = std::sqrt(dot(v, v)), cosine = facing / distance;
        c.accepted = cosine >= rules.least_facing;
        c.opacity = clearance(rules, facing, c.gradient_norm);
        const float factor = 1 / (dot(v, v) * distance * std::max(1 - cosine * cosine, 0.03f) *
                                  std::max(cosine, 0.1f));
        c.gradient = (rules.kind == LineKind::SuggestiveContour ? -factor : factor) * v;
    }

    const Crossing& crossing(const LineRules& rules, std::uint32_t below, std::uint32_t above) {
        const auto [found, is_new] = crossings_.try_emplace(std::minmax(below, above));
        if (is_new) found->second = compute_crossing(rules, below, above);
        return found->second;
    }

    /// By corners: a negative one, a positive one next in orientation, and the third.
    void add_segment(const LineRules& rules, std::uint32_t below, std::uint32_t above,
                     std::uint32_t third) {
        const bool third_is_negative = value(third) < 0;
        const std::uint32_t entry_below = third_is_negative ? third : below;
        const std::uint32_t entry_above = third_is_negative ? above : third;
        const Crossing& end = crossing(rules, below, above);
        const Crossing& begin = crossing(rules, entry_below, entry_above);
        if (!begin.accepted || !end.accepted) return;
        float slope = 0;
        if (rules.use_slope) {
            const Vertex &a = vertices_[below], &b = vertices_[above], &c = vertices_[third];
            const Eigen::Vector3f u = b.position - a.position, v = c.position - a.position;
            const Eigen::Vector3f n = u.cross(v);
            const float fu = value(above) - value(below), fv = value(third) - value(below);
            const Eigen::Vector3f steepest = fu * v.cross(n) + fv * n.cross(u);
            const auto convex = [&](std::uint32_t v) {
                return rules.cut_by_convex() ? is_convex(vertices_[v].shape_operator)
                                             : convex_around_[v];
            };
            if (rules.leave_out_convex && convex(below) && convex(above) && convex(third)) return;
            if (rules.leave_out_plain && is_plain(a, b, c)) return;
            if (rules.leave_out_away && a.illumination < 0 && b.illumination < 0 &&
                c.illumination < 0)
                return;
            const float scale = (a.slope_scale + b.slope_scale + c.slope_scale) / 3;
            const float product = dot(steepest, begin.gradient + end.gradient);
            if (rules.kind == LineKind::Laplacian) {
                slope = std::sqrt(dot(steepest, steepest)) / dot(n, n) * scale;
                if (rules.whole) {
                    slope = slope >= 0 ? (product <= 0 ? slope : -slope) : 0;
                } else if (!(slope >= rules.segment_slope)) {
                    return;
                } else if (rules.reject_phantoms && !(product <= 0)) {
                    return;
                }
            } else {
                const float change = -product / (2 * dot(n, n));
                const float size = std::abs(change);
                slope = is_suggestive(rules.kind) ? change * std::sqrt(size) : change;
                if (!accept_change(rules, change, slope *= scale)) return;
            }
        }
        segments_.push_back({{std::minmax(entry_below, entry_above), std::minmax(below, above)},
                             slope,
                             clusters_[triangle_]});
    }

    /// Steeper ones are no wider.
    static bool accept_change(const LineRules& rules, float change, float& slope) {
        if (rules.whole && std::isnan(change)) slope = 0;
        const bool accepted = rules.whole || (change > 0 && slope >= rules.segment_slope);
        const float most = rules.segment_slope + rules.full_slope;
        slope = std::clamp(slope, -most, most);
        return accepted;
    }

    Crossing apparent_crossing(const LineRules& rules, const Vertex& a, const Vertex& b) const {
        const float fa = std::abs(a.apparent.derivative);
        const float t = fa / (fa + std::abs(b.apparent.derivative));
        Crossing c;
        c.position = (1 - t) * a.position + t * b.position;
        const Eigen::Vector3f v = eye_.towards(c.position);
        const float facing = dot((1 - t) * a.normal + t * b.normal, v);
        const Eigen::Vector3f gradient = interpolate(t, a.shape_operator, b.shape_operator) * v;
        c.gradient_norm = (1 - t) * a.apparent.q + t * b.apparent.q;
        c.opacity = clearance(rules, facing, std::sqrt(dot(gradient, gradient)));
        c.accepted = c.gradient_norm >= least_curvature(rules) &&
                     facing >= rules.least_facing * std::sqrt(dot(v, v));
        return c;
    }

    /// The rest is asked of means along whole lines.
    static float least_curvature(const LineRules& rules) {
        return rules.whole ? rules.least_gradient / (1 + rules.fading) : rules.least_gradient;
    }

    void add_apparent_segment(const LineRules& rules, const Triangle& t) {
        const Vertex* const v[3] = {&vertices_[t[0]], &vertices_[t[1]], &vertices_[t[2]]};
        std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
        bool strong = false;
        for (int k = 0; k < 3; ++k) {
            const ApparentCurvature &a = v[k]->apparent, &b = v[(k + 1) % 3]->apparent;
            const float cosine = dot(a.direction, b.direction);
            if (a.q == 0 || !(cosine * cosine >= 0.49f)) return;
            strong = strong || a.q >= least_curvature(rules);
            if ((a.derivative < 0) != ((b.derivative < 0) != (cosine < 0)))
                edges.push_back(std::minmax(t[k], t[(k + 1) % 3]));
        }
        if (edges.size() != 2 || !strong) return;
        if (rules.leave_out_plain && is_plain(*v[0], *v[1], *v[2])) return;
        const Crossing* ends[2];
        for (int i = 0; i < 2; ++i) {
            const auto [found, is_new] = crossings_.try_emplace(edges[i]);
            if (is_new)
                found->second =
                    apparent_crossing(rules, vertices_[edges[i].first], vertices_[edges[i].second]);
            ends[i] = &found->second;
        }
        Eigen::Vector3f direction = Eigen::Vector3f::Zero();
        float values[3];
        for (int k = 0; k < 3; ++k) {
            const float sign = dot(v[0]->apparent.direction, v[k]->apparent.direction) < 0 ? -1 : 1;
            values[k] = sign * v[k]->apparent.derivative;
            direction += sign * v[k]->apparent.direction;
        }
        const Eigen::Vector3f u = v[1]->position - v[0]->position,
                              w = v[2]->position - v[0]->position;
        const Eigen::Vector3f n = u.cross(w);
        const Eigen::Vector3f steepest =
            (values[1] - values[0]) * w.cross(n) + (values[2] - values[0]) * n.cross(u);
        const float change = -dot(steepest, direction.normalized()) / dot(n, n);
        float slope = change * ((v[0]->slope_scale + v[1]->slope_scale + v[2]->slope_scale) / 3);
        const bool accepted =
            accept_change(rules, change, slope) && ends[0]->accepted && ends[1]->accepted;
        const std::pair<std::uint32_t, std::uint32_t> second = std::minmax(t[1], t[2]);
        if (edges[0] != second && edges[1] != second) std::swap(edges[0], edges[1]);  // cyclic
        segments_.push_back(
            {{edges[0], edges[1]}, slope, clusters_[triangle_], places_[triangle_], accepted});
    }

    /// Apparent ridges have no sides: within a cluster they go as its first triangle has them.
    void direct_segments() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> at_edge;
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            order.push_back(i);
            for (const auto& edge : segments_[i].edges)
                at_edge[edge].push_back(i);
        }
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return segments_[a].place < segments_[b].place;
        });
        std::vector<bool> directed(segments_.size(), false);
        for (const std::size_t first : order) {
            if (directed[first]) continue;
            directed[first] = true;
            for (const int side : {0, 1})
                for (std::size_t i = first, next = i;; i = next) {
                    for (const std::size_t other : at_edge[segments_[i].edges[side]])
                        if (!directed[other] && segments_[other].cluster == segments_[i].cluster)
                            next = other;
                    if (next == i) break;
                    directed[next] = true;
                    auto& edges = segments_[next].edges;
                    if (edges[1 - side] != segments_[i].edges[side]) std::swap(edges[0], edges[1]);
                }
        }
    }

    void trace_all(const LineRules& rules, std::vector<PlainLine>& lines) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> at_edge;
        for (std::size_t i = 0; i < segments_.size(); ++i)
            for (const auto& edge : segments_[i].edges)
                at_edge[edge].push_back(i);
        // The segment that continues segment i at one of its edges, or none.
        const auto next = [&](std::size_t i, const auto& edge) {
            const auto& here = at_edge[edge];
            if (here.size() != 2 || triangles_of_edge_[edge] != 2) return segments_.size();
            return here[0] == i ? here[1] : here[0];
        };
        std::vector<bool> visited(segments_.size(), false);
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            if (visited[i]) continue;
            // Back to the start, or once round, then along the line.
            std::size_t first = i;
            int side = 0;
            for (std::size_t j;
                 (j = next(first, segments_[first].edges[side])) < segments_.size();) {
                side = segments_[j].edges[0] == segments_[first].edges[side] ? 1 : 0;
                first = j;
                if (first == i) break;
            }
            trace(rules, first, side, next, visited, lines);
        }
    }

    template <class Next>
    void trace(const LineRules& rules, std::size_t first, int begin_side, const Next& next,
               std::vector<bool>& visited, std::vector<PlainLine>& lines) {
        PlainLine line{{}, {}, false};
        Polyline& p = line.polyline;
        PlainChain chain{{}, {}, false};
        const auto add_point = [&](const Crossing& c, float slope) {
            line.points.push_back({c.position, slope, c.gradient_norm, c.opacity});
        };
        add_point(crossings_.at(segments_[first].edges[begin_side]), 0);
        std::size_t i = first;
        for (int side = begin_side;;) {
            visited[i] = true;
            const Segment& s = segments_[i];
            const Crossing &from = crossings_.at(s.edges[side]),
                           &to = crossings_.at(s.edges[1 - side]);
            line.points.back().weight += s.slope;
            add_point(to, s.slope);
            const float length = (to.position - from.position).norm();
            p.length += length;
            p.strength += (from.gradient_norm + to.gradient_norm) / 2 * length;
            p.slope += s.slope * length;
            chain.segments.push_back(
                {{length, s.slope * length, (from.gradient_norm + to.gradient_norm) / 2 * length,
                  (from.concave + to.concave) / 2 * length},
                 s.cluster,
                 side == 0});
            const std::size_t j = next(i, s.edges[1 - side]);
            if (j >= segments_.size() || j == first) {
                p.closed = j == first;
                break;
            }
            side = segments_[j].edges[0] == s.edges[1 - side] ? 0 : 1;
            i = j;
        }
        if (rules.whole) {
            chain.points = std::move(line.points);
            chain.closed = p.closed;
            add_parts(rules, chain, mesh_.centre, mesh_.diagonal, lines);
            return;
        }
        p.kind = rules.kind;
        p.count = std::uint32_t(line.points.size());
        p.slope = p.length > 0 ? p.slope / p.length : 0;
        // Above or below, or too near to say.
        bool accepted = true;
        const auto compare = [&](float sum, float threshold) {
            const bool uncertain = std::abs(sum - threshold) <= 1e-4f * std::abs(threshold);
            line.uncertain = line.uncertain || uncertain;
            accepted = accepted && (uncertain || sum >= threshold);
        };
        compare(p.length, rules.least_length);
        compare(p.strength, rules.least_strength);
        if (rules.use_slope) compare(p.slope, rules.line_slope);
        if (!accepted) return;
        finish_plainly(rules, p, mesh_.centre, mesh_.diagonal, line.points.data());
        lines.push_back(line);
    }

    const PreparedMesh mesh_;
    const Eye eye_, light_;
    std::vector<Vertex> vertices_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> triangles_of_edge_;
    float Vertex::*function_ = nullptr;
    bool has_edges_ = false;
    std::vector<std::uint32_t> clusters_, places_;  // by triangle
    std::vector<bool> convex_around_;      // by vertex
    std::size_t triangle_ = 0;             // whose segment is added
    std::map<std::pair<std::uint32_t, std::uint32_t>, Crossing> crossings_;
    std::vector<Segment> segments_;
};

}  // namespace

std::vector<PlainLine> extract_plainly(const TriangleMesh& mesh, const Field& field,
                                       const View& view, const LineStyle& style) {
    PlainExtraction extraction(mesh, field, view);
    std::vector<PlainLine> lines;
    LineRules laplacian = laplacian_line_strips.rules(style, !view.light);
    const auto kernel_of = [&](LineRules rules) {
        rules.kernel_size = float(field.scale.kernel_size / field.scale.diagonal);
        return rules;
    };
    laplacian = kernel_of(laplacian);
    if (style.shows[LineKind::Laplacian]) extraction.extract(laplacian, &Vertex::laplacian, lines);
    LineRules contours = contour_rules(style);
    if (extraction.is_sheet()) contours.concave_thinning = LineRules::kNoThinning;
    if (style.shows[LineKind::Contour]) extraction.extract(contours, &Vertex::illumination, lines);
    const auto extract = [&](const StripKind& kind, float Vertex::*function) {
        if (style.shows[kind.kind])
            extraction.extract(kernel_of(kind.rules(style, !view.light)), function, lines);
    };
    if (!field.has_derivatives()) return lines;
    extract(suggestive_contour_strips, &Vertex::radial);
    extract(suggestive_highlight_strips, &Vertex::radial);
    extract(photic_extremum_strips, &Vertex::photic);
    if (style.shows[LineKind::ApparentRidge])
        extraction.extract_apparent(kernel_of(apparent_ridge_strips.rules(style, !view.light)),
                                    lines);
    return lines;
}

}  // namespace reference
