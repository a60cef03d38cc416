// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields.h"
#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTextDocument>
#include <QTextDocumentFragment>
#include <QTimer>
#include <QValidator>
#include "command_table.h"
#include "gui.h"

namespace driver {
namespace {

void collectWidgets(QLayoutItem* item, QList<QWidget*>& widgets) {
    if (!item) return;
    if (QWidget* widget = item->widget(); widget && !widgets.contains(widget)) widgets << widget;
    if (QLayout* layout = item->layout())
        for (int i = 0; i < layout->count(); ++i)
            collectWidgets(layout->itemAt(i), widgets);
}

QGridLayout* gridOf(QWidget* container, QWidget* label) {
    for (QGridLayout* grid : container->findChildren<QGridLayout*>())
        if (grid->indexOf(label) >= 0) return grid;
    return nullptr;
}

bool isLabel(QLayoutItem* item) {
    return item && qobject_cast<QLabel*>(item->widget());
}

// A label and its editors share a grid row, perhaps with another label.
QList<QWidget*> editorsBeside(QWidget* container, QLabel* label) {
    QList<QWidget*> editors;
    QGridLayout* grid = gridOf(container, label);
    if (!grid) return editors;
    int row, column, rowSpan, columnSpan;
    grid->getItemPosition(grid->indexOf(label), &row, &column, &rowSpan, &columnSpan);
    for (int c = column + columnSpan;
         c < grid->columnCount() && !isLabel(grid->itemAtPosition(row, c)); ++c)
        collectWidgets(grid->itemAtPosition(row, c), editors);
    return editors;
}

template <class Editor>
QList<Editor*> only(const QList<QWidget*>& widgets) {
    QList<Editor*> editors;
    for (QWidget* widget : widgets)
        if (auto* editor = qobject_cast<Editor*>(widget)) editors << editor;
    return editors;
}

double toNumber(const QString& text) {
    bool is_number = false;
    const double value = text.toDouble(&is_number);
    if (!is_number) throw CommandError(QString("'%1' is not a number").arg(text));
    return value;
}

void setCheckBox(QCheckBox* box, const QString& value) {
    if (value != "on" && value != "off")
        throw CommandError(QString("a check box takes on or off, not '%1'").arg(value));
    if (box->isChecked() != (value == "on")) box->click();
}

void setComboBox(QComboBox* box, const QString& value) {
    int index = box->findText(value);
    bool is_number = false;
    if (index < 0) index = value.toInt(&is_number);
    if ((index == 0 && !is_number && box->findText(value) < 0) || index < 0 ||
        index >= box->count()) {
        QStringList entries;
        for (int i = 0; i < box->count(); ++i)
            entries << "'" + box->itemText(i) + "'";
        throw CommandError(QString("no entry '%1' among %2").arg(value, entries.join(", ")));
    }
    box->setCurrentIndex(index);
    QMetaObject::invokeMethod(box, "activated", Q_ARG(int, index));  // as after a user's choice
}

void setLineEdit(QLineEdit* edit, const QString& value) {
    QString text = value;
    if (edit->validator() && !value.isEmpty()) {  // as Qt does when a user leaves the field
        int cursor = 0;
        if (edit->validator()->validate(text, cursor) != QValidator::Acceptable)
            edit->validator()->fixup(text);
    }
    edit->setText(text);
    QMetaObject::invokeMethod(edit, "editingFinished");
    QMetaObject::invokeMethod(edit, "returnPressed");
}

void setLineEdits(const QList<QLineEdit*>& edits, const QString& value) {
    if (edits.size() == 1) return setLineEdit(edits[0], value);
    const QStringList parts = value.split(' ', Qt::SkipEmptyParts);
    if (parts.size() != edits.size())
        throw CommandError(
            QString("the field takes %1 values, not '%2'").arg(edits.size()).arg(value));
    for (int i = 0; i < edits.size(); ++i)
        setLineEdit(edits[i], parts[i]);
}

// MeshLab's percentage field: absolute value, then percentage; each follows the other.
void setSpinBoxes(const QList<QDoubleSpinBox*>& boxes, QString value) {
    QDoubleSpinBox* box = boxes.first();
    if (value.endsWith('%')) {
        box = boxes.last();
        value.chop(1);
    }
    box->setValue(toNumber(value));
}

// The colour button opens a modal box: arm the answer, then click.
void setColour(QPushButton* button, const QString& value) {
    const QColor colour(value);
    if (!colour.isValid()) throw CommandError(QString("'%1' is not a colour").arg(value));
    QTimer::singleShot(0, button, [colour] {
        if (auto* box = qobject_cast<QColorDialog*>(QApplication::activeModalWidget())) {
            box->setCurrentColor(colour);
            box->accept();
        }
    });
    button->click();
}

// A point has a box for its source and a button that takes it from there.
bool getPoint(const QList<QWidget*>& editors, const QString& from) {
    const auto boxes = only<QComboBox>(editors);
    const auto buttons = only<QPushButton>(editors);
    if (boxes.isEmpty() || buttons.isEmpty() || boxes.first()->findText(from) < 0) return false;
    boxes.first()->setCurrentIndex(boxes.first()->findText(from));
    buttons.first()->click();
    return true;
}

bool setEditors(const QList<QWidget*>& editors, const QString& value) {
    if (const auto boxes = only<QCheckBox>(editors); !boxes.isEmpty())  // from 2022.02 on
        setCheckBox(boxes.first(), value);
    else if (const auto boxes = only<QComboBox>(editors);
             !boxes.isEmpty() && only<QLineEdit>(editors).isEmpty())
        setComboBox(boxes.first(), value);
    else if (getPoint(editors, value))
        return true;
    else if (const auto spins = only<QDoubleSpinBox>(editors); !spins.isEmpty())
        setSpinBoxes(spins, value);
    else if (const auto edits = only<QLineEdit>(editors); !edits.isEmpty())
        setLineEdits(edits, value);
    else if (const auto buttons = only<QPushButton>(editors); !buttons.isEmpty())
        setColour(buttons.first(), value);
    else
        return false;
    return true;
}

// Labels may have a heading above, in rich text.
QString lastLine(const QString& label) {
    if (!Qt::mightBeRichText(label)) return label;
    return QTextDocumentFragment::fromHtml(label).toPlainText().section('\n', -1);
}

QString nameOf(QLabel* label) {
    return withoutMnemonic(lastLine(label->text())).trimmed();
}

QStringList labelsOf(QWidget* container) {
    QStringList labels;
    for (QCheckBox* box : container->findChildren<QCheckBox*>())
        labels << "'" + box->text() + "'";
    for (QLabel* label : container->findChildren<QLabel*>())
        if (!editorsBeside(container, label).isEmpty()) labels << "'" + nameOf(label) + "'";
    return labels;
}

CommandError noField(QWidget* container, const QString& label) {
    return CommandError(
        QString("no field '%1' among %2").arg(label, labelsOf(container).join(", ")));
}

QList<QWidget*> findEditors(QWidget* container, const QString& label) {
    for (QCheckBox* box : container->findChildren<QCheckBox*>())
        if (withoutMnemonic(box->text()) == label) return {box};
    for (QLabel* candidate : container->findChildren<QLabel*>())
        if (nameOf(candidate) == label)
            if (const auto editors = editorsBeside(container, candidate); !editors.isEmpty())
                return editors;
    return {};
}

/// A panel that is due to be arranged may have it on.
bool isOff(const QWidget& editor) {
    if (!editor.isEnabled()) QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
    return !editor.isEnabled();
}

}  // namespace

void setField(QWidget* container, const QString& label, const QString& value) {
    const QList<QWidget*> editors = findEditors(container, label);
    if (!editors.isEmpty() && isOff(*editors.first()))
        throw CommandError(
            QString("the field '%1' is off: %2").arg(label, lastLine(editors.first()->toolTip())));
    if (!setEditors(editors, value)) throw noField(container, label);
}

QString textOfField(QWidget* container, const QString& label) {
    const QList<QWidget*> editors = findEditors(container, label);
    for (const QCheckBox* box : only<QCheckBox>(editors))
        return box->isChecked() ? "on" : "off";
    for (const QComboBox* box : only<QComboBox>(editors))
        return box->currentText();
    for (const QLineEdit* edit : only<QLineEdit>(editors))
        return edit->text();
    throw noField(container, label);
}

QString stateOfField(QWidget* container, const QString& label) {
    const QList<QWidget*> editors = findEditors(container, label);
    if (editors.isEmpty()) throw noField(container, label);
    if (!editors.first()->isVisible()) return "hidden";
    return editors.first()->isEnabled() ? "on" : "off";
}

void setFieldFromCommand(QWidget* container, const Command& command) {
    if (!command.rest.contains('=')) throw CommandError("say LABEL = VALUE");
    // Labels may contain '=', values do not.
    setField(container, command.rest.section('=', 0, -2).trimmed(),
             command.rest.section('=', -1).trimmed());
}

}  // namespace driver
