// SPDX-License-Identifier: GPL-3.0-or-later
#include "wild_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace test_meshes {

using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

namespace {

constexpr double kSteps = 1000;  // in a unit
constexpr unsigned kZero = 32000, kNaN = 65535;

double read_coordinate(Choices& choices) {
    const unsigned word = choices.word();
    return word == kNaN ? std::numeric_limits<double>::quiet_NaN()
                        : (double(word) - kZero) / kSteps;
}

TriangleMesh first_part(const TriangleMesh& mesh) {
    TriangleMesh part;
    std::unordered_map<std::uint32_t, std::uint32_t> places;
    for (const Triangle& t : mesh.triangles) {
        if (part.triangles.size() == kByteTriangles) break;
        if (part.positions.size() + 3 > kByteVertices) break;
        Triangle moved;
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t v = t[corner];
            if (v >= mesh.positions.size()) return part;
            const auto [place, is_new] =
                places.try_emplace(v, std::uint32_t(part.positions.size()));
            if (is_new) part.positions.push_back(mesh.positions[v]);
            moved[corner] = place->second;
        }
        part.triangles.push_back(moved);
    }
    return part;
}

bool fits(const TriangleMesh& mesh) {
    return mesh.positions.size() <= kByteVertices && mesh.triangles.size() <= kByteTriangles;
}

class Writer {
public:
    explicit Writer(const TriangleMesh& mesh) {
        for (const Eigen::Vector3d& p : mesh.positions)
            if (p.allFinite()) box_.extend(p);
        const double size = box_.isEmpty() ? 0 : box_.sizes().maxCoeff();
        scale_ = size > 0 && std::isfinite(size) ? 2 * kZero / size : 1;
        bytes_.push_back(std::uint8_t(mesh.positions.size()));
        for (const Eigen::Vector3d& p : mesh.positions)
            for (int axis = 0; axis < 3; ++axis)
                word(p.allFinite() ? step((p[axis] - box_.min()[axis]) * scale_) : kNaN);
        word(unsigned(mesh.triangles.size()));
        for (const Triangle& t : mesh.triangles)
            for (int corner = 0; corner < 3; ++corner)
                bytes_.push_back(std::uint8_t(t[corner]));
    }

    const std::vector<std::uint8_t>& bytes() const { return bytes_; }

private:
    static unsigned step(double x) {
        return std::isfinite(x) ? unsigned(std::lround(std::clamp(x, 0., 2. * kZero))) : kZero;
    }
    void word(unsigned value) {
        bytes_.push_back(std::uint8_t(value >> 8));
        bytes_.push_back(std::uint8_t(value));
    }

    Eigen::AlignedBox3d box_;
    double scale_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace

TriangleMesh read_byte_mesh(Choices& choices) {
    TriangleMesh mesh;
    mesh.positions.resize(choices.below(kByteVertices + 1));
    for (Eigen::Vector3d& p : mesh.positions)
        for (double& x : p)
            x = read_coordinate(choices);
    const unsigned triangles = choices.word() % (kByteTriangles + 1);
    if (mesh.positions.empty()) return mesh;
    mesh.triangles.resize(triangles);
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& corner : t)
            corner = choices.below(unsigned(mesh.positions.size()));
    return mesh;
}

std::vector<std::uint8_t> byte_mesh(const TriangleMesh& mesh) {
    return Writer(fits(mesh) ? mesh : first_part(mesh)).bytes();
}

}  // namespace test_meshes
