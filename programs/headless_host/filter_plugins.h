// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include "report.h"

class FilterPlugin;
class QAction;

namespace server {

struct LoadedFilter {
    FilterPlugin* plugin;
    QAction* action;
};

/// Loads `files`, then MeshLab's plugins for filters and files, except those that have the name of
/// one of `files`. One of MeshLab's own that cannot be loaded is only reported.
/// @throws MLException if one of `files` cannot be loaded
void loadPlugins(const QStringList& files, Report& report);

/// @throws MLException that names similar filters if there is none of this name
LoadedFilter filterNamed(const QString& name);

/// Writes all filters with their parameters, as text. @throws MLException
void dumpFilters(const QString& file);

}  // namespace server
