// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"

/// What the user wants to know about a finished computation, one line of the log each. Parts that
/// say "none were left out" are not there.
QStringList computeReport(const laplacian_lines::Field& field,
                          const laplacian_lines::PrecomputeOptions& options, double seconds);
