// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields.h"
#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTextDocument>
#include <QTextDocumentFragment>
#include <QTimer>
#include "gui.h"

namespace driver {
namespace {

using Widgets = QList<QWidget*>;

void collectWidgets(QLayoutItem* item, Widgets& widgets) {
    if (!item) return;
    if (QWidget* widget = item->widget(); widget && !widgets.contains(widget)) widgets << widget;
    if (QLayout* layout = item->layout())
        for (int i = 0; i < layout->count(); ++i)
            collectWidgets(layout->itemAt(i), widgets);
}

/// A label and its editors share a grid's row.
Widgets editorsBeside(QWidget* container, QLabel* label) {
    Widgets editors;
    for (QGridLayout* grid : container->findChildren<QGridLayout*>()) {
        if (grid->indexOf(label) < 0) continue;
        int row, column, row_span, column_span;
        grid->getItemPosition(grid->indexOf(label), &row, &column, &row_span, &column_span);
        for (int c = column + column_span; c < grid->columnCount(); ++c) {
            QLayoutItem* item = grid->itemAtPosition(row, c);
            if (item && qobject_cast<QLabel*>(item->widget())) break;  // of another field
            collectWidgets(item, editors);
        }
    }
    return editors;
}

/// Without the heading that may stand above it.
QString nameOf(const QLabel* label) {
    QString text = label->text();
    if (Qt::mightBeRichText(text))
        text = QTextDocumentFragment::fromHtml(text).toPlainText().section('\n', -1);
    return withoutMnemonic(text).trimmed();
}

Widgets findEditors(QWidget* container, const QString& name) {
    for (QCheckBox* box : container->findChildren<QCheckBox*>())  // up to 2020.09
        if (withoutMnemonic(box->text()) == name) return {box};
    QStringList others;
    for (QLabel* label : container->findChildren<QLabel*>()) {
        others << "'" + nameOf(label) + "'";
        if (nameOf(label) != name) continue;
        if (const Widgets editors = editorsBeside(container, label); !editors.isEmpty())
            return editors;
    }
    throw CommandError(QString("no field '%1' among %2").arg(name, others.join(", ")));
}

template <class Editor>
Editor* only(const Widgets& widgets) {
    for (QWidget* widget : widgets)
        if (auto* editor = qobject_cast<Editor*>(widget)) return editor;
    return nullptr;
}

void setCheckBox(QCheckBox* box, const QString& value) {
    if (value != "on" && value != "off")
        throw CommandError(QString("a check box takes on or off, not '%1'").arg(value));
    if (box->isChecked() != (value == "on")) box->click();
}

void setComboBox(QComboBox* box, const QString& value) {
    int index = box->findText(value);
    bool is_number = true;
    if (index < 0) index = value.toInt(&is_number);
    if (!is_number || index < 0 || index >= box->count()) {
        QStringList entries;
        for (int i = 0; i < box->count(); ++i)
            entries << "'" + box->itemText(i) + "'";
        throw CommandError(QString("no entry '%1' among %2").arg(value, entries.join(", ")));
    }
    box->setCurrentIndex(index);
    QMetaObject::invokeMethod(box, "activated", Q_ARG(int, index));  // as after a user's choice
}

void setLineEdit(QLineEdit* edit, const QString& value) {
    edit->setText(value);
    QMetaObject::invokeMethod(edit, "editingFinished");
    QMetaObject::invokeMethod(edit, "returnPressed");
}

// The button opens a modal box: arm the answer, then click.
void setColor(QPushButton* button, const QString& value) {
    const QColor color(value);
    if (!color.isValid()) throw CommandError(QString("'%1' is not a color").arg(value));
    QTimer::singleShot(0, button, [color] {
        if (auto* box = qobject_cast<QColorDialog*>(QApplication::activeModalWidget())) {
            box->setCurrentColor(color);
            box->accept();
        }
    });
    button->click();
}

}  // namespace

void setField(QWidget* container, const Command& command) {
    // Labels may contain '=', values do not.
    const QString name = command.rest.section('=', 0, -2).trimmed();
    const QString value = command.rest.section('=', -1).trimmed();
    const Widgets editors = findEditors(container, name);
    if (auto* check_box = only<QCheckBox>(editors))
        setCheckBox(check_box, value);
    else if (auto* combo_box = only<QComboBox>(editors))
        setComboBox(combo_box, value);
    else if (auto* edit = only<QLineEdit>(editors))
        setLineEdit(edit, value);
    else if (auto* button = only<QPushButton>(editors))
        setColor(button, value);
    else
        throw CommandError(QString("the field '%1' cannot be set").arg(name));
}

}  // namespace driver
