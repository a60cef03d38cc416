// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_table.h"

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

QString Command::wordOr(int index, const QString& otherwise) const {
    return index < words.size() ? words[index] : otherwise;
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

}  // namespace driver
