// SPDX-License-Identifier: GPL-3.0-or-later
#include "user_actions.h"

#include "action_table.h"

namespace driver {
namespace {

std::vector<UserAction> allActions() {
    std::vector<UserAction> all = meshActions();
    all.insert(all.end(), viewActions().begin(), viewActions().end());
    return all;
}

const UserAction& byWeight(Dice& dice) {
    static const std::vector<UserAction> actions = allActions();
    int total = 0;
    for (const UserAction& action : actions)
        total += action.weight;
    int left = dice.below(total);
    for (const UserAction& action : actions)
        if ((left -= action.weight) < 0) return action;
    return actions.front();
}

}  // namespace

QStringList UserActions::next(const Situation& situation) {
    Table table{dice_, situation, meshes_, to_mend_};
    // little can be done without faces, without lines, or with lines that are refused
    QStringList lines;
    if (table.faces() == 0 && dice_.oneIn(3)) lines = leaveUselessLayer(table);
    if (table.faces() > 0 && !situation.has_lines && dice_.oneIn(3)) lines = toggleLines(table);
    if (!to_mend_.isEmpty() && dice_.oneIn(4)) lines = mendDecoration(table);
    while (lines.isEmpty())
        lines = byWeight(dice_).lines(table);
    return lines;
}

}  // namespace driver
