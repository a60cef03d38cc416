// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel_grid.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPalette>
#include <QValidator>
#include <QVariant>

namespace meshlab_host {
namespace {

bool isNumber(const QString& text) {
    bool is_number = false;
    text.toDouble(&is_number);
    return is_number;
}

/// MeshLab reads as 0 what is not a number: when a field is left, a decimal comma becomes a point,
/// a unit goes, and other text becomes "nan", which is refused wherever it is read.
class NumberValidator : public QValidator {
public:
    using QValidator::QValidator;

    State validate(QString& text, int&) const override {
        return isNumber(text) ? Acceptable : Intermediate;
    }
    void fixup(QString& text) const override {
        QString number = text.trimmed();
        if (number.endsWith('%') || number.endsWith(QChar(0xb0))) number.chop(1);  // or degrees
        if (number.count(',') == 1 && !number.contains('.')) number.replace(',', '.');
        text = isNumber(number) ? number : "nan";
    }
};

/// Lets the wheel scroll the panel instead of choosing something else in a box on its way.
class WheelPassesBy : public QObject {
public:
    bool eventFilter(QObject* receiver, QEvent* event) override {
        if (event->type() != QEvent::Wheel) return QObject::eventFilter(receiver, event);
        event->ignore();
        return true;
    }
};

constexpr int columns = 4;       ///< two fields side by side, each a label and what it names
constexpr int line_spacing = 0;  ///< pixels: the panel is low on small screens
constexpr int longest_short_label = 15;  ///< characters
const char* const arranged_mark = "laplacian_lines_arranged";
const char* const wrong_mark = "laplacian_lines_wrong";

QString textOf(QLayoutItem& item) {
    if (const auto* box = qobject_cast<QCheckBox*>(item.widget())) return box->text();
    if (const auto* label = qobject_cast<QLabel*>(item.widget())) return label->text();
    return {};
}

GridField findIn(QGridLayout& grid, const QString& label) {
    for (int i = 0; i < grid.count(); ++i) {
        QLayoutItem* item = grid.itemAt(i);
        if (textOf(*item) != label) continue;
        if (qobject_cast<QCheckBox*>(item->widget())) return {&grid, item, nullptr};
        int row, column, rows, spanned;
        grid.getItemPosition(i, &row, &column, &rows, &spanned);
        if (QLayoutItem* editor = grid.itemAtPosition(row, column + spanned))
            return {&grid, item, editor};
    }
    return {};
}

std::vector<std::vector<GridField>> findAll(QGridLayout& grid,
                                            const std::vector<PanelLine>& lines) {
    std::vector<std::vector<GridField>> found;
    for (const PanelLine& line : lines) {
        found.emplace_back();
        for (const PanelField& field : line) {
            found.back().push_back(findIn(grid, field.label));
            if (!found.back().back().label) return {};
        }
    }
    return found;
}

void move(QGridLayout& grid, QLayoutItem* item, int row, int column, int spanned) {
    const Qt::Alignment alignment = item->alignment();
    grid.takeAt(grid.indexOf(item));
    if (QLayout* layout = item->layout())
        grid.addLayout(layout, row, column, 1, spanned, alignment);
    else
        grid.addItem(item, row, column, 1, spanned, alignment);
}

/// What MeshLab hides beside the fields makes room.
void moveHelpAside(QGridLayout& grid) {
    for (int i = grid.count() - 1; i >= 0; --i) {
        int row, column, rows, spanned;
        grid.getItemPosition(i, &row, &column, &rows, &spanned);
        if (column == columns / 2) move(grid, grid.itemAt(i), row, columns, 1);
    }
}

/// Columns of `width` that a label takes: long ones would widen the column of short ones.
int labelColumns(QLayoutItem& label, int width) {
    return textOf(label).size() <= longest_short_label ? 1 : width / 2;
}

void moveAll(QGridLayout& grid, const std::vector<std::vector<GridField>>& found) {
    moveHelpAside(grid);
    for (int line = 0; line < int(found.size()); ++line) {
        const auto& fields = found[std::size_t(line)];
        const int width = columns / int(fields.size());
        for (int i = 0; i < int(fields.size()); ++i) {
            const GridField& parts = fields[std::size_t(i)];
            const int label = parts.editor ? labelColumns(*parts.label, width) : width;
            move(grid, parts.label, line, i * width, label);
            if (parts.editor) move(grid, parts.editor, line, i * width + label, width - label);
        }
    }
    for (int column = 1; column < columns; column += 2)
        grid.setColumnStretch(column, 1);
    grid.setVerticalSpacing(line_spacing);
}

/// Red text if wrong. Others keep their palette, which shows colors.
void mark(QWidget& widget, bool is_wrong) {
    if (widget.property(wrong_mark).toBool() == is_wrong) return;
    widget.setProperty(wrong_mark, is_wrong);
    QPalette palette;
    if (is_wrong)
        for (const auto role : {QPalette::WindowText, QPalette::Text})
            palette.setColor(role, Qt::red);
    widget.setPalette(palette);
}

void show(QLayoutItem* item, const PanelField& field, const QString& tool_tip) {
    if (!item) return;
    if (QWidget* widget = item->widget()) {
        widget->setVisible(field.is_shown);
        widget->setEnabled(field.obstacle.isEmpty());
        widget->setToolTip(tool_tip);
        mark(*widget, !field.fault.isEmpty());
        auto* text = qobject_cast<QLineEdit*>(widget);
        if (text && !text->validator()) text->setValidator(new NumberValidator(text));
        static WheelPassesBy wheel_passes_by;
        if (qobject_cast<QComboBox*>(widget)) widget->installEventFilter(&wheel_passes_by);
    }
    if (QLayout* layout = item->layout())
        for (int i = 0; i < layout->count(); ++i)
            show(layout->itemAt(i), field, tool_tip);
}

void showAll(const std::vector<std::vector<GridField>>& found,
             const std::vector<PanelLine>& lines) {
    for (std::size_t line = 0; line < lines.size(); ++line)
        for (std::size_t i = 0; i < lines[line].size(); ++i) {
            const PanelField& field = lines[line][i];
            const QString remark = field.fault.isEmpty() ? field.obstacle : field.fault;
            const QString tool_tip = remark.isEmpty()
                                         ? field.help
                                         : "<b>" + remark.toHtmlEscaped() + "</b> " + field.help;
            show(found[line][i].label, field, tool_tip);
            show(found[line][i].editor, field, tool_tip);
        }
}

}  // namespace

GridField findField(const QWidget& panel, const QString& label) {
    for (QGridLayout* grid : panel.findChildren<QGridLayout*>())
        if (const GridField field = findIn(*grid, label); field.grid) return field;
    return {};
}

bool arrangePanel(QWidget& panel, const std::vector<PanelLine>& lines) {
    for (QGridLayout* grid : panel.findChildren<QGridLayout*>()) {
        const auto found = findAll(*grid, lines);
        if (found.empty()) continue;
        if (!grid->property(arranged_mark).toBool()) moveAll(*grid, found);
        grid->setProperty(arranged_mark, true);
        showAll(found, lines);
        grid->activate();
        if (panel.layout()) panel.layout()->activate();
        return true;
    }
    return false;
}

}  // namespace meshlab_host
