// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "laplacian_lines/option_table.h"

namespace benchmarks {

/// What line_truth's command line asks for.
struct TruthOptions {
    bool stones = true, parts = true, drawings = true, terraces = true, kinds_alone = true,
         crests = true;  ///< which tables
    std::vector<double> seeds = {1, 2, 3};
    std::vector<double> radii = {0.5, 1, 2};       ///< of edges, % of D
    std::vector<double> resolutions = {1, 4, 16};  ///< powers of 4
    std::vector<double> noise = {0, 10, 20};       ///< of stones and parts, % of the mean edge
    std::vector<double> drawing_noise = {20, 40};  ///< of drawings
    std::vector<double> drawing_seeds = {1};       ///< of the noise, of kinds alone
    std::vector<double> voxels = {80, 160};        ///< along each axis, of terraces
    /// The least, see crest_lines().
    std::vector<double> crest_strengths = {1, 2, 4};
    double ripple_angle = 5;                   ///< of stones, degrees
    double reach = 1, drawing_reach = 0.5;     ///< of a line, % of D
    double sharp_angle = 15, blunt_angle = 8;  ///< degrees, see Truth
    double least_opacity = 0.1;                ///< of what counts as drawn
    laplacian_lines::LineKindSet kinds;        ///< by which arrises may be drawn
    laplacian_lines::LineStyle style;
    std::vector<std::string> files;

    TruthOptions();
    /// `diagonal` is what percents of lengths are of.
    laplacian_lines::PrecomputeOptions field_options(double diagonal) const;
    /// @throws std::invalid_argument
    void set(const std::string& key_and_value);

    laplacian_lines::PrecomputeOptions field;
    using FieldRow = laplacian_lines::OptionDescription<laplacian_lines::PrecomputeOptions>;
    std::vector<std::pair<const FieldRow*, double>> field_percents;
};

/// @throws std::invalid_argument, laplacian_lines::Error
TruthOptions parse_truth_options(const std::vector<std::string>& arguments);

extern const char* const truth_usage;

}  // namespace benchmarks
