// SPDX-License-Identifier: GPL-3.0-or-later
// What the filter says about kinds of lines follows their table, whatever is in it.
#include <gtest/gtest.h>

#include "filters.h"
#include "laplacian_lines/line_kind.h"

namespace {

using namespace laplacian_lines;

/// So many lines of each kind.
LineSet linesOfAllKinds(int count) {
    LineSet lines;
    for (const LineKindDescription& row : line_kinds)
        for (int i = 0; i < count; ++i) {
            Polyline line;
            line.kind = row.kind;
            lines.lines.push_back(line);
        }
    return lines;
}

TEST(KindsInWords, CountEachKind) {
    const QStringList one = kindsInWords(linesOfAllKinds(1)).split(", ");
    const QStringList three = kindsInWords(linesOfAllKinds(3)).split(", ");
    ASSERT_EQ(std::size_t(one.size()), line_kind_count);
    ASSERT_EQ(std::size_t(three.size()), line_kind_count);
    for (std::size_t i = 0; i < line_kind_count; ++i) {
        EXPECT_EQ(one[int(i)], QString("1 ") + line_kinds[i].one);
        EXPECT_EQ(three[int(i)], QString("3 ") + line_kinds[i].many);
    }
}

TEST(KindsInWords, LeaveOutWhatIsNotThere) {
    LineSet lines;
    EXPECT_TRUE(kindsInWords(lines).isEmpty());
    lines.lines.resize(2);
    lines.lines[0].kind = lines.lines[1].kind = line_kinds.back().kind;
    EXPECT_EQ(kindsInWords(lines), QString("2 ") + line_kinds.back().many);
}

// Its dialog has switches for the kinds that are shown by default, not for the others.
TEST(KindsInWords, TheHelpNamesThoseOfTheDialog) {
    const QString help = PolylineFilter().description().help;
    for (const LineKindDescription& row : line_kinds)
        EXPECT_EQ(help.contains(row.many), row.shown) << row.key;
}

}  // namespace
