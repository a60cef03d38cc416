// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "field/cubic_form.h"
#include "laplacian_lines/field.h"
#include "mesh/prepared_mesh.h"
#include "mesh/vertex_ranges.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Sets the derivative of S of the vertices that are `wanted`, [N], by differences within the
/// triangles at each, in the frames of curved_vertex(): S is linear between the corners of a
/// triangle, in the triangle's plane, and what comes out is made symmetric, as it is on smooth
/// surfaces (Codazzi). S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle
/// Meshes", 3DPVT 2004, section 4, without its least squares. 0 where no triangle faces as its
/// corners do.
void set_ring_derivatives(const PreparedMesh& mesh, const VertexRanges& ranges, const Field& field,
                          const std::vector<std::uint8_t>& wanted, std::vector<CubicForm>& forms);

}  // namespace laplacian_lines
