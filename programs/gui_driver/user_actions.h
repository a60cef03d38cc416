// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <random>

#include "situation.h"

namespace driver {

/// Random choices that are the same for a seed with every compiler and library.
class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}

    int below(int end) { return int(engine_() % unsigned(end)); }
    bool oneIn(int n) { return below(n) == 0; }
    /// With three digits behind the point.
    double between(double from, double to) { return from + (to - from) * below(1001) / 1000; }
    template <class List>
    typename List::value_type from(const List& list) {
        return *(list.begin() + below(int(list.size())));
    }

private:
    std::mt19937 engine_;
};

/// What a user may do next, at random.
class UserActions {
public:
    /// `meshes`: files that can be opened; beside them there has to be a project, scene.mlp
    UserActions(unsigned seed, QStringList meshes) : dice_(seed), meshes_(std::move(meshes)) {}

    /// As lines of a driver's script.
    QStringList next(const Situation& now);

private:
    QStringList linesOf(const char* action, const Situation& now);
    QString expand(QString text, const Situation& now);
    QString valueOf(const QString& name, const Situation& now);

    Dice dice_;
    const QStringList meshes_;
    QStringList to_mend_;  ///< lines that give changed parameters their usual values
    int chosen_view_ = 0;  ///< of the action at hand
};

}  // namespace driver
