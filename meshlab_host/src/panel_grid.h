// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/parameter_panel.h"

class QGridLayout;
class QLayoutItem;
class QWidget;

namespace meshlab_host {

/// The parts of a field in a grid: a label and, to its right, a widget or a layout of several; or a
/// check box with its text.
struct GridField {
    QGridLayout* grid = nullptr;  ///< null if there is no such field
    QLayoutItem* label = nullptr;
    QLayoutItem* editor = nullptr;  ///< null if the label is the check box itself
};

/// In one of the panel's grids.
GridField findField(const QWidget& panel, const QString& label);

/// False if fields are missing.
bool arrangePanel(QWidget& panel, const std::vector<PanelLine>& lines);

}  // namespace meshlab_host
