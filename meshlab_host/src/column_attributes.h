// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/field_columns.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Columns as Point3m or Scalarm attributes by slot (see mesh_conversion.h); their entries are by
/// live vertex.
using ColumnList = std::vector<laplacian_lines::FieldColumn>;

bool hasNames(const CMeshO& mesh, const ColumnList& columns);

/// With their types, and a value per slot.
bool hasColumns(const CMeshO& mesh, const ColumnList& columns);

/// Of live vertices. Needs hasColumns().
std::uint64_t contentHash(const CMeshO& mesh, const ColumnList& columns);

/// Resizes the field's columns and fills them. Needs hasColumns().
void readColumns(const CMeshO& mesh, const ColumnList& columns, laplacian_lines::Field& field);

/// Replaces attributes of any type; deleted vertices get zeros. Columns have an entry per live
/// vertex. @throws std::bad_alloc before writing
void writeColumns(CMeshO& mesh, const ColumnList& columns, const laplacian_lines::Field& field);

void removeColumns(CMeshO& mesh, const ColumnList& columns);

}  // namespace meshlab_host
