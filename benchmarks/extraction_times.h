// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"
#include "speed_report.h"
#include "turns.h"

namespace benchmarks {

extern const Section kExtraction, kRatios, kBuilding, kMemory;

/// Adds the times of redraws of a mesh, seen by the eyes of orbit.h, beside plain ways to draw
/// less; the ratios between them; and what the extractor takes to build and to hold.
/// @throws std::runtime_error if the extractor's zeros are not those of the plain loop.
void add_extraction(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Field& field,
                    Turns turns, MeshFigures& figures);

}  // namespace benchmarks
