// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// How a mesh is drawn for a contact sheet: its first view, small and without furniture; the
/// title is its size.
SheetOptions contactOptions(const laplacian_lines::TriangleMesh& mesh, const SheetOptions& options);

struct ContactEntry {
    QString name;
    Sheet view;
};

/// One page with all views, each in a square of the same size, with name and size below.
Sheet makeContactSheet(const std::vector<ContactEntry>& entries, const QString& title);

/// The paths of a sheet as bytes, to be kept in a file.
QByteArray packSheet(const Sheet& sheet);
/// @throws laplacian_lines::Error(InvalidOption) if it is none.
Sheet unpackSheet(const QByteArray& bytes);

}  // namespace line_drawing
