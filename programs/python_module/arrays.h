// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/line_visibility.h"

namespace python_module {

template <class Number, int Columns>
using Rows = nanobind::ndarray<const Number, nanobind::numpy, nanobind::shape<-1, Columns>,
                               nanobind::c_contig, nanobind::device::cpu>;
using Positions = Rows<double, 3>;
using Triangles = Rows<std::uint32_t, 3>;

laplacian_lines::TriangleMesh mesh_of(const Positions& positions, const Triangles& triangles);
/// Positions and triangles.
nanobind::tuple arrays_of(const laplacian_lines::TriangleMesh& mesh);
/// By attribute names of field_columns.h: (vertices, 3) or (vertices,).
nanobind::dict arrays_of(const laplacian_lines::Field& field);
/// By the names in laplacian_lines/polylines.py.
nanobind::dict arrays_of(const laplacian_lines::LineSet& lines);
nanobind::dict arrays_of(const std::vector<laplacian_lines::SightLine>& lines);

}  // namespace python_module
