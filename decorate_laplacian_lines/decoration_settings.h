// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <vector>

/// As in the layer dialog.
struct DecorationSetting {
    QString key;
    QString label;
    QString value;
};

/// Reads "NAME=VALUE". NAME is a parameter's label or key in any case; VALUE a color, "#202020" or
/// a name, or what meshlab_host::valueIn() takes. Thread-safe.
/// @throws laplacian_lines::Error(InvalidOption) with the names or values allowed; for parameters
/// of former versions, with what to do instead
DecorationSetting readDecorationSetting(const QString& text);

/// A line for each parameter of former versions that MeshLab's settings give another value than its
/// constant.
QStringList ignoredSettings();

/// The GUI driver's commands for settings "NAME=VALUE". Parameters that would override one of them
/// are reset, unless they are set as well. Thread-safe.
/// @throws laplacian_lines::Error(InvalidOption) like readDecorationSetting()
QStringList settingCommands(const QStringList& settings);

/// One picture of a comparison of kinds of lines.
struct ComparedPicture {
    QString label;
    QStringList before;  ///< the driver's commands before the picture is taken,
    QStringList after;   ///< and after it
};

/// @param names separated by commas: kinds as in laplacian_lines::kinds_named(), joined by +; all
/// @param settings the user's, as above, for all pictures
/// @throws laplacian_lines::Error(InvalidOption) that lists the names
std::vector<ComparedPicture> comparedPictures(const QString& names, const QStringList& settings);
