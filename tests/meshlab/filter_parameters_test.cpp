// SPDX-License-Identifier: GPL-3.0-or-later
// The filters' parameters as dialogs and scripts get them.
#include <gtest/gtest.h>

#include <QTextDocument>
#include <iterator>

#include "filters.h"
#include "test_paths.h"

namespace {

struct Dialog {
    const char* example;
    int most;  ///< parameters that fit a small screen
};
constexpr Dialog kDialogs[] = {{"laplacian_lines.mlx", 9},
                               {"laplacian_lines_polylines.mlx", 6},
                               {"laplacian_lines_drawing.mlx", 16}};

/// Dialogs fit small screens, and the examples show all that they offer.
TEST(FilterParameters, AreFewAndInTheExamples) {
    const meshlab_host::FilterList filters = make_filters();
    ASSERT_EQ(filters.size(), std::size(kDialogs));
    for (std::size_t i = 0; i < filters.size(); ++i) {
        const Dialog& dialog = kDialogs[i];
        RichParameterList list;
        filters[i].list_parameters(nullptr, list);
        const std::string example =
            test_paths::content(std::string("docs/examples/") + dialog.example);
        int count = 0, in_example = 0;
        for (const RichParameter& parameter : list) {
            const std::string name = parameter.name().toStdString();
            EXPECT_NE(example.find("name=\"" + name + "\""), std::string::npos) << name;
            EXPECT_TRUE(Qt::mightBeRichText(parameter.toolTip())) << name << " does not wrap";
            ++count;
        }
        EXPECT_LE(count, dialog.most) << dialog.example;
        for (std::size_t at = example.find("<Param"); at != std::string::npos;
             at = example.find("<Param", at + 1))
            ++in_example;
        EXPECT_EQ(in_example, count) << dialog.example;
    }
}

}  // namespace
