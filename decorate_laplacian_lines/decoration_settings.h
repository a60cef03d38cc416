// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// A parameter of the decoration and its value, as the field in the layer dialog has them.
struct DecorationSetting {
    QString key;
    QString label;
    QString value;
};

/// Reads "NAME=VALUE". NAME is the label or the key of a parameter, in upper or lower case; VALUE
/// is a color, "#202020" or a name, or what meshlab_host::valueIn() takes. Thread-safe.
/// @throws laplacian_lines::Error(InvalidOption) that says which names there are, or which values
/// are allowed.
DecorationSetting readDecorationSetting(const QString& text);
