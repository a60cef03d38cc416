// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_choices.h"

#include "line_drawing/sheet_file.h"
#include "line_drawing/words.h"

namespace line_drawing {
namespace {

using laplacian_lines::OptionKind;

[[noreturn]] void refuseWord(const SheetOption& option, const QString& word,
                             const QString& allowed) {
    laplacian_lines::refuse_value(option.command().toStdString(),
                                  QString("\"%1\"").arg(word).toStdString(), allowed.toStdString());
}

laplacian_lines::LineKindSet kindsIn(const QString& names) {
    if (const auto kinds = laplacian_lines::kinds_named(names.toStdString())) return *kinds;
    refuse(QString("--kinds is \"%1\". It has to be some of %2, with commas between.")
               .arg(names, QString::fromStdString(laplacian_lines::names_of_kinds())));
}

/// Lines of at most `width` characters, each with `indent` blanks before it but the first.
QString wrapped(const QString& text, int indent, int width) {
    QString result;
    int column = indent;
    for (const QString& word : text.split(' ')) {
        if (column > indent && column + 1 + word.size() > width) {
            result += '\n' + QString(indent, ' ');
            column = indent;
        } else if (column > indent) {
            result += ' ';
            ++column;
        }
        result += word;
        column += word.size();
    }
    return result;
}

}  // namespace

QString SheetOption::command() const {
    return QString("--") + (command_word ? command_word : row.key);
}

QStringList SheetOption::words() const {
    QStringList result;
    for (const char* word : switch_words)
        result << word;
    for (const char* label : row.choices)
        result << QString(label).section(' ', 0, 0).toLower();
    return result;
}

QString SheetOption::valueIn(const SheetChoices& choices) const {
    if (text) return choices.*text;
    const double value = row.get(choices);
    return words().value(int(value), QString::number(value));
}

void SheetOption::read(const QString& word, SheetChoices& choices) const {
    if (text) {
        choices.*text = adds_up ? choices.*text + ' ' + word : word;
        return;
    }
    if (const QStringList known = words(); !known.isEmpty()) {
        const int number = known.indexOf(word.toLower());
        if (number < 0) refuseWord(*this, word, "one of " + known.join(", "));
        return row.set(choices, number);
    }
    bool is_number = false;
    const double value = word.toDouble(&is_number);
    if (!is_number || !(value >= row.minimum && value <= row.maximum))
        refuseWord(*this, word, QString::fromStdString(laplacian_lines::allowed_values(row)));
    row.set(choices, value);
}

QString sheetOptionsHelp() {
    constexpr int column = 23, width = 90;
    QString help;
    for (const SheetOption& option : sheetOptionTable()) {
        if (!option.isOf(SheetOption::Place::Command)) continue;
        const QString form = option.words().isEmpty() ? option.form : option.words().join('|');
        const QString head = QString("  %1 %2").arg(option.command(), form);
        const QString usual = option.valueIn({});
        const QString text =
            usual.isEmpty() ? option.row.help : QString("%1 (%2)").arg(option.row.help, usual);
        help +=
            head.size() < column ? head.leftJustified(column) : head + '\n' + QString(column, ' ');
        help += wrapped(text, column, width) + '\n';
    }
    return help;
}

SheetOptions sheetOptions(const SheetChoices& chosen, const NamedViews& others) {
    SheetOptions options;
    static_cast<SheetLook&>(options) = chosen.look;
    options.sections = parseSections(chosen.sections);
    if (!chosen.views.trimmed().isEmpty() || options.sections.empty())
        options.views = parseViews(chosen.views, chosen.look.up, others);
    options.scale = parseScale(chosen.scale);
    const std::vector<const char*> papers = paperNames();
    const auto paper = std::size_t(chosen.paper);
    options.paper = paper < papers.size() ? papers[paper] : "fit";
    options.mm_per_unit = mesh_units[chosen.unit].mm;
    options.strokes = strokesIn(chosen.file, chosen.look.strokes);
    options.title = chosen.title;
    options.pens = pensOf(chosen.weights);
    options.kernel = parseDetailSize(chosen.kernel);
    options.smoothing = parseDetailSize(chosen.smoothing);
    options.style.shows = kindsIn(chosen.kinds);
    options.has_view_names = options.has_scale_bar = options.has_notes = chosen.has_furniture;
    return options;
}

}  // namespace line_drawing
