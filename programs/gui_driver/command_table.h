// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QVector>
#include <functional>
#include <map>
#include <stdexcept>

namespace driver {

/// A line of a script: NAME REST.
struct Command {
    int line = 0;  ///< from 1; 0 for a part of `together`
    QString name;
    QString rest;
    QStringList words;  ///< of the rest

    const QString& word(int index) const;  ///< CommandError when there are fewer words
    double number(int index) const;        ///< CommandError when it is not a number
};

/// `text` has no blanks around it.
Command parse_line(const QString& text);

/// One command a line; skips empty lines and those that start with #. CommandError if unreadable.
QVector<Command> read_script(const QString& file_name);

/// Ends the run with exit code 3, line and reason.
struct CommandError : std::runtime_error {
    explicit CommandError(const QString& why) : std::runtime_error(why.toStdString()) {}
};

/// Has the command run again soon, until the time limit of a line is over.
struct NotYet {};

/// How a command deals with modal boxes.
enum class Boxes {
    Errors,    ///< it is not started while there is one, and fails if it opens one
    Answered,  ///< the runner accepts those that it opens, and records their texts
    Subject    ///< it may be started while there is one, which is left to it
};

struct CommandHandler {
    std::function<void(const Command&)> handle;
    Boxes boxes = Boxes::Errors;
};
using CommandTable = std::map<QString, CommandHandler>;

/// CommandError if there is none.
const CommandHandler& find(const CommandTable& table, const QString& name);

/// Each file of commands registers its own; README.md describes them.
void add_dialog_commands(CommandTable& table);
void add_drawing_commands(CommandTable& table);
void add_frame_commands(CommandTable& table);
void add_window_commands(CommandTable& table);
CommandTable all_commands();

/// Begins to run a script in MeshLab's event loop, as long as `parent` lives. CommandError if it
/// cannot be read.
void run_script(const QString& file_name, QObject* parent);

}  // namespace driver
