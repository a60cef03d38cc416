// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of lines by names, alone and in mixtures.
#include "laplacian_lines/line_mixture.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace laplacian_lines;

/// "contours+borders" in the order of numbers; "?" if the name is not known.
std::string kinds(const std::string& names) {
    const std::optional<LineKindSet> set = kinds_named(names);
    if (!set) return "?";
    std::string result;
    for (const LineKindDescription& row : kLineKinds)
        if ((*set)[row.kind]) result += (result.empty() ? "" : "+") + std::string(row.key);
    return result;
}

TEST(LineMixtures, HaveTheOutlinesAndNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const LineMixture& mixture : kLineMixtures) {
        EXPECT_TRUE(names.insert(mixture.key).second) << mixture.key;
        EXPECT_TRUE(names.insert(mixture.label).second) << mixture.label;
        EXPECT_TRUE(mixture.kinds[LineKind::Contour] && mixture.kinds[LineKind::Border])
            << mixture.key;
        for (const LineKindDescription& kind : kLineKinds) {
            EXPECT_TRUE(!mixture.colored[kind.kind] || mixture.kinds[kind.kind])
                << mixture.key << " colors " << kind.key;
            EXPECT_TRUE(!mixture.colored[kind.kind] || kind.key_color) << kind.key;
        }
    }
}

TEST(LineMixtures, AreNamedByKeyOrLabel) {
    for (const LineMixture& mixture : kLineMixtures) {
        EXPECT_EQ(mixture_named(mixture.key), &mixture);
        EXPECT_EQ(mixture_named(mixture.label), &mixture);
        EXPECT_TRUE(kinds_named(mixture.label) == mixture.kinds) << mixture.label;
    }
    for (const char* name : {"LAPLACIAN LINES", "laplacianlines", "outlines_and_laplacian_lines"})
        EXPECT_EQ(mixture_named(name), &kLineMixtures.front()) << name;
    EXPECT_EQ(mixture_named("valleys"), nullptr);
    EXPECT_EQ(mixture_named(""), nullptr);
}

TEST(KindsNamed, AreThoseWithTheOutlines) {
    EXPECT_EQ(kinds("valleys"), "contours+borders+valleys");
    EXPECT_EQ(kinds("contours"), "contours+borders");
    EXPECT_EQ(kinds("suggestive CONTOURS"), "contours+borders+suggestive_contours");
    EXPECT_EQ(kinds("laplacian_lines + ridges,valleys"),
              "laplacian_lines+contours+ridges+borders+valleys");
    EXPECT_EQ(kinds("ridges_and_valleys"), "contours+ridges+borders+valleys");
    EXPECT_EQ(kinds("usual"), "laplacian_lines+contours+ridges+borders+creases");
    EXPECT_TRUE(kinds_named("all_kinds") == all_kinds());
}

TEST(KindsNamed, AreNothingWhereOneIsNotKnown) {
    for (const char* names : {"", ",", "ridge", "ridges,", "ridges,,valleys", "ridges+lines"})
        EXPECT_EQ(kinds(names), "?") << names;
}

TEST(KindsNamed, AreAllListed) {
    std::string names = names_of_kinds() + ", ";
    std::set<std::string> listed;
    for (std::size_t end; (end = names.find(", ")) != std::string::npos;) {
        EXPECT_NE(kinds(names.substr(0, end)), "?") << names.substr(0, end);
        EXPECT_TRUE(listed.insert(names.substr(0, end)).second) << names.substr(0, end);
        names = names.substr(end + 2);
    }
    EXPECT_EQ(listed.count("usual"), 1u);
    for (const LineKindDescription& row : kLineKinds)
        EXPECT_EQ(listed.count(row.key), 1u) << row.key;
    for (const LineMixture& mixture : kLineMixtures)
        EXPECT_EQ(listed.count(mixture.key), 1u) << mixture.key;
}

}  // namespace
