// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "report.h"

class MeshDocument;

namespace server {

/// Runs a script (.mlx). Missing parameters have their defaults. Unlike MeshLab, refuses unknown
/// filters and parameters, values of another type, and text that is not a number. @throws
/// MLException that names the filter; earlier ones have changed the document
void runScript(const QString& file, MeshDocument& document, Report& report);

}  // namespace server
