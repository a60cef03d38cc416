// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

/// The tables that dialogs are made from, for programs that call the filters and show no dialogs: a
/// JSON object, UTF-8, that lives as long as the plugin. In it are
///     filters   name, python_name, help and parameters of each: key, label, help, default, kind
///               ("real", "integer", "length", "boolean", "choice", "text", "place"), minimum and
///               maximum (absent if there is no limit), choices; of places, by which choice of
///               which parameter they count
///     columns   the attributes of fields: name, numbers a vertex, help, unit, optional
///     kinds     the kinds of lines in the order of their numbers: key, one, many, outline, color
///               (0xRRGGBB), width
extern "C" Q_DECL_EXPORT const char* laplacian_lines_tables();
