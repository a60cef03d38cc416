// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "dice.h"
#include "situation.h"

namespace driver {

/// What a user may do next, at random.
class UserActions {
public:
    /// `meshes`: files that can be opened; beside them there has to be a project, scene.mlp
    UserActions(unsigned seed, QStringList meshes) : dice_(seed), meshes_(std::move(meshes)) {}

    /// As lines of a driver's script.
    QStringList next(const Situation& situation);

private:
    Dice dice_;
    const QStringList meshes_;
    QStringList to_mend_;
};

}  // namespace driver
