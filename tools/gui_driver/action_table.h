// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <vector>

#include "dice.h"
#include "situation.h"

namespace driver {

// More would show nothing else, only slower.
constexpr std::size_t most_layers = 4;
constexpr int most_views = 3, most_documents = 3, most_faces = 4000;

/// What an action is chosen by.
struct Table {
    Dice& dice;
    const Situation& now;
    const QStringList& meshes;
    QStringList& to_mend;  // settings that were changed, as they were

    QString onOrOff() { return dice.oneIn(2) ? " on" : " off"; }
    QString number(double from, double to) { return QString::number(dice.between(from, to)); }
    bool hasMesh() const { return now.current; }
    int faces() const { return now.current ? now.current->cm.fn : 0; }
    QString someLayer() { return QString::number(dice.from(now.layers)->id()); }

    QStringList filter(const QString& name, const QStringList& settings = {}) {
        QStringList lines{"trigger " + name};
        for (const QString& setting : settings)
            lines << "set " + setting;
        lines << "apply";
        if (dice.oneIn(4)) lines << "apply";
        if (!dice.oneIn(6)) lines << "close";  // dialogs may stay open
        return lines;
    }
};

/// Something that users do.
struct UserAction {
    int weight;                    ///< how often
    QStringList (*lines)(Table&);  ///< of a driver's script; none if it is impossible now
};

const std::vector<UserAction>& meshActions();  ///< of the current layer
const std::vector<UserAction>& viewActions();  ///< layers, views, cameras, documents

QStringList toggleLines(Table& t);
QStringList mendDecoration(Table& t);
QStringList openMesh(Table& t);
QStringList leaveUselessLayer(Table& t);

}  // namespace driver
