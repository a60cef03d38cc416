// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "laplacian_lines/option_table.h"
#include "program.h"

namespace benchmarks {

struct TruthOptions {
    std::string only;                              ///< one of the tables; empty: all
    std::vector<double> seeds = {1, 2, 3};         ///< of stones
    std::vector<double> radii = {0.5, 1, 2};       ///< of edges, % of D
    std::vector<double> resolutions = {1, 4, 16};  ///< powers of 4
    std::vector<double> noise = {0, 10, 20};       ///< of stones and parts, % of the mean edge
    std::vector<double> drawing_noise = {20, 40};  ///< of drawings
    std::vector<double> drawing_seeds = {1};       ///< of the noise of drawings
    std::vector<double> voxels = {80, 160};        ///< along each axis, of terraces
    double ripple_angle = 5;                       ///< of stones, degrees
    double reach = 1, drawing_reach = 0.5;         ///< of a line, % of D
    double sharp_angle = 15, blunt_angle = 8;      ///< degrees, see Truth
    double least_opacity = 0.1;                    ///< of what counts as drawn
    laplacian_lines::LineKindSet kinds;            ///< by which arrises may be drawn
    laplacian_lines::LineStyle style;

    TruthOptions();
    /// `diagonal`: for percentages of lengths.
    laplacian_lines::PrecomputeOptions field_options(double diagonal) const;
    /// The command line's options, which refer to this.
    std::vector<Option> words();
    /// @throws std::invalid_argument, laplacian_lines::Error
    void check() const;

private:
    void set(const std::string& key_and_value);

    laplacian_lines::PrecomputeOptions field_;
    using FieldRow = laplacian_lines::OptionDescription<laplacian_lines::PrecomputeOptions>;
    std::vector<std::pair<const FieldRow*, double>> field_percents_;
};

struct TruthTable {
    const char* name;
    void (*print)(const TruthOptions& options, const std::vector<std::string>& files);
};
const std::array<TruthTable, 6>& truth_tables();

/// Flaked stones and machined parts against their arrises.
void print_stones(const TruthOptions& options, const std::vector<std::string>&);
void print_parts(const TruthOptions& options, const std::vector<std::string>&);
/// Noisy meshes against clean ones: registered meshes and files; for files also kind by kind.
void print_drawings(const TruthOptions& options, const std::vector<std::string>& files);
void print_kinds_alone(const TruthOptions& options, const std::vector<std::string>& files);
/// A head from label volumes against the same head from smooth ones.
void print_terraces(const TruthOptions& options, const std::vector<std::string>&);
/// How steady lines of files are while the view turns and zooms.
void print_motion(const TruthOptions&, const std::vector<std::string>& files);

}  // namespace benchmarks
