// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "report.h"

class MeshDocument;

namespace server {

/// Runs all filters of a script (.mlx) on the document. Parameters that the script does not name
/// have their defaults. Unlike MeshLab itself, refuses what it does not understand: unknown
/// filters and parameters, values of another type, text that is not a number.
/// @throws MLException that names the filter; those before it have changed the document then
void runScript(const QString& file, MeshDocument& document, Report& report);

}  // namespace server
