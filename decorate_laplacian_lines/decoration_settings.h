// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <vector>

/// A parameter of the decoration and its value, as the field in the layer dialog has them.
struct DecorationSetting {
    QString key;
    QString label;
    QString value;
};

/// Reads "NAME=VALUE". NAME is the label or the key of a parameter, in upper or lower case; VALUE
/// is a color, "#202020" or a name, or what meshlab_host::valueIn() takes. Thread-safe.
/// @throws laplacian_lines::Error(InvalidOption) that says which names there are, or which values
/// are allowed; of a parameter that former versions had, what to do instead.
DecorationSetting readDecorationSetting(const QString& text);

/// A line for each parameter that former versions had and that MeshLab's settings still set to
/// something else than it always is now.
QStringList ignoredSettings();

/// The GUI driver's commands that set parameters of the decoration, each "NAME=VALUE" as
/// readDecorationSetting() has it. What would override one of them is set to leave it alone, unless
/// it is among them as well. Thread-safe.
/// @throws laplacian_lines::Error(InvalidOption) like readDecorationSetting().
QStringList settingCommands(const QStringList& settings);

/// One picture of a comparison: kinds of lines, or edges that are found in a picture of the shaded
/// surface.
struct ComparedPicture {
    QString label;
    QString detector;    ///< of edges in the picture: "log", "canny"; empty: lines
    QStringList before;  ///< the driver's commands before the picture is taken,
    QStringList after;   ///< and after it
};

/// @param names with commas between: kinds of lines as laplacian_lines::kinds_named() has them,
///        joined by +; log, canny; all, for all that are compared
/// @param settings what the user sets besides, as above: it counts in all pictures
/// @throws laplacian_lines::Error(InvalidOption) that lists the names there are.
std::vector<ComparedPicture> comparedPictures(const QString& names, const QStringList& settings);
