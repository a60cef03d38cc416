// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_table.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTextStream>

namespace driver {

const QString& Command::word(int index) const {
    if (index >= words.size())
        throw CommandError(QString("%1 needs at least %2 argument(s)").arg(name).arg(index + 1));
    return words[index];
}

double Command::number(int index) const {
    bool is_number = false;
    const double value = word(index).toDouble(&is_number);
    if (!is_number) throw CommandError(QString("'%1' is not a number").arg(word(index)));
    return value;
}

QSize Command::size(int index) const {
    const QStringList parts = word(index).split('x');
    const QSize result(parts.value(0).toInt(), parts.value(1).toInt());
    if (parts.size() != 2 || result.isEmpty()) throw CommandError("say WIDTHxHEIGHT");
    return result;
}

QString Command::wordOr(int index, const QString& otherwise) const {
    return index < words.size() ? words[index] : otherwise;
}

Outcome retryAWhile(const Command& command, const QString& why) {
    constexpr qint64 longest_wait = 5000;  // ms
    static int line = 0;
    static QElapsedTimer waiting;
    if (line != command.line) {
        line = command.line;
        waiting.start();
    }
    if (waiting.elapsed() < longest_wait) return Outcome::Retry;
    throw CommandError(why);
}

void CommandTable::add(const QString& name, Handler handler, Place place) {
    entries_[name] = Entry{std::move(handler), place};
}

void CommandTable::addSimple(const QString& name, std::function<void(const Command&)> handler,
                             Place place) {
    add(
        name,
        [handler = std::move(handler)](const Command& command) {
            handler(command);
            return Outcome::Done;
        },
        place);
}

const CommandTable::Entry& CommandTable::find(const QString& name) const {
    const auto found = entries_.find(name);
    if (found == entries_.end()) {
        QStringList known;
        for (const auto& entry : entries_)
            known << entry.first;
        throw CommandError(
            QString("unknown command '%1'; there are: %2").arg(name, known.join(' ')));
    }
    return found->second;
}

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

void writeFile(const QString& file_name, const QByteArray& content) {
    QFile file(file_name);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.flush())
        throw CommandError("cannot write " + file_name);
}

CommandTable allCommands() {
    CommandTable table;
    for (const auto add : {addWindowCommands, addActionCommands, addDialogCommands,
                           addModalCommands, addDrawingCommands, addMouseCommands,
                           addMemoryCommands, addProbeCommands, addWatchCommands, addFrameCommands})
        add(table);
    return table;
}

}  // namespace driver
