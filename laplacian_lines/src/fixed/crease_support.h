// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "system/three_floats.h"

namespace laplacian_lines {

/// An edge that is taken for one of the form, or may be.
struct PossibleCrease {
    std::array<std::uint32_t, 2> vertices;
    std::array<Eigen::Vector3f, 2> positions;
    float angle;  ///< degrees
    bool is_certain;
    bool is_strong;   ///< of one that is not certain: at least half of its angle is unexplained
    bool is_unclear;  ///< of one that is not certain: what is around cannot tell

    float length() const { return length_of(positions[1] - positions[0]); }
};

/// Which of them are edges of the form: all that are certain, and others in chains from one such
/// edge to another or around, of which at least half is strong; unclear ones only singly, between
/// others of a chain. Of a mesh that was made also those from one such edge on as far as their
/// angles fall: a crease that runs out, as mitres of fillets do; on a scan, noise beside a bad
/// place falls as well.
std::vector<std::uint8_t> find_supported(const std::vector<PossibleCrease>& edges, bool is_made);

}  // namespace laplacian_lines
