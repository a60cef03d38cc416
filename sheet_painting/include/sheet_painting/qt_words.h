// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QString>

#include "laplacian_lines/error.h"

namespace sheet_painting {

inline QString inQt(const std::string& text) {
    return QString::fromStdString(text);
}

/// The name of a file as the system has it.
inline std::string fileName(const QString& name) {
    return QFile::encodeName(name).toStdString();
}

/// @throws laplacian_lines::Error(InvalidOption), always
[[noreturn]] inline void refuse(const QString& sentence) {
    laplacian_lines::refuse(sentence.toStdString());
}

}  // namespace sheet_painting
