// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include "report.h"

class MeshDocument;
class FilterPlugin;
class QAction;

namespace server {

struct LoadedFilter {
    FilterPlugin* plugin;
    QAction* action;
};

/// Loads `files`, then MeshLab's own plugins for filters and files but those with the name of one
/// of `files`; of these a failure is only reported. @throws MLException if one of `files` fails
void loadPlugins(const QStringList& files, Report& report);

/// @throws MLException that names similar filters if there is none
LoadedFilter filterNamed(const QString& name);

/// Writes all filters with parameters as text. @throws MLException
void dumpFilters(const QString& file);

/// Runs a script (.mlx). Missing parameters have their defaults. Unlike MeshLab, refuses unknown
/// filters and parameters, values of another type, and text that is not a number.
/// @throws MLException that names the filter; earlier ones have changed the document
void runScript(const QString& file, MeshDocument& document, Report& report);

}  // namespace server
