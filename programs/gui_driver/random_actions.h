// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "command_table.h"
#include "drawing_watch.h"
#include "gui.h"
#include "user_actions.h"

namespace driver {

/// Random user actions; checks after each that the view shows what it has to. The lines it says,
/// without their beginnings, are a script that repeats the run.
class RandomActions {
public:
    using Announce = std::function<void(const QString& line)>;

    /// `announce` gets each line first.
    RandomActions(unsigned seed, int count, const QStringList& meshes, const CommandTable& table,
                  Announce announce);

    /// One line. False at the end. CommandError if something is wrong.
    bool step();

private:
    void run(const QString& line);
    void check();
    /// Empty if nothing is.
    QString whatIsMissing(const std::map<int, QString>& drawn) const;
    void conclude() const;

    UserActions actions_;
    const CommandTable& table_;
    const Announce announce_;
    BoxAnswerer boxes_;
    DrawingWatch watch_;
    QStringList pending_;  ///< lines of the action that is going on
    Situation now_;        ///< when the view was looked at last
    int left_;
    int checks_left_;  ///< until the view of the action that is over has to show its lines
    int lines_ = 0, impossible_ = 0;
    struct Tries {
        int all = 0, failed = 0;
    };
    std::map<QString, Tries> tries_;
};

}  // namespace driver
