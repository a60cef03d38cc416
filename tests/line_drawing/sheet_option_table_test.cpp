// SPDX-License-Identifier: GPL-3.0-or-later
// The table of options of measured drawings, and what follows from it or is written by hand beside
// it.
#include <gtest/gtest.h>

#include <QFile>
#include <set>

#include "laplacian_lines/error.h"
#include "line_drawing/sheet_choices.h"
#include "places.h"

using namespace line_drawing;

namespace {

using Place = SheetOption::Place;

QString content(const char* file) {
    QFile input(QString::fromStdString((places::repository() / file).string()));
    EXPECT_TRUE(input.open(QIODevice::ReadOnly)) << file;
    return QString::fromUtf8(input.readAll());
}

/// A line that begins so; empty if there is none.
QString lineWith(const QString& begin, const QString& text) {
    for (const QString& line : text.split('\n'))
        if (line.trimmed().startsWith(begin)) return line.trimmed();
    return {};
}

std::vector<SheetOption> optionsOf(Place place) {
    std::vector<SheetOption> options;
    for (const SheetOption& option : sheetOptionTable())
        if (option.isOf(place)) options.push_back(option);
    return options;
}

QString complaint(const SheetOption& option, const QString& word) {
    SheetChoices choices;
    try {
        option.read(word, choices);
    } catch (const laplacian_lines::Error& error) {
        return QString::fromUtf8(error.what());
    }
    return {};
}

TEST(SheetOptions, HaveNamesOfTheirOwn) {
    std::set<QString> keys, labels, commands;
    for (const SheetOption& option : sheetOptionTable()) {
        EXPECT_TRUE(keys.insert(option.row.key).second) << option.row.key;
        EXPECT_TRUE(labels.insert(option.row.label).second) << option.row.label;
        EXPECT_TRUE(commands.insert(option.command()).second) << option.row.key;
        EXPECT_TRUE(QString(option.row.help).endsWith('.')) << option.row.key;
        EXPECT_EQ(option.text != nullptr, option.row.get == nullptr) << option.row.key;
    }
}

TEST(SheetOptions, AreReadAsTheyAreWritten) {
    for (const SheetOption& option : optionsOf(Place::Command))
        for (const QString& word : option.words()) {
            SheetChoices choices;
            option.read(word.toUpper(), choices);
            EXPECT_EQ(option.valueIn(choices), word) << option.row.key;
            for (const SheetOption& other : optionsOf(Place::Command))
                if (other.row.key != QString(option.row.key)) {
                    EXPECT_EQ(other.valueIn(choices), other.valueIn({})) << option.row.key;
                }
        }
}

TEST(SheetOptions, RefuseWhatIsNotAllowedAndSayWhatIs) {
    for (const SheetOption& option : optionsOf(Place::Command))
        if (!option.words().isEmpty()) {
            EXPECT_EQ(complaint(option, "sideways"),
                      QString("%1 is \"sideways\". It has to be one of %2.")
                          .arg(option.command(), option.words().join(", ")))
                << option.row.key;
        }
}

/// The defaults are what a sheet has by itself.
TEST(SheetOptions, AreThoseOfASheetByDefault) {
    const SheetOptions read = sheetOptions({}), made;
    EXPECT_EQ(read.paper, made.paper);
    EXPECT_EQ(read.mm_per_unit, made.mm_per_unit);
    EXPECT_EQ(read.scale, made.scale);
    EXPECT_EQ(read.pens, made.pens);
    EXPECT_EQ(read.kernel.size, made.kernel.size);
    EXPECT_EQ(read.smoothing.size, made.smoothing.size);
    EXPECT_TRUE(read.style.shows == made.style.shows);
    EXPECT_EQ(read.has_notes, made.has_notes);
}

TEST(SheetOptions, AreInTheHelpWithValuesAndDefault) {
    const QString help = sheetOptionsHelp();
    for (const QString& line : help.split('\n'))
        EXPECT_LE(line.size(), 100) << line.toStdString();
    EXPECT_TRUE(help.contains("  --wall hatched|filled|none\n")) << help.toStdString();
    EXPECT_TRUE(help.contains("outline alone. (hatched)\n"));
    EXPECT_FALSE(help.contains("--layers"));
}

TEST(SheetOptions, OfTheCommandAreDocumented) {
    const QString document = content("docs/drawing_sheets.md");
    for (const SheetOption& option : optionsOf(Place::Command)) {
        const QString line = lineWith(QString("| `%1` |").arg(option.command()), document);
        const QString usual = option.valueIn({});
        EXPECT_TRUE(line.contains(QString("| %1 |").arg(usual.isEmpty() ? "none" : usual)))
            << option.row.key << ": " << usual.toStdString();
        const QString words = option.words().join(", ");
        EXPECT_TRUE(line.contains("| " + words)) << option.row.key << ": " << words.toStdString();
    }
}

TEST(SheetOptions, OfTheFilterAreDocumented) {
    const QString document = content("docs/parameters.md").section("## Export", 1);
    for (const SheetOption& option : optionsOf(Place::Filter)) {
        const QString begin = QString("| %1 | `%2` |").arg(option.row.label, option.row.key);
        const QString line = lineWith(begin, document);
        const QString usual = option.valueIn({});
        EXPECT_FALSE(line.isEmpty()) << begin.toStdString();
        if (option.row.kind == laplacian_lines::OptionKind::Boolean) continue;
        EXPECT_TRUE(line.contains(usual, Qt::CaseInsensitive))
            << option.row.key << ": " << usual.toStdString();
    }
}

/// As MeshLab writes the parameter.
QString inScript(const SheetOption& option) {
    const SheetOption::Row& row = option.row;
    const QString begin = QString("<Param name=\"%1\" type=\"").arg(row.key);
    if (option.text) return begin + QString("RichString\" value=\"%1\"/>").arg(option.valueIn({}));
    const double value = row.get({});
    if (row.kind == laplacian_lines::OptionKind::Boolean)
        return begin + QString("RichBool\" value=\"%1\"/>").arg(value != 0 ? "true" : "false");
    QString choices;
    for (std::size_t i = 0; i < row.choices.size(); ++i)
        choices += QString(" enum_val%1=\"%2\"").arg(i).arg(row.choices[i]);
    return begin + QString("RichEnum\" value=\"%1\" enum_cardinality=\"%2\"%3/>")
                       .arg(value)
                       .arg(row.choices.size())
                       .arg(choices);
}

TEST(SheetOptions, OfTheFilterAreInTheExample) {
    const QString example = content("docs/examples/laplacian_lines_drawing.mlx");
    for (const SheetOption& option : optionsOf(Place::Filter))
        EXPECT_TRUE(example.contains(inScript(option) + '\n')) << inScript(option).toStdString();
}

}  // namespace
