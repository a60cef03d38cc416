// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/parameters.h"

namespace meshlab_host {

/// Values of parameters as people write and read them. Thread-safe.

/// The value that a text means: a number; on or off, also yes, no, true and false; a choice, its
/// number or the beginning that it alone has, in upper or lower case.
/// @throws laplacian_lines::Error(InvalidOption) that names label, text and allowed values.
double valueIn(const QString& text, const ParameterDescription& description);

/// A number, on or off, or a choice: what its field in a dialog shows.
QString textOf(double value, const ParameterDescription& description);

/// @throws laplacian_lines::Error(InvalidOption) that names label, value and allowed values.
[[noreturn]] void refuseValue(const QString& value, const ParameterDescription& description);
[[noreturn]] void refuseValue(const QString& value, const QString& label, const QString& allowed);

}  // namespace meshlab_host
