// SPDX-License-Identifier: GPL-3.0-or-later
#include "wild_mesh.h"

#include <cmath>
#include <limits>

#include "generators.h"

namespace test_meshes {
namespace {

using Limits = std::numeric_limits<double>;

constexpr std::uint8_t kFirstByteMesh = 240;  // below, the last digit tells the form

Eigen::Vector3d small_point(Choices& choices) {
    const double x = choices.byte(), y = choices.byte(), z = choices.byte();
    return Eigen::Vector3d(x, y, z) / 16;
}

/// On a coarse grid, so that points coincide and align.
TriangleMesh soup(Choices& choices) {
    TriangleMesh mesh;
    const unsigned vertices = choices.below(40);
    for (unsigned v = 0; v < vertices; ++v)
        mesh.positions.push_back(small_point(choices));
    if (!vertices) return mesh;
    const unsigned triangles = choices.below(80);
    for (unsigned t = 0; t < triangles; ++t) {
        const unsigned a = choices.below(vertices), b = choices.below(vertices);
        mesh.triangles.push_back({a, b, choices.below(vertices)});
    }
    return mesh;
}

TriangleMesh form(Choices& choices) {
    const unsigned form = choices.byte();
    if (form >= kFirstByteMesh) return read_byte_mesh(choices);
    switch (form % 10) {
        case 0:
            return soup(choices);
        case 1:
            return icosphere(int(choices.below(3)));
        case 2:
            return plane(1 + int(choices.below(8)), choices.unit() / 2);
        case 3:
            return torus(3 + int(choices.below(14)), 3 + int(choices.below(8)), choices.unit())
                .mesh;
        case 4:
            return cube(1 + int(choices.below(4)));
        case 5:
            return moebius_strip(4 + int(choices.below(20)), 1 + int(choices.below(3)));
        case 6:
            return fan_of_sheets(2 + int(choices.below(5)), 1 + int(choices.below(4)));
        case 7:
            return parallel_sheets(1 + int(choices.below(6)), choices.unit());
        case 8:
            return hills(2 + int(choices.below(9)), choices.unit() / 2).mesh;
        default:
            return bumpy_sphere(int(choices.below(3)), choices.unit()).mesh;
    }
}

class Damage {
public:
    Damage(Choices& choices, bool bad_indices, TriangleMesh& mesh)
        : choices_(choices), bad_indices_(bad_indices), mesh_(mesh) {}

    void next() {
        if (mesh_.positions.empty()) return;
        switch (choices_.below(14)) {
            case 0:
                vertex()[choices_.below(3)] = odd_number(choices_);
                break;
            case 1:
                vertex() = vertex();
                break;
            case 2:
                collapse();
                break;
            case 3:
                repeat_triangles();
                break;
            case 4:
                flip_triangles(mesh_, 1 + int(choices_.below(7)));
                break;
            case 5:
                remove_triangles();
                break;
            case 6:
                stretch();
                break;
            case 7:
                shift();
                break;
            case 8:
                rewire();
                break;
            case 9:
                mesh_.positions.push_back(small_point(choices_));
                break;
            case 10:
                if (indices_are_good_ && mesh_.triangles.size() < 300) mesh_ = cut_apart(mesh_);
                break;
            case 11:
                append_form();
                break;
            case 12:
                vertex() = small_point(choices_);
                break;
            case 13:
                tear_off();
                break;
        }
    }

private:
    Eigen::Vector3d& vertex() { return mesh_.positions[any_index()]; }
    std::uint32_t any_index() { return choices_.word() % std::uint32_t(mesh_.positions.size()); }
    Triangle* any_triangle() {
        return mesh_.triangles.empty() ? nullptr
                                       : &mesh_.triangles[choices_.word() % mesh_.triangles.size()];
    }

    /// To one place, line or plane.
    void collapse() {
        const Eigen::Vector3d to = vertex();
        const unsigned every = 1 + choices_.below(4), axes = 1 + choices_.below(7);
        for (std::size_t v = 0; v < mesh_.positions.size(); v += every)
            for (unsigned axis = 0; axis < 3; ++axis)
                if (axes >> axis & 1) mesh_.positions[v][axis] = to[axis];
    }

    void repeat_triangles() {
        const Triangle* t = any_triangle();
        if (!t) return;
        const Triangle copy = *t, reversed = {copy[0], copy[2], copy[1]};
        const bool flip = choices_.one_in(2);
        for (unsigned i = choices_.below(64); i > 0; --i)
            mesh_.triangles.push_back(flip && i % 2 ? reversed : copy);
    }

    void remove_triangles() {
        const unsigned every = 1 + choices_.below(8);
        std::vector<Triangle> kept;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            if (t % every) kept.push_back(mesh_.triangles[t]);
        mesh_.triangles.swap(kept);
    }

    void stretch() {
        const double factor = std::pow(10., int(choices_.below(41)) - 20);
        const unsigned axes = 1 + choices_.below(7);
        for (Eigen::Vector3d& p : mesh_.positions)
            for (unsigned axis = 0; axis < 3; ++axis)
                if (axes >> axis & 1) p[axis] *= factor;
    }

    void shift() {
        const double by = std::pow(10., int(choices_.below(41)) - 20);
        const unsigned axis = choices_.below(3);
        for (Eigen::Vector3d& p : mesh_.positions)
            p[axis] += by;
    }

    void rewire() {
        Triangle* t = any_triangle();
        if (!t) return;
        const unsigned corner = choices_.below(3);
        (*t)[corner] = any_index();
        if (!bad_indices_ || !choices_.one_in(8)) return;
        (*t)[corner] = choices_.word() << (choices_.byte() % 17);
        indices_are_good_ = false;
    }

    void append_form() {
        if (mesh_.triangles.size() > 300) return;
        append(mesh_, form(choices_));
    }

    /// A needle from one vertex to far away.
    void tear_off() { vertex() *= std::pow(10., int(choices_.below(31)) - 15); }

    Choices& choices_;
    bool bad_indices_, indices_are_good_ = true;
    TriangleMesh& mesh_;
};

}  // namespace

double odd_number(Choices& choices) {
    constexpr double kOdd[] = {Limits::quiet_NaN(),
                               Limits::infinity(),
                               -Limits::infinity(),
                               0,
                               -0.,
                               Limits::denorm_min(),
                               Limits::min(),
                               Limits::max(),
                               -Limits::max(),
                               1e-30,
                               1e30,
                               1e-8,
                               1e8,
                               3.4e38,
                               1e-45};
    constexpr unsigned kCount = sizeof(kOdd) / sizeof(kOdd[0]);
    const unsigned choice = choices.below(kCount + 1);
    return choice < kCount ? kOdd[choice] : choices.any_double();
}

std::vector<std::uint8_t> wild_mesh_bytes(const TriangleMesh& mesh) {
    std::vector<std::uint8_t> bytes = byte_mesh(mesh);
    bytes.insert(bytes.begin(), kFirstByteMesh);
    bytes.push_back(0);  // no damage
    return bytes;
}

TriangleMesh wild_mesh(Choices& choices, bool bad_indices) {
    TriangleMesh mesh = form(choices);
    Damage damage(choices, bad_indices, mesh);
    for (unsigned count = choices.below(8); count > 0; --count)
        damage.next();
    return mesh;
}

}  // namespace test_meshes
