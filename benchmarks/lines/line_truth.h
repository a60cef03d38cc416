// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

namespace benchmarks {

struct TruthOptions;

/// What line_truth prints, of the files that are named as well.
struct TruthTable {
    const char* name;
    void (*print)(const TruthOptions& options, const std::vector<std::string>& files);
};
const std::array<TruthTable, 5>& truth_tables();

/// Lines of flaked stones, of machined parts, against their arrises.
void print_stones(const TruthOptions& options, const std::vector<std::string>&);
void print_parts(const TruthOptions& options, const std::vector<std::string>&);
/// Drawings of noisy meshes against those of clean ones: of registered meshes and of files; and of
/// each kind alone, of files.
void print_drawings(const TruthOptions& options, const std::vector<std::string>& files);
void print_kinds_alone(const TruthOptions& options, const std::vector<std::string>& files);
/// Drawings of a head from volumes of labels against those of the same head from smooth ones.
void print_terraces(const TruthOptions& options, const std::vector<std::string>&);

}  // namespace benchmarks
