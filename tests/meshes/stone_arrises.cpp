// SPDX-License-Identifier: GPL-3.0-or-later
// Arrises of a flaked stone, as borders between its faces on a sphere of rays.
#include <algorithm>
#include <cmath>
#include <map>

#include "flaked_stone.h"
#include "generators.h"

namespace test_meshes {
namespace {

using Eigen::Vector3d;

constexpr double kDegrees = 57.29577951308232;

/// On the edges of an icosphere.
class FaceBorders {
public:
    FaceBorders(const FlakedStone& stone, int level) : stone_(stone), rays_(icosphere(level)) {
        for (const Vector3d& direction : rays_.positions)
            faces_.push_back(stone.face(direction));
    }

    std::vector<ArrisPiece> find(double least_angle) {
        std::vector<ArrisPiece> pieces;
        for (const Triangle& t : rays_.triangles) {
            std::vector<const Border*> borders;
            for (std::size_t k = 0; k < 3; ++k)
                if (faces_[t[k]] != faces_[t[(k + 1) % 3]])
                    borders.push_back(&border(t[k], t[(k + 1) % 3]));
            if (borders.size() == 2) add(*borders[0], borders[1]->p, least_angle, pieces);
            if (borders.size() < 3) continue;
            const Vector3d corner = (borders[0]->p + borders[1]->p + borders[2]->p) / 3;
            for (const Border* border : borders)
                add(*border, corner, least_angle, pieces);
        }
        return pieces;
    }

private:
    struct Border {
        Vector3d p;  ///< on the unrounded surface
        int faces[2];
    };

    /// By bisection; a third face may lie between.
    const Border& border(std::uint32_t a, std::uint32_t b) {
        const auto [found, is_new] = borders_.try_emplace(std::minmax(a, b));
        if (!is_new) return found->second;
        Vector3d low = rays_.positions[std::min(a, b)], high = rays_.positions[std::max(a, b)];
        const int face = faces_[std::min(a, b)];
        int beyond = faces_[std::max(a, b)];
        for (int step = 0; step < 16; ++step) {
            const Vector3d middle = (low + high).normalized();
            const int here = stone_.face(middle);
            if (here == face) {
                low = middle;
            } else {
                high = middle;
                beyond = here;
            }
        }
        found->second = {stone_.sharp_surface(high), {face, beyond}};
        return found->second;
    }

    void add(const Border& from, const Vector3d& to, double least_angle,
             std::vector<ArrisPiece>& pieces) const {
        const Vector3d m = (from.p + to) / 2, n0 = stone_.face_wall(from.faces[0], m).normal,
                       n1 = stone_.face_wall(from.faces[1], m).normal;
        const double angle = std::acos(std::clamp(n0.dot(n1), -1., 1.)) * kDegrees;
        if (angle < least_angle) return;
        const Solid solid = [&](const Vector3d& p) { return stone_.wall(p); };
        pieces.push_back(
            {onto_surface(solid, from.p), onto_surface(solid, to), angle, (n0 + n1).normalized()});
    }

    const FlakedStone& stone_;
    const TriangleMesh rays_;
    std::vector<int> faces_;  // by ray
    std::map<std::pair<std::uint32_t, std::uint32_t>, Border> borders_;
};

}  // namespace

std::vector<ArrisPiece> find_arrises(const FlakedStone& stone, double least_angle, int level) {
    return FaceBorders(stone, level).find(least_angle);
}

}  // namespace test_meshes
