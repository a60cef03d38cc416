// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/field_columns.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Rows of a table of columns. Their attributes on a mesh are Point3m or Scalarm by slot (see
/// mesh_conversion.h); entries of the columns count live vertices.
using ColumnList = std::vector<laplacian_lines::FieldColumn>;

/// Whether all names are taken, by whatever.
bool hasNames(const CMeshO& mesh, const ColumnList& columns);

/// Whether all attributes are there, with their types and with a value for each slot.
bool hasColumns(const CMeshO& mesh, const ColumnList& columns);

/// Hashes the values of all vertices that are not deleted. Needs hasColumns().
std::uint64_t contentHash(const CMeshO& mesh, const ColumnList& columns);

/// Resizes the field's columns and fills them. Needs hasColumns().
void readColumns(const CMeshO& mesh, const ColumnList& columns, laplacian_lines::Field& field);

/// Replaces the attributes, whatever their types were; deleted vertices get zeros. The columns have
/// an entry for each live vertex. @throws std::bad_alloc before any value is written.
void writeColumns(CMeshO& mesh, const ColumnList& columns, const laplacian_lines::Field& field);

/// Those that are not there do not matter.
void removeColumns(CMeshO& mesh, const ColumnList& columns);

}  // namespace meshlab_host
