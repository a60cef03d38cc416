// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <memory>
#include "command_table.h"
#include "process.h"
#include "random_actions.h"

namespace driver {

// Runs the script's commands in MeshLab's event loop.
class Runner : public QObject {
    Q_OBJECT
public:
    Runner(QVector<Command> script, CommandTable table, QObject* parent);

private:
    void step();
    bool mayStart(const CommandTable::Entry& entry);
    void run(const Command& command, const CommandTable::Entry& entry);
    void scheduleStep(int milliseconds);
    void watch(const Command& command);
    void addOwnCommands();
    void checkNames() const;
    Outcome sleep(const Command& command);
    void together(const Command& command);
    void time(const Command& command);
    Outcome randomActions(const Command& command);

    QVector<Command> script_;
    CommandTable table_;
    Watchdog watchdog_;
    QElapsedTimer sleeping_;
    std::unique_ptr<RandomActions> random_;
    QStringList
        in_progress_;  // commands: more than one when a command sits in a modal box's event loop
    int next_ = 0;
    int watched_line_ = 0;
};

}  // namespace driver
