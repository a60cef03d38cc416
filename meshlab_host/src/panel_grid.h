// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/parameter_panel.h"

class QGridLayout;
class QLayoutItem;
class QWidget;

namespace meshlab_host {

/// A field of a panel, whose parts are in a grid: a label and, to its right, a widget or a layout
/// of several; or a check box with its text.
struct GridField {
    QGridLayout* grid = nullptr;  ///< null if there is no such field
    QLayoutItem* label = nullptr;
    QLayoutItem* editor = nullptr;  ///< null if the label is the check box itself
};

/// The field with this label in one of the grids of a panel.
GridField findField(const QWidget& panel, const QString& label);

/// Arranges the fields of a panel. False if it has not all of them.
bool arrangePanel(QWidget& panel, const std::vector<PanelLine>& lines);

}  // namespace meshlab_host
