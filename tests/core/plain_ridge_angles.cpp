// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_ridge_angles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace reference {

using namespace laplacian_lines;

namespace {

constexpr double kDegrees = 180 / 3.14159265358979;

// In D.
constexpr double kReach = 0.04, kMiddleReach = 0.01;       // of a section, of its middle
constexpr double kStep = 0.003;                            // between sections
constexpr double kMeanReach = 0.0075, kBendReach = 0.005;  // along the line

/// The numbers around i whose ways differ from that of i by no more than the reach.
std::pair<std::size_t, std::size_t> around(const std::vector<double>& ways, std::size_t i,
                                           double reach) {
    std::size_t first = i, last = i;
    while (first > 0 && ways[i] - ways[first - 1] <= reach)
        --first;
    while (last + 1 < ways.size() && ways[last + 1] - ways[i] <= reach)
        ++last;
    return {first, last};
}

/// Of a turn by so much to either side within a distance and within twice that.
double edge_angle(const Eigen::Vector2d& near, const Eigen::Vector2d& far) {
    const Eigen::Vector2d a = 2 * near - far;
    const double clear = a.sum() - 1.5 * std::abs(a[0] - a[1]), all = near.sum();
    if (!(all > 0) || clear <= 0) return 0;
    return clear >= 0.3 * all ? all : clear / 0.3;
}

}  // namespace

PlainRidgeAngles::PlainRidgeAngles(const TriangleMesh& mesh, const Field& field, LineKind kind)
    : mesh_(mesh), field_(field), sign_(kind == LineKind::Valley ? -1 : 1) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            triangles_[std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3])].push_back(
                t);
}

PlainRidgeAngles::Place PlainRidgeAngles::Section::at(double distance) const {
    const std::vector<Place>& side = sides[distance < 0 ? 0 : 1];
    const double reach = std::abs(distance);
    Place place = side.back();
    for (std::size_t i = 1; i < side.size(); ++i) {
        const Place &a = side[i - 1], &b = side[i];
        if (b.distance < reach) continue;
        const double t =
            b.distance > a.distance ? (reach - a.distance) / (b.distance - a.distance) : 0;
        place = {reach, (1 - t) * a.angle + t * b.angle, (1 - t) * a.position + t * b.position};
        break;
    }
    if (distance < 0) place.angle = -place.angle;
    return place;
}

double PlainRidgeAngles::Section::middle() const {
    const double half = (at(kMiddleReach).angle + at(-kMiddleReach).angle) / 2;
    double low = -kMiddleReach, high = kMiddleReach;
    for (int step = 0; step < 20; ++step)
        (at((low + high) / 2).angle < half ? low : high) = (low + high) / 2;
    return (low + high) / 2;
}

std::vector<PlainRidgeAngles::Place> PlainRidgeAngles::walk(const RidgePoint& from,
                                                            const Eigen::Vector3d& forward,
                                                            const Eigen::Vector3d& origin,
                                                            const Eigen::Vector3d& across_plane,
                                                            std::size_t triangle) const {
    const auto height = [&](std::uint32_t v) {
        return across_plane.dot(mesh_.positions[v] - origin);
    };
    std::vector<Place> places = {{0, 0, from.position}};
    for (Edge entered = from.edge; places.back().distance < kReach;) {
        Edge left = entered;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh_.triangles[triangle][k],
                                b = mesh_.triangles[triangle][(k + 1) % 3];
            if (Edge(std::minmax(a, b)) != entered && (height(a) < 0) != (height(b) < 0))
                left = std::minmax(a, b);
        }
        if (left == entered) break;
        const auto [a, b] = left;
        const double t = height(a) / (height(a) - height(b));
        const Eigen::Vector3d p = (1 - t) * mesh_.positions[a] + t * mesh_.positions[b];
        const Eigen::Vector3d n =
            (1 - t) * field_.normals[a].cast<double>() + t * field_.normals[b].cast<double>();
        places.push_back(
            {places.back().distance + (p - places.back().position).norm() / field_.scale.diagonal,
             sign_ * kDegrees * std::atan2(n.dot(forward), n.dot(from.normal.normalized())), p});
        const std::vector<std::size_t>& here = triangles_.at(left);
        if (here.size() != 2) break;
        triangle = here[0] == triangle ? here[1] : here[0];
        entered = left;
    }
    return places;
}

PlainRidgeAngles::Section PlainRidgeAngles::section(const std::vector<RidgePoint>& line,
                                                    const std::vector<double>& ways,
                                                    std::size_t i) const {
    const RidgePoint& here = line[i];
    const auto [first, last] = around(ways, i, kBendReach);
    Eigen::Vector3d bend = Eigen::Vector3d::Zero();
    for (std::size_t j = first; j <= last; ++j)
        bend += line[j].bend.dot(here.bend) < 0 ? -line[j].bend : line[j].bend;
    const Eigen::Vector3d normal = here.normal.normalized();
    Eigen::Vector3d left = (bend - normal.dot(bend) * normal).normalized();
    const Eigen::Vector3d along = line[std::min(last + 1, line.size() - 1)].position -
                                  line[first > 0 ? first - 1 : 0].position;
    if (left.dot(normal.cross(along)) < 0) left = -left;

    // The plane clearly crosses the edge: not at its ends, nor along it.
    const Eigen::Vector3d &p = mesh_.positions[here.edge.first],
                          edge = mesh_.positions[here.edge.second] - p;
    const double t = (here.position - p).dot(edge) / edge.squaredNorm();
    const Eigen::Vector3d origin = here.position + (std::clamp(t, 0.02, 0.98) - t) * edge;
    Eigen::Vector3d across_plane = normal.cross(left).normalized();
    const double crossing = across_plane.dot(edge.normalized());
    if (std::abs(crossing) < 0.02)
        across_plane += (crossing < 0 ? -0.02 : 0.02) * edge.normalized();

    Section section;
    const std::vector<std::size_t>& triangles = triangles_.at(here.edge);
    double ahead[2] = {0, 0};
    for (std::size_t k = 0; k < triangles.size() && k < 2; ++k) {
        const auto places = walk(here, left, origin, across_plane, triangles[k]);
        if (places.size() > 1) ahead[k] = (places[1].position - here.position).dot(left);
    }
    for (std::size_t k = 0; k < 2; ++k) {
        const bool is_left = (k == 0) == (ahead[0] > ahead[1]);
        section.sides[is_left] = {{0, 0, here.position}};
        if (k < triangles.size())
            section.sides[is_left] = walk(here, is_left ? left : Eigen::Vector3d(-left), origin,
                                          across_plane, triangles[k]);
    }
    return section;
}

std::vector<RidgeAngle> PlainRidgeAngles::measure(const std::vector<RidgePoint>& line) const {
    std::vector<double> ways = {0};
    for (std::size_t i = 1; i < line.size(); ++i)
        ways.push_back(ways.back() +
                       (line[i].position - line[i - 1].position).norm() / field_.scale.diagonal);
    std::vector<std::size_t> samples = {0};
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
        if (ways[i] - ways[samples.back()] >= kStep) samples.push_back(i);
    samples.push_back(line.size() - 1);

    std::vector<Section> sections;
    std::vector<double> places;
    for (const std::size_t i : samples) {
        sections.push_back(section(line, ways, i));
        places.push_back(ways[i]);
    }
    std::vector<RidgeAngle> at_samples;  // with the way that a point moves for its position
    for (std::size_t s = 0; s < samples.size(); ++s) {
        const auto [first, last] = around(places, s, kMeanReach);
        Eigen::Vector2d turn[3] = {{0, 0}, {0, 0}, {0, 0}};  // within 1, 2 and 4 % of D
        double middle = 0;
        for (std::size_t other = first; other <= last; ++other) {
            const Section& section = sections[other];
            const double share = 1 / double(last - first + 1);
            for (int k = 0; k < 3; ++k) {
                const double distance = 0.01 * (1 << k);
                turn[k] += share * Eigen::Vector2d(-section.at(-distance).angle,
                                                   section.at(distance).angle);
            }
            middle += share * section.middle();
        }
        at_samples.push_back(
            {std::max(edge_angle(turn[1], turn[2]), edge_angle(turn[0], turn[1]) / 4),
             sections[s].at(middle).position - line[samples[s]].position});
    }

    std::vector<RidgeAngle> angles;
    for (std::size_t i = 0, s = 0; i < line.size(); ++i) {
        while (s + 2 < samples.size() && samples[s + 1] < i)
            ++s;
        const RidgeAngle &a = at_samples[s], &b = at_samples[s + 1];
        const double step = places[s + 1] - places[s];
        const double t = step > 0 ? (ways[i] - places[s]) / step : 0;
        angles.push_back({(1 - t) * a.angle + t * b.angle,
                          line[i].position + (1 - t) * a.position + t * b.position});
    }
    return angles;
}

}  // namespace reference
