// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/whole_file.h"

#include <unistd.h>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

[[noreturn]] void refuseToWrite(const QString& file, const QString& reason) {
    refuse(QString("\"%1\" cannot be written: %2").arg(file, reason));
}

/// The system would take what comes before it.
void refuseNull(QString file) {
    if (!file.contains(QChar::Null)) return;
    refuseToWrite(file.replace(QChar::Null, "\\0"), "the name holds a null character");
}

/// A device, a pipe or a link to one.
bool isSpecial(const QString& file) {
    const QFileInfo info(file);
    return info.exists() && !info.isFile();
}

/// Not buffered: the system's reason is known of each write.
void open(QFileDevice& output) {
    if (!output.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        refuseToWrite(output.fileName(), output.errorString());
}

/// The system writes as much as there is room for; the next write then says what is missing.
void writeAll(QFileDevice& output, const QByteArray& data) {
    for (qint64 done = 0; done < data.size();) {
        const qint64 count = output.write(data.constData() + done, data.size() - done);
        if (count <= 0) refuseToWrite(output.fileName(), output.errorString());
        done += count;
    }
}

}  // namespace

void writeWhole(const QString& file, const QByteArray& data) {
    refuseNull(file);
    if (isSpecial(file)) {
        QFile output(file);
        open(output);
        return writeAll(output, data);
    }
    QSaveFile output(file);  // takes away what it has written unless it is committed
    open(output);
    writeAll(output, data);
    if (::fsync(output.handle()) != 0 || !output.commit()) refuseToWrite(file, qt_error_string());
}

void checkWritable(const QString& file) {
    refuseNull(file);
    if (isSpecial(file)) {
        if (QFileInfo(file).isDir()) refuseToWrite(file, "it is a folder");
        if (!QFileInfo(file).isWritable()) refuseToWrite(file, "it is not yours to write");
        return;
    }
    QSaveFile output(file);
    open(output);
    output.cancelWriting();
}

}  // namespace line_drawing
