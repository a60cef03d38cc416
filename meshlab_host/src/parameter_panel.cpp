// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/parameter_panel.h"

#include <QApplication>
#include <QBoxLayout>
#include <QChildEvent>
#include <QGroupBox>
#include <QPlainTextEdit>
#include <QTreeWidget>
#include <tuple>

#include "panel_grid.h"

namespace meshlab_host {
namespace {

/// Holds the panels of all decorations, one an item.
QTreeWidget* findTree() {
    for (QWidget* window : QApplication::topLevelWidgets())
        if (auto* tree = window->findChild<QTreeWidget*>("decParsTree")) return tree;
    return nullptr;
}

/// At least this high, plus `stretch` parts of what is left, whatever its size hint.
void setHeight(QWidget& widget, int least, int stretch) {
    QSizePolicy policy = widget.sizePolicy();
    policy.setVerticalPolicy(QSizePolicy::Ignored);
    policy.setVerticalStretch(stretch);
    widget.setSizePolicy(policy);
    widget.setMinimumHeight(least);
}

void stretchLayoutOf(QWidget& widget, int stretch) {
    for (QBoxLayout* box : widget.parentWidget()->findChildren<QBoxLayout*>())
        for (int i = 0; i < box->count(); ++i)
            if (QLayout* inner = box->itemAt(i)->layout())
                if (inner->indexOf(&widget) >= 0) box->setStretch(i, stretch);
}

/// MeshLab's lists of layers and panels insist on their size hints, so the window outgrows small
/// screens. Here panels come first, and all can be low.
void fitIntoDialog(QTreeWidget& panels) {
    QWidget* const dialog = panels.parentWidget();
    if (!dialog) return;
    const int line = panels.fontMetrics().lineSpacing();
    panels.setMinimumHeight(4 * line);  // MeshLab sets its size policy again and again
    stretchLayoutOf(panels, panels.topLevelItemCount() ? 4 : 0);
    for (QGroupBox* box : dialog->findChildren<QGroupBox*>(QString(), Qt::FindDirectChildrenOnly))
        setHeight(*box, box->minimumSizeHint().height(), 0);
    if (auto* layers = dialog->findChild<QTreeWidget*>("meshTreeWidget"))
        setHeight(*layers, 3 * line, 1);
    if (auto* log = dialog->findChild<QPlainTextEdit*>("logPlainTextEdit"))
        setHeight(*log, 2 * line, 1);
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
    if (event->type() == QEvent::ChildAdded || event->type() == QEvent::ChildRemoved) arrangeSoon();
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
    fitIntoDialog(*tree_);
}

}  // namespace meshlab_host
