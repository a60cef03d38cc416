// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

/// The parameter "Views" is a text, which also takes angles; those that have a name are chosen by
/// check marks.

/// The view of MeshLab's window.
constexpr const char* window_view = "window";

/// "window", "front", ...
QStringList viewsWithMarks();

/// Whether a text names a view, "six" all sides.
bool hasView(const QString& text, const QString& view);

/// The text with a view or without it; what else is named there stays in its order.
QString withView(const QString& text, const QString& view, bool is_wanted);
