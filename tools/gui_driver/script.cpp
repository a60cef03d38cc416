// SPDX-License-Identifier: GPL-3.0-or-later
#include "script.h"
#include <QFile>
#include <QTextStream>

namespace driver {
namespace {

QStringList cutIntoWords(const QString& text) {
    QStringList words;
    QString word;
    bool quoted = false, inWord = false;
    for (const QChar c : text) {
        if (c == '"') {
            quoted = !quoted;
            inWord = true;  // "" is an empty word
        } else if (c.isSpace() && !quoted) {
            if (inWord) words << word;
            word.clear();
            inWord = false;
        } else {
            word += c;
            inWord = true;
        }
    }
    if (inWord) words << word;
    return words;
}

}  // namespace

Command parseLine(const QString& text) {
    Command command;
    command.name = text.section(' ', 0, 0);
    command.rest = text.mid(command.name.size()).trimmed();
    command.words = cutIntoWords(command.rest);
    return command;
}

QVector<Command> readScript(const QString& file_name) {
    QFile file(file_name);
    if (!file.open(QIODevice::ReadOnly))
        throw CommandError(QString("cannot read the script %1").arg(file_name));
    QTextStream text(&file);
    text.setCodec("UTF-8");

    QVector<Command> script;
    for (int line = 1; !text.atEnd(); ++line) {
        const QString content = text.readLine().trimmed();
        if (content.isEmpty() || content.startsWith('#')) continue;
        script << parseLine(content);
        script.last().line = line;
    }
    return script;
}

}  // namespace driver
