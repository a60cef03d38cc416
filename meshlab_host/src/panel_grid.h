// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/parameter_panel.h"

class QWidget;

namespace meshlab_host {

/// Arranges the fields of a panel, whose parts are in a grid: a label and, to its right, a widget
/// or a layout of several; or a check box with its text. False if it has not all of the fields.
bool arrangePanel(QWidget& panel, const std::vector<PanelLine>& lines);

}  // namespace meshlab_host
