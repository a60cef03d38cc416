// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <vector>

/// The GUI driver's commands for settings "NAME=VALUE". NAME is a parameter's label or key in any
/// case, VALUE what meshlab_host::number_in() takes. Thread-safe.
/// @throws laplacian_lines::Error(InvalidOption) with the names or values allowed
QStringList setting_commands(const QStringList& settings);

/// One picture of a comparison of kinds of lines.
struct ComparedPicture {
    QString label;
    QStringList commands;  ///< the driver's, before the picture is taken
};

/// @param names separated by commas: mixtures as in mixture_named(); kinds joined by +; all
/// @throws laplacian_lines::Error(InvalidOption) that lists the names
std::vector<ComparedPicture> compared_pictures(const QString& names);
