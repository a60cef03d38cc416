// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/plain_places.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr double kFlat = 0.9999984769132877;   // least cosine: of 0.1°
constexpr double kSharp = 0.7660444431189781;  // most cosine: of 40°
constexpr double kLong = 0.02;                 // D

/// To the larger one, whichever thread comes first.
template <class T>
void raise(std::atomic<T>& place, T value) {
    T old = place.load(std::memory_order_relaxed);
    while (old < value && !place.compare_exchange_weak(old, value, std::memory_order_relaxed)) {
    }
}

/// Whichever side each of them is seen from.
Around compare(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double cosine = std::abs(a.dot(b));
    return cosine >= kFlat ? Around::Flat : cosine <= kSharp ? Around::Sharp : Around::Round;
}

/// The first triangle of each vertex.
std::vector<std::uint32_t> first_triangles(const PreparedMesh& mesh) {
    std::vector<std::uint32_t> first = large_array<std::uint32_t>(mesh.size());
    for (std::size_t t = mesh.triangles.size(); t-- > 0;)
        for (const std::uint32_t v : mesh.triangles[t])
            first[v] = std::uint32_t(t);
    return first;
}

double longest_squared(const PreparedMesh& mesh, const Triangle& t) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest,
                           (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).squaredNorm());
    return longest;
}

std::vector<Around> look_around(const PreparedMesh& mesh) {
    const std::vector<std::uint32_t> first = first_triangles(mesh);
    std::vector<Eigen::Vector3d> normals = large_array<Eigen::Vector3d>(mesh.triangles.size());
    for_each_element(normals.size(), [&](std::size_t t) {
        normals[t] = area_vector(mesh, mesh.triangles[t]).stableNormalized();
    });
    std::vector<std::atomic<Around>> around(mesh.size());
    for_each_element(normals.size(), [&](std::size_t t) {
        for (const std::uint32_t v : mesh.triangles[t])
            raise(around[v], compare(normals[t], normals[first[v]]));
    });
    std::vector<Around> result(mesh.size());
    std::transform(around.begin(), around.end(), result.begin(),
                   [](const std::atomic<Around>& a) { return a.load(std::memory_order_relaxed); });
    return result;
}

}  // namespace

PlainPlaces::PlainPlaces(const PreparedMesh& mesh)
    : mesh_(mesh),
      around_(look_around(mesh)),
      has_edges_(std::find(around_.begin(), around_.end(), Around::Sharp) != around_.end()) {}

bool PlainPlaces::contain(std::uint32_t triangle) const {
    if (!has_edges_) return false;
    const Triangle& t = mesh_.triangles[triangle];
    const auto count = [&](Around wanted) {
        return std::count_if(t.begin(), t.end(),
                             [&](std::uint32_t v) { return around_[v] == wanted; });
    };
    if (count(Around::Flat) == 3) return true;
    return count(Around::Round) == 0 && longest_squared(mesh_, t) > kLong * kLong;
}

}  // namespace laplacian_lines
