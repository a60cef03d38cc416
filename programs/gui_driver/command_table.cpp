// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_table.h"

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

const CommandHandler& find(const CommandTable& table, const QString& name) {
    const auto found = table.find(name);
    if (found == table.end()) throw CommandError(QString("unknown command '%1'").arg(name));
    return found->second;
}

Command parse_line(const QString& text) {
    Command command;
    command.name = text.section(' ', 0, 0);
    command.rest = text.mid(command.name.size()).trimmed();
    command.words = command.rest.split(' ', Qt::SkipEmptyParts);
    return command;
}

QVector<Command> read_script(const QString& file_name) {
    QFile file(file_name);
    if (!file.open(QIODevice::ReadOnly))
        throw CommandError(QString("cannot read the script %1").arg(file_name));
    QTextStream text(&file);
    text.setCodec("UTF-8");

    QVector<Command> script;
    for (int line = 1; !text.atEnd(); ++line) {
        const QString content = text.readLine().trimmed();
        if (content.isEmpty() || content.startsWith('#')) continue;
        script << parse_line(content);
        script.last().line = line;
    }
    return script;
}

CommandTable all_commands() {
    CommandTable table;
    for (const auto add :
         {add_dialog_commands, add_drawing_commands, add_frame_commands, add_window_commands})
        add(table);
    return table;
}

}  // namespace driver
