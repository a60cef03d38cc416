// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/parameters.h"

namespace meshlab_host {

// Parameter values as people write and read them. Thread-safe.

/// A number; on, off, yes, no, true, false; or a choice, its number or an unambiguous beginning, in
/// any case. @throws laplacian_lines::Error(InvalidOption) that names label, text and allowed
/// values
double valueIn(const QString& text, const ParameterDescription& description);

/// As its field in a dialog shows it.
QString textOf(double value, const ParameterDescription& description);

/// @throws laplacian_lines::Error(InvalidOption) that names label, value and allowed values
[[noreturn]] void refuseValue(const QString& value, const ParameterDescription& description);
[[noreturn]] void refuseValue(const QString& value, const QString& label, const QString& allowed);

}  // namespace meshlab_host
