// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/filter_dialog.h"

#include <QApplication>
#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QVariant>
#include <algorithm>

#include "panel_grid.h"

namespace meshlab_host {
namespace {

constexpr int tight_spacing = 2;                    // pixels
const char* const old_dialog = "MeshlabStdDialog";  // of 2020.09
const char* const furnished_mark = "laplacian_lines_furnished";

template <class Editor>
Editor* editorIn(QLayoutItem* item) {
    if (!item) return nullptr;
    if (auto* editor = qobject_cast<Editor*>(item->widget())) return editor;
    if (QLayout* layout = item->layout())
        for (int i = 0; i < layout->count(); ++i)
            if (auto* editor = editorIn<Editor>(layout->itemAt(i))) return editor;
    return nullptr;
}

template <class Editor>
Editor* editorOf(const QWidget& frame, const QString& label) {
    const GridField field = findField(frame, label);
    return editorIn<Editor>(field.editor ? field.editor : field.label);
}

bool isOld(const QWidget& dialog) {
    return dialog.inherits(old_dialog);
}

bool isDialog(const QWidget& widget) {
    return isOld(widget) || widget.inherits("FilterDockDialog");
}

QWidget* dialogOf(QWidget* frame) {
    while (!isDialog(*frame))
        frame = frame->parentWidget();
    return frame;
}

/// Leaves room for frame and bars on screens of 768 pixels; fields beyond are scrolled to.
constexpr int most_height = 680;

void growBy(QWidget& dialog, int height) {
    const int wanted = std::min(dialog.height() + height, most_height);
    dialog.resize(dialog.width(),
                  isOld(dialog) ? dialog.height() + height : std::max(dialog.height(), wanted));
}

}  // namespace

QWidget* FilterDialog::find(const QString& filter) {
    for (QWidget* dialog : QApplication::allWidgets()) {
        if (!isDialog(*dialog)) continue;
        if (!dialog->isVisible() || dialog->windowTitle() != filter) continue;
        for (QWidget* child : dialog->findChildren<QWidget*>())
            if (child->inherits("RichParameterListFrame")) return child;
    }
    return nullptr;
}

bool FilterDialog::isOpen(const QString& filter) {
    return qobject_cast<QApplication*>(QCoreApplication::instance()) && find(filter);
}

void FilterDialog::whenOpen(const QString& filter, std::function<void(FilterDialog)> furnish) {
    if (!qobject_cast<QApplication*>(QCoreApplication::instance())) return;
    const auto look = [filter, furnish = std::move(furnish)] {
        QWidget* frame = find(filter);
        if (!frame || !frame->layout() || frame->property(furnished_mark).toBool()) return;
        frame->setProperty(furnished_mark, true);
        furnish(FilterDialog(frame));
    };
    QMetaObject::invokeMethod(qApp, look, Qt::QueuedConnection);
}

std::optional<QString> FilterDialog::text(const QString& label) const {
    if (const auto* edit = editorOf<QLineEdit>(*frame_, label)) return edit->text();
    if (const auto* list = editorOf<QComboBox>(*frame_, label)) return list->currentText();
    if (const auto* box = editorOf<QCheckBox>(*frame_, label))
        return box->isChecked() ? "on" : "off";
    return std::nullopt;
}

void FilterDialog::setText(const QString& label, const QString& text) {
    if (auto* edit = editorOf<QLineEdit>(*frame_, label))
        edit->setText(text);
    else if (auto* list = editorOf<QComboBox>(*frame_, label))
        list->setCurrentIndex(list->findText(text) < 0 ? list->currentIndex()
                                                       : list->findText(text));
    else if (auto* box = editorOf<QCheckBox>(*frame_, label))
        box->setChecked(text == "on");
}

void FilterDialog::whenChanged(const QObject* receiver, const std::function<void()>& changed) {
    for (QLineEdit* edit : frame_->findChildren<QLineEdit*>())
        QObject::connect(edit, &QLineEdit::textChanged, receiver, changed);
    for (QComboBox* list : frame_->findChildren<QComboBox*>())
        QObject::connect(list, qOverload<int>(&QComboBox::currentIndexChanged), receiver, changed);
    for (QCheckBox* box : frame_->findChildren<QCheckBox*>())
        QObject::connect(box, &QCheckBox::toggled, receiver, changed);
}

bool FilterDialog::addBelow(const QString& label, QWidget* widget) {
    return addTo(label, widget, true);
}

bool FilterDialog::addBeside(const QString& label, QWidget* widget) {
    return addTo(label, widget, false);
}

bool FilterDialog::addTo(const QString& label, QWidget* widget, bool below) {
    const GridField field = findField(*frame_, label);
    if (!field.editor) return false;
    int row, column, rows, columns;
    const int index = field.grid->indexOf(field.editor->widget()) >= 0
                          ? field.grid->indexOf(field.editor->widget())
                          : field.grid->indexOf(field.editor->layout());
    field.grid->getItemPosition(index, &row, &column, &rows, &columns);
    field.grid->takeAt(index);
    auto* both = new QBoxLayout(below ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    both->setSpacing(tight_spacing);
    field.grid->addLayout(both, row, column, rows, columns);
    if (QLayout* layout = field.editor->layout())
        both->addLayout(layout);
    else
        both->addItem(field.editor);
    both->addWidget(widget);
    fit();
    return true;
}

void FilterDialog::addLine(QWidget* widget) {
    auto* grid = qobject_cast<QGridLayout*>(frame_->layout());
    if (!grid) return;
    constexpr int label_and_editor = 2;
    grid->addWidget(widget, grid->rowCount(), 0, 1, label_and_editor);
    fit();
}

void FilterDialog::tighten() {
    for (QGridLayout* grid : frame_->findChildren<QGridLayout*>())
        grid->setVerticalSpacing(tight_spacing);
    fit();
}

void FilterDialog::fit() {
    QLayout* layout = frame_->layout();
    layout->activate();
    const int grown = layout->sizeHint().height() - frame_->minimumHeight();
    frame_->setMinimumSize(layout->sizeHint());
    QWidget* dialog = dialogOf(frame_);
    if (!isOld(*dialog)) return growBy(*dialog, grown);
    for (QWidget* around = frame_; around != dialog; around = around->parentWidget()) {
        if (around->layout()) around->layout()->activate();
        around->adjustSize();
    }
    dialog->setMinimumSize(frame_->parentWidget()->sizeHint());
    dialog->adjustSize();
    growBy(*dialog, missingHeight());
}

/// MeshLab expects fewer lines of description than there are.
int FilterDialog::missingHeight() const {
    const QWidget* content = frame_->parentWidget();
    if (!content->layout() || !content->layout()->hasHeightForWidth()) return 0;
    return std::max(0, content->layout()->heightForWidth(content->width()) - content->height());
}

}  // namespace meshlab_host
