// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/parameter_panel.h"

#include <QApplication>
#include <QChildEvent>
#include <QTreeWidget>
#include <tuple>

#include "panel_grid.h"

namespace meshlab_host {
namespace {

/// The part of the layer dialog that holds the panels of all decorations, one an item.
QTreeWidget* findTree() {
    for (QWidget* window : QApplication::topLevelWidgets())
        if (auto* tree = window->findChild<QTreeWidget*>("decParsTree")) return tree;
    return nullptr;
}

}  // namespace

bool PanelField::operator==(const PanelField& other) const {
    return std::tie(label, help, is_shown, obstacle, fault) ==
           std::tie(other.label, other.help, other.is_shown, other.obstacle, other.fault);
}

void ParameterPanel::arrange(std::vector<PanelLine> lines) {
    if (lines == lines_) return;
    lines_ = std::move(lines);
    arrangeSoon();
}

bool ParameterPanel::eventFilter(QObject* receiver, QEvent* event) {
    if (event->type() == QEvent::ChildAdded) arrangeSoon();
    return QObject::eventFilter(receiver, event);
}

void ParameterPanel::arrangeSoon() {
    if (is_due_) return;
    is_due_ = true;
    QMetaObject::invokeMethod(
        this, [this] { arrangeAll(); }, Qt::QueuedConnection);
}

void ParameterPanel::arrangeAll() {
    is_due_ = false;
    if (!tree_) {
        tree_ = findTree();
        if (!tree_) return;
        tree_->viewport()->installEventFilter(this);
    }
    bool is_changed = false;
    for (QTreeWidgetItem* item : tree_->findItems(decoration_, Qt::MatchExactly)) {
        QWidget* panel = item->childCount() ? tree_->itemWidget(item->child(0), 0) : nullptr;
        if (panel && arrangePanel(*panel, lines_)) is_changed = true;
    }
    if (is_changed) tree_->doItemsLayout();
}

}  // namespace meshlab_host
