// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"

/// Lines of the log about a finished computation. "None were left out" is not said.
QStringList computeReport(const laplacian_lines::Field& field,
                          const laplacian_lines::PrecomputeOptions& options, double seconds);
