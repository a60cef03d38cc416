// SPDX-License-Identifier: GPL-3.0-or-later
// The filters' parameters as dialogs and scripts get them.
#include <gtest/gtest.h>

#include <QTextDocument>
#include <fstream>
#include <sstream>

#include "filters.h"
#include "test_paths.h"

namespace {

std::string content(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(test_paths::repository() / file).rdbuf();
    return text.str();
}

/// Dialogs fit small screens.
TEST(FilterParameters, AreFewAndInTheExamples) {
    const char* const examples[] = {"laplacian_lines.mlx", "laplacian_lines_polylines.mlx",
                                    "laplacian_lines_drawing.mlx"};
    const int most[] = {9, 7, 16};
    const meshlab_host::FilterList filters = make_filters();
    for (std::size_t i = 0; i < filters.size(); ++i) {
        RichParameterList list;
        filters[i].list_parameters(nullptr, list);
        const std::string example = content(std::string("docs/examples/") + examples[i]);
        int count = 0, in_example = 0;
        for (const RichParameter& parameter : list) {
            const std::string name = parameter.name().toStdString();
            EXPECT_NE(example.find("name=\"" + name + "\""), std::string::npos) << name;
            EXPECT_TRUE(Qt::mightBeRichText(parameter.toolTip())) << name << " does not wrap";
            ++count;
        }
        EXPECT_LE(count, most[i]) << examples[i];
        for (std::size_t at = example.find("<Param"); at != std::string::npos;
             at = example.find("<Param", at + 1))
            ++in_example;
        EXPECT_EQ(in_example, count) << examples[i];
    }
}

}  // namespace
