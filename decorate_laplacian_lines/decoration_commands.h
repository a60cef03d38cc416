// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <vector>

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
