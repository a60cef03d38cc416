// SPDX-License-Identifier: GPL-3.0-or-later
#include "arris_forms.h"

#include <cmath>
#include <memory>

#include "flaked_stone.h"
#include "machined_part.h"

namespace benchmarks {
namespace {

constexpr int kStoneLevel = 5;       // of resolution 1: 20,480 triangles
constexpr double kPartEdge = 0.012;  // of resolution 1, in D

}  // namespace

const std::array<Eigen::Vector3d, 6> arris_eyes = {{{1, 0.2, 0.3},
                                                    {-1, 0.3, 0.2},
                                                    {0.3, 1, 0.2},
                                                    {0.2, -1, 0.3},
                                                    {0.2, 0.3, 1.0},
                                                    {0.3, 0.2, -1}}};

std::vector<ArrisForm> flaked_stones(double radius, const TruthOptions& options) {
    std::vector<ArrisForm> forms;
    for (const double seed : options.seeds) {
        const auto stone = std::make_shared<const test_meshes::FlakedStone>(
            test_meshes::StoneShape{unsigned(seed), radius / 100, 40, options.ripple_angle});
        forms.push_back({Truth(find_arrises(*stone, options.blunt_angle), options.sharp_angle,
                               options.blunt_angle),
                         stone->diagonal(), [stone](double resolution) {
                             const int doublings = int(std::lround(std::log2(resolution) / 2));
                             return stone->mesh(kStoneLevel + doublings);
                         }});
    }
    return forms;
}

ArrisForm machined_part(double radius, const TruthOptions& options) {
    const auto part = std::make_shared<const test_meshes::MachinedPart>(radius / 100);
    return {Truth(part->arrises(), options.sharp_angle, options.blunt_angle),
            test_meshes::MachinedPart::diagonal(),
            [part](double resolution) { return part->mesh(kPartEdge / std::sqrt(resolution)); }};
}

}  // namespace benchmarks
