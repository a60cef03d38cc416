// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "formats/pdf_parts.h"
#include "formats/sheet_writers.h"
#include "laplacian_lines/error.h"

using namespace line_drawing;

namespace {

/// By the specification of LZWDecode.
std::string decompressed(const std::string& data) {
    std::vector<std::string> known;
    std::string result, before;
    std::size_t width = 9;
    for (std::size_t bit = 0; bit + width <= 8 * data.size();) {
        std::size_t code = 0;
        for (std::size_t end = bit + width; bit < end; ++bit)
            code = code << 1 | (static_cast<unsigned char>(data[bit / 8]) >> (7 - bit % 8) & 1);
        if (code == 257) return result;
        if (code == 256) {
            known.clear();
            for (int byte = 0; byte < 258; ++byte)
                known.emplace_back(1, char(byte));
            before.clear();
        } else {
            const std::string now = code < known.size() ? known[code] : before + before[0];
            if (!before.empty()) known.push_back(before + now[0]);
            result += before = now;
        }
        width = known.size() < 511 ? 9 : known.size() < 1023 ? 10 : known.size() < 2047 ? 11 : 12;
    }
    return "has no end";
}

TEST(PdfFiles, AreCompressedWithoutLoss) {
    std::mt19937 random(1);
    std::string text;
    for (const std::size_t size : {0, 1, 2, 252, 253, 254, 255, 256, 3800, 3900, 50000, 200000}) {
        for (int letters : {1, 12, 256}) {
            text.clear();
            for (std::size_t i = 0; i < size; ++i)
                text += char(random() % unsigned(letters));
            ASSERT_EQ(decompressed(compressed(text)), text) << size << ' ' << letters;
        }
    }
    EXPECT_LT(compressed(std::string(50000, 'a')).size(), 1000u);
}

TEST(PdfFiles, HaveTheLettersOfStandardFonts) {
    const StandardText text = inStandardFonts("A \xe2\x88\x9ah \xe2\x80\x93 \xc3\xbc");
    EXPECT_TRUE(text.is_whole);
    ASSERT_EQ(text.runs.size(), 3u);
    EXPECT_EQ(text.runs[1].codes, "\xd6");
    EXPECT_EQ(text.runs[2].codes, "h \x96 \xfc");
    EXPECT_NEAR(text.width, .667 + .278 + .549 + .556 + .278 + .556 + .278 + .556, 1e-12);
    EXPECT_FALSE(inStandardFonts("\xc5\x81").is_whole);
}

TEST(PdfFiles, HaveOtherLettersAsOutlines) {
    Sheet sheet{{100, 50}, "", {}};
    sheet.groups = {{"a", "A", {{"b", "B", {}, {{{50, 25}, 4, TextAnchor::Right, "\xc5\x81"}}}}}};
    const std::string pdf = writePdf(sheet);
    const std::size_t begin = pdf.find("stream\n") + 7;
    const std::string content = decompressed(pdf.substr(begin, pdf.find("\nendstream") - begin));
    EXPECT_NE(content.find(" m "), content.npos);
    EXPECT_NE(content.find("h f\n"), content.npos) << content;
    EXPECT_EQ(content.find("Tj"), content.npos) << content;
}

}  // namespace
