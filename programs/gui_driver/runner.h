// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QElapsedTimer>
#include <QObject>
#include "command_table.h"

class QWidget;

namespace driver {

// Runs the script's commands in MeshLab's event loop.
class Runner : public QObject {
    Q_OBJECT
public:
    Runner(QVector<Command> script, CommandTable table, QObject* parent);

private:
    void addOwnCommands();
    void checkNames() const;
    void scheduleStep(int milliseconds);
    void step();
    bool answers(QWidget* modal);
    void start(const Command& command);
    void sleep(const Command& command);
    void together(const Command& command);

    QVector<Command> script_;
    CommandTable table_;
    QElapsedTimer sleeping_;
    unsigned time_limit_ = 60;  // seconds
    // More than one when a command sits in a modal box's event loop.
    QVector<Command> in_progress_;
    int next_ = 0;
    int watched_line_ = 0;
};

}  // namespace driver
