// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QStringList>
#include <cstdio>
#include <string>
#include <vector>

#include "laplacian_lines/error.h"

/// From now on, Qt takes names of files for UTF-8, also in the locale C, and keeps what is none: a
/// byte that belongs to no character is half a surrogate pair, U+DC80 to U+DCFF, as in Python.
/// Other locales have their own characters, and nothing changes there.
void keepFileNames();

/// The name as people can read it, with a replacement character for each such byte.
QString readable(const QString& name);

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

/// For the drawing, as UTF-8.
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
