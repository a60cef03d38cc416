// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QSize>
#include <QString>
#include <QStringList>
#include <QVector>
#include <functional>
#include <map>
#include <stdexcept>

namespace driver {

// A line of a script: NAME REST; REST also comes as words ("double quotes" keep blanks).
struct Command {
    int line = 0;
    QString name;
    QString rest;
    QStringList words;

    const QString& word(int index) const;  // CommandError when there are fewer words
    double number(int index) const;        // CommandError when it is not a number
    QSize size(int index) const;           // CommandError when it is not WIDTHxHEIGHT
    QString wordOr(int index, const QString& otherwise) const;
};

// `text` has no blanks around it.
Command parseLine(const QString& text);

// One command a line; skips empty lines and those that start with #. CommandError if unreadable.
QVector<Command> readScript(const QString& file_name);

// CommandError if it fails.
void writeFile(const QString& file_name, const QByteArray& content);

// Ends the run with exit code 3, line and reason.
struct CommandError : std::runtime_error {
    explicit CommandError(const QString& why) : std::runtime_error(why.toStdString()) {}
};

enum class Outcome {
    Done,
    Retry  // not yet: run the command again soon, until the time limit of a line is over
};

// Retry for up to five seconds, then CommandError.
Outcome retryAWhile(const Command& command, const QString& why);

enum class Place {
    MainWindow,  // refused while a modal box is in the way
    ModalBox,    // meant to be run while a modal box is up
    Everywhere   // answers modal boxes itself: no other command is run before it returns
};

class CommandTable {
public:
    using Handler = std::function<Outcome(const Command&)>;
    struct Entry {
        Handler handler;
        Place place;
    };

    void add(const QString& name, Handler handler, Place place = Place::MainWindow);
    // For commands that are done when they return.
    void addSimple(const QString& name, std::function<void(const Command&)> handler,
                   Place place = Place::MainWindow);

    const Entry& find(const QString& name) const;  // CommandError when there is none

private:
    std::map<QString, Entry> entries_;
};

// Each file of commands registers its own; README.md describes them.
void addWindowCommands(CommandTable& table);
void addActionCommands(CommandTable& table);
void addDialogCommands(CommandTable& table);
void addModalCommands(CommandTable& table);
void addDrawingCommands(CommandTable& table);
void addMouseCommands(CommandTable& table);
void addMemoryCommands(CommandTable& table);
void addProbeCommands(CommandTable& table);
void addWatchCommands(CommandTable& table);
void addFrameCommands(CommandTable& table);
CommandTable allCommands();

}  // namespace driver
