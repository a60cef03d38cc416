// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/field_steps.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "mesh/flat_faces.h"
#include "mesh/triangles_at.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr std::size_t kSamples = 1024;
constexpr std::size_t kLeastTriangles = 12;   // of two rings; fewer say little
constexpr std::size_t kMostTriangles = 4096;  // collected; beyond, a vertex is left out
// In D. Contours are smooth below, whatever their triangles; above, form is as rough as noise.
constexpr double kLeastEdge = 0.008, kLargestEdge = 0.04;
// Lower quartiles; no registered mesh without noise has both.
constexpr double kLeastTilt = 0.05;   // radians
constexpr double kLeastShare = 0.40;  // of tilt and bend together
// Upper quartile of the tilts over the lower: noise has 1.2 to 1.4, form 1.7 and more.
constexpr double kMostUneven = 1.5;

struct Facets {
    double tilt = 0;   ///< of the triangles from the quadric, root mean square; radians
    double share = 0;  ///< tilt over tilt and bend
};

/// Memory of FacetFit; keeps its capacity.
struct FacetMemory {
    std::vector<std::uint32_t> triangles;
    std::vector<Eigen::Vector3d> normals;  // times twice the area, to one side
};

/// Fits a linear function of the centres to the triangles' normals around a vertex, weighted by
/// area: noise turns small triangles more.
class FacetFit {
public:
    FacetFit(const PreparedMesh& mesh, const TrianglesAt& at, FacetMemory& memory)
        : mesh_(mesh), at_(at), m_(memory) {}

    /// False if there are too few triangles, or if they have no common side.
    bool measure(std::size_t v, Facets& facets) {
        if (!collect(v) || m_.triangles.size() < kLeastTriangles) return false;
        Eigen::Vector3d up = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& n : m_.normals)
            up += n;
        if (up.isZero(0)) return false;
        up.normalize();
        axes_.col(0) = up.unitOrthogonal();
        axes_.col(1) = up.cross(axes_.col(0));
        Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
        Eigen::Matrix<double, 3, 2> sums = Eigen::Matrix<double, 3, 2>::Zero();
        for (std::size_t i = 0; i < m_.triangles.size(); ++i) {
            const Row row = row_of(v, i, up);
            squares += row.weight * row.place * row.place.transpose();
            sums += row.weight * row.place * row.normal.transpose();
        }
        // For centres on one line, the smallest solution.
        const Eigen::Matrix<double, 3, 2> fit =
            squares.completeOrthogonalDecomposition().solve(sums);
        double weights = 0, tilts = 0, bends = 0;
        for (std::size_t i = 0; i < m_.triangles.size(); ++i) {
            const Row row = row_of(v, i, up);
            weights += row.weight;
            tilts += row.weight * (row.normal - fit.transpose() * row.place).squaredNorm();
            bends +=
                row.weight * (fit.bottomRows<2>().transpose() * row.place.tail<2>()).squaredNorm();
        }
        const auto count = double(m_.triangles.size());
        facets.tilt = std::sqrt(tilts / weights * count / (2 * count - 6));
        const double both = facets.tilt + std::sqrt(bends / weights / 2);
        facets.share = both > 0 ? facets.tilt / both : 0;
        return true;
    }

private:
    struct Row {
        Eigen::Vector3d place;  ///< 1 and the triangle's centre, in the tangent plane
        Eigen::Vector2d normal;
        double weight;
    };

    /// Orientations may differ; noise seldom turns a triangle by 90°.
    bool collect(std::size_t v) {
        m_.triangles.clear();
        for (const std::uint32_t* t = at_.begin(v); t != at_.end(v); ++t)
            for (const std::uint32_t w : mesh_.triangles[*t]) {
                if (m_.triangles.size() + at_.count(w) > kMostTriangles) return false;
                m_.triangles.insert(m_.triangles.end(), at_.begin(w), at_.end(w));
            }
        std::sort(m_.triangles.begin(), m_.triangles.end());
        m_.triangles.erase(std::unique(m_.triangles.begin(), m_.triangles.end()),
                           m_.triangles.end());
        m_.normals.clear();
        const Eigen::Vector3d side = area_vector(mesh_, mesh_.triangles[*at_.begin(v)]);
        for (const std::uint32_t t : m_.triangles) {
            const Eigen::Vector3d n = area_vector(mesh_, mesh_.triangles[t]);
            m_.normals.push_back(n.dot(side) < 0 ? -n : n);
        }
        return true;
    }

    Row row_of(std::size_t v, std::size_t i, const Eigen::Vector3d& up) const {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        for (const std::uint32_t corner : mesh_.triangles[m_.triangles[i]])
            centre += mesh_.positions[corner] / 3;
        const double area = m_.normals[i].norm();
        const Eigen::Vector3d normal = m_.normals[i] / (m_.normals[i].dot(up) < 0 ? -area : area);
        Eigen::Vector3d place;
        place << 1, axes_.transpose() * (centre - mesh_.positions[v]) / mesh_.mean_edge;
        return {place, axes_.transpose() * normal, area};
    }

    const PreparedMesh& mesh_;
    const TrianglesAt& at_;
    FacetMemory& m_;
    Eigen::Matrix<double, 3, 2> axes_;
};

double quantile(std::vector<Facets>& facets, double Facets::*number, double share) {
    const auto place = facets.begin() + std::ptrdiff_t(share * double(facets.size() - 1));
    std::nth_element(facets.begin(), place, facets.end(),
                     [&](const Facets& a, const Facets& b) { return a.*number < b.*number; });
    return (*place).*number;
}

}  // namespace

bool has_noisy_facets(const PreparedMesh& mesh) {
    if (!(mesh.mean_edge >= kLeastEdge && mesh.mean_edge <= kLargestEdge)) return false;
    // noise leaves no flat faces; sides of thin plates seem noisy
    if (is_made(mesh, CornerTable(mesh.triangles, mesh.size()))) return false;
    const TrianglesAt at(mesh.size(), mesh.triangles);
    const std::size_t count = std::min(kSamples, mesh.size());
    std::vector<Facets> all(count);
    std::vector<std::uint8_t> is_known(count);
    in_parallel<FacetMemory>(count, [&](std::size_t sample, FacetMemory& memory) {
        is_known[sample] =
            FacetFit(mesh, at, memory).measure(sample * mesh.size() / count, all[sample]);
    });
    std::vector<Facets> facets;
    for (std::size_t i = 0; i < count; ++i)
        if (is_known[i]) facets.push_back(all[i]);
    if (facets.empty()) return false;
    const double tilt = quantile(facets, &Facets::tilt, 0.25);
    return tilt >= kLeastTilt && quantile(facets, &Facets::share, 0.25) >= kLeastShare &&
           quantile(facets, &Facets::tilt, 0.75) < kMostUneven * tilt;
}

}  // namespace laplacian_lines
