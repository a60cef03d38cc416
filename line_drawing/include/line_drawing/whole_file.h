// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace line_drawing {

/// Writes a file at once and whole: beside its place, flushed to the disk, then renamed. Links are
/// followed. Devices and pipes are written into, never replaced.
/// @throws laplacian_lines::Error(InvalidOption) naming the file and the reason. Then a file that
/// was there is as it was, and nothing is left beside it.
void writeWhole(const QString& file, const QByteArray& data);

/// Before much work is done: whether the file could be written now. Writes nothing.
/// @throws laplacian_lines::Error(InvalidOption)
void checkWritable(const QString& file);

}  // namespace line_drawing
