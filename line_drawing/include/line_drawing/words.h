// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QStringList>

#include "laplacian_lines/error.h"

namespace line_drawing {

/// Those of a list whose words are separated by commas, semicolons or spaces.
inline QStringList wordsOf(const QString& text) {
    return text.split(QRegularExpression("[,;\\s]+"), Qt::SkipEmptyParts);
}

/// A text that may hold anything, made to fit a line: no line breaks or other control characters.
inline QString oneLine(QString text) {
    for (QChar& c : text)
        if (c.category() == QChar::Other_Control || c == QChar::LineSeparator ||
            c == QChar::ParagraphSeparator)
            c = ' ';
    return text;
}

/// @throws laplacian_lines::Error(InvalidOption), always
[[noreturn]] inline void refuse(const QString& sentence) {
    laplacian_lines::refuse(sentence.toStdString());
}

}  // namespace line_drawing
