// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "dice.h"

namespace driver {

/// LABEL = VALUE for the layer dialog, and for the dialogs of the filters: values of all ranges,
/// also extreme and illegal ones.
struct DecorationSetting {
    QString random, usual;  ///< of the same parameter
};
DecorationSetting randomDecorationSetting(Dice& dice);
QStringList randomComputeSettings(Dice& dice);
QStringList randomPolylineSettings(Dice& dice);

}  // namespace driver
