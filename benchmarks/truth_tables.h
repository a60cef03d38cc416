// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "truth_options.h"

namespace benchmarks {

/// Each prints a table to standard output.
void print_stones(const TruthOptions& options);
void print_parts(const TruthOptions& options);
/// Drawings of noisy meshes against those of clean ones: of registered meshes and of files.
void print_drawings(const TruthOptions& options);
/// Of each kind alone, of the meshes that are named.
void print_kinds_alone(const TruthOptions& options);
/// Ridges and valleys beside crest lines as they are usually defined: of stones, parts and files.
void print_crests(const TruthOptions& options);
/// Drawings of a head from segmented volumes against those of the smooth head.
void print_terraces(const TruthOptions& options);

}  // namespace benchmarks
