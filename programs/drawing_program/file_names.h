// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QStringList>
#include <cstdio>
#include <string>
#include <vector>

#include "laplacian_lines/error.h"

/// Makes Qt take file names for UTF-8, also in the locale C, and keep other bytes as in Python:
/// half a surrogate pair, U+DC80 to U+DCFF. Does nothing in other locales, which have their own
/// characters.
void keepFileNames();

/// With a replacement character for each such byte.
QString readable(const QString& name);

inline QString inQt(const std::string& text) {
    return QString::fromStdString(text);
}

/// As the system has it.
inline std::string fileName(const QString& name) {
    return QFile::encodeName(name).toStdString();
}

[[noreturn]] inline void refuse(const QString& sentence) {
    laplacian_lines::refuse(sentence.toStdString());
}

/// For texts on the drawing.
inline std::vector<std::string> inUtf8(const QStringList& words) {
    std::vector<std::string> texts;
    for (const QString& word : words)
        texts.push_back(word.toStdString());
    return texts;
}

inline void say(FILE* stream, const QString& line) {
    std::fprintf(stream, "%s\n", line.toLocal8Bit().constData());
    std::fflush(stream);
}
