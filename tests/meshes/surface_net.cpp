// SPDX-License-Identifier: GPL-3.0-or-later
#include "rounded_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace test_meshes {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;
using laplacian_lines::TriangleMesh;

constexpr int kBlock = 8;  // nodes that are sampled or passed over together

/// At the nodes of a grid; far from the surface only signs are right.
class Grid {
public:
    Grid(const Solid& solid, const Eigen::AlignedBox3d& box, double cell)
        : cell_(cell), middle_(box.center()) {
        turn_ =
            (Eigen::AngleAxisd(0.4, Vector3d::UnitX()) * Eigen::AngleAxisd(0.3, Vector3d::UnitY()) *
             Eigen::AngleAxisd(0.5, Vector3d::UnitZ()))
                .toRotationMatrix();
        Vector3d half = Vector3d::Zero();
        for (int i = 0; i < 8; ++i) {
            const auto corner = Eigen::AlignedBox3d::CornerType(i);
            half = half.cwiseMax((turn_.transpose() * (box.corner(corner) - middle_)).cwiseAbs());
        }
        for (int k = 0; k < 3; ++k)
            size_[k] = (int(2 * half[k] / cell) + 4 + kBlock) / kBlock * kBlock;
        values_.resize(std::size_t(size_.x()) * std::size_t(size_.y()) * std::size_t(size_.z()));
        for (int z = 0; z < size_.z(); z += kBlock)
            for (int y = 0; y < size_.y(); y += kBlock)
                for (int x = 0; x < size_.x(); x += kBlock)
                    sample_block(solid, {x, y, z});
        while (part_corners()) {
        }
    }

    Vector3i size() const { return size_; }
    std::size_t index(const Vector3i& n) const {
        return std::size_t(n.x()) +
               std::size_t(size_.x()) *
                   (std::size_t(n.y()) + std::size_t(size_.y()) * std::size_t(n.z()));
    }
    double value(const Vector3i& n) const { return double(values_[index(n)]); }
    Vector3d place(const Vector3d& n) const {
        return middle_ + turn_ * (cell_ * (n - 0.5 * (size_ - Vector3i::Ones()).cast<double>()));
    }

private:
    void sample_block(const Solid& solid, const Vector3i& first) {
        const Vector3d centre = first.cast<double>() + Vector3d::Constant((kBlock - 1) / 2.0);
        const double at_centre = solid(place(centre)).distance;
        const bool passed = std::abs(at_centre) > cell_ * kBlock;  // more than half a diagonal
        for (int z = 0; z < kBlock; ++z)
            for (int y = 0; y < kBlock; ++y)
                for (int x = 0; x < kBlock; ++x) {
                    const Vector3i n = first + Vector3i(x, y, z);
                    values_[index(n)] =
                        float(passed ? at_centre : solid(place(n.cast<double>())).distance);
                }
    }

    /// If only opposite corners of a square are inside, two sheets would share an edge: flips the
    /// corner nearest to the surface. Whether there was one.
    bool part_corners() {
        bool found = false;
        for (int z = 0; z + 1 < size_.z(); ++z)
            for (int y = 0; y + 1 < size_.y(); ++y)
                for (int x = 0; x + 1 < size_.x(); ++x)
                    for (int axis = 0; axis < 3; ++axis)
                        found |= part_corners({x, y, z}, axis);
        return found;
    }
    bool part_corners(const Vector3i& node, int axis) {
        const Vector3i u = Vector3i::Unit((axis + 1) % 3), v = Vector3i::Unit((axis + 2) % 3);
        std::array<float*, 4> c = {&values_[index(node)], &values_[index(node + u)],
                                   &values_[index(node + u + v)], &values_[index(node + v)]};
        for (int k = 0; k < 4; ++k)
            if ((*c[std::size_t(k)] < 0) == (*c[std::size_t(k + 1) % 4] < 0)) return false;
        float& least = **std::min_element(
            c.begin(), c.end(), [](float* a, float* b) { return std::abs(*a) < std::abs(*b); });
        least = least < 0 ? 0 : -1e-6f * float(cell_);
        return true;
    }

    double cell_;
    Vector3d middle_;
    Eigen::Matrix3d turn_;
    Vector3i size_;
    std::vector<float> values_;
};

Vector3i unit(int axis) {
    return Vector3i::Unit(axis);
}

class Net {
public:
    Net(const Solid& solid, const Grid& grid) : solid_(solid), grid_(grid) {
        const Vector3i size = grid.size();
        for (int z = 1; z + 1 < size.z(); ++z)
            for (int y = 1; y + 1 < size.y(); ++y)
                for (int x = 1; x + 1 < size.x(); ++x)
                    for (int axis = 0; axis < 3; ++axis)
                        add_face({x, y, z}, axis);
    }
    TriangleMesh mesh;

private:
    /// Around the edge from a node along an axis.
    void add_face(const Vector3i& node, int axis) {
        const bool inside = grid_.value(node) < 0;
        if (inside == (grid_.value(node + unit(axis)) < 0)) return;
        const Vector3i u = unit((axis + 1) % 3), v = unit((axis + 2) % 3);
        std::array<std::uint32_t, 4> c = {vertex(node - u - v), vertex(node - v), vertex(node),
                                          vertex(node - u)};
        if (!inside) std::swap(c[1], c[3]);
        const auto& p = mesh.positions;
        if ((p[c[0]] - p[c[2]]).norm() < (p[c[1]] - p[c[3]]).norm())
            mesh.triangles.insert(mesh.triangles.end(), {{c[0], c[1], c[2]}, {c[0], c[2], c[3]}});
        else
            mesh.triangles.insert(mesh.triangles.end(), {{c[0], c[1], c[3]}, {c[1], c[2], c[3]}});
    }

    std::uint32_t vertex(const Vector3i& cell) {
        const auto [found, is_new] =
            vertices_.try_emplace(grid_.index(cell), std::uint32_t(mesh.positions.size()));
        if (is_new) mesh.positions.push_back(onto_surface(solid_, middle_of_zeros(cell)));
        return found->second;
    }

    /// On the edges of a cell.
    Vector3d middle_of_zeros(const Vector3i& cell) const {
        Vector3d sum = Vector3d::Zero();
        int count = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 4; ++side) {
                const Vector3i node =
                    cell + side % 2 * unit((axis + 1) % 3) + side / 2 * unit((axis + 2) % 3);
                const double a = grid_.value(node), b = grid_.value(node + unit(axis));
                if ((a < 0) == (b < 0)) continue;
                sum += node.cast<double>() + a / (a - b) * unit(axis).cast<double>();
                ++count;
            }
        return grid_.place(sum / count);
    }

    const Solid& solid_;
    const Grid& grid_;
    std::unordered_map<std::size_t, std::uint32_t> vertices_;  // by cell
};

}  // namespace

TriangleMesh surface_net(const Solid& solid, const Eigen::AlignedBox3d& box, double cell) {
    const Grid grid(solid, box, cell);
    return std::move(Net(solid, grid).mesh);
}

}  // namespace test_meshes
