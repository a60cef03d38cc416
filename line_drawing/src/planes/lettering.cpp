// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/lettering.h"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

using Point = Path::Point;

/// Letters that the font lacks, and their substitutes: diameter and empty set, the hyphen that does
/// not break, and the ratio.
constexpr std::u32string_view kSubstituted = U"\u2300\u2205\u2011\u2236";
constexpr std::u32string_view kSubstitutes = U"\u00d8\u00d8-:";

/// The compiled-in font, of height 1.
class Font {
public:
    Font() {
        stbtt_InitFont(&font_, reinterpret_cast<const unsigned char*>(kLettersFont.data()), 0);
        unit_ = double(stbtt_ScaleForMappingEmToPixels(&font_, 1));
    }

    /// 0 if there is none, nor a substitute.
    int glyph_of(char32_t letter) const {
        const std::size_t place = kSubstituted.find(letter);
        const int own = stbtt_FindGlyphIndex(&font_, int(letter));
        if (own != 0 || place == kSubstituted.npos) return own;
        return stbtt_FindGlyphIndex(&font_, int(kSubstitutes[place]));
    }

    /// A box if the font has neither the letter nor a substitute; ? for kReplacement.
    int drawn_glyph_of(char32_t letter) const {
        const int glyph = glyph_of(letter == kReplacement ? U'?' : letter);
        return glyph ? glyph : glyph_of(U'\u25a1');
    }

    double advance_of(int glyph) const {
        int advance = 0;
        stbtt_GetGlyphHMetrics(&font_, glyph, &advance, nullptr);
        return unit_ * advance;
    }

    /// Adds a glyph's outlines; `begin`: on the base line, y down.
    void append(int glyph, const Point& begin, Path& path) const {
        stbtt_vertex* vertices = nullptr;
        const int count = stbtt_GetGlyphShape(&font_, glyph, &vertices);
        for (int i = 0; i < count; ++i) {
            const stbtt_vertex& v = vertices[i];
            const Point end = begin + unit_ * Point(v.x, -v.y);
            if (v.type == STBTT_vmove)
                path.move_to(end);
            else if (v.type == STBTT_vline)
                path.line_to(end);
            else
                append_curve(begin + unit_ * Point(v.cx, -v.cy), end, path);
        }
        stbtt_FreeShape(&font_, vertices);
    }

private:
    /// Curves of TrueType are quadratic.
    static void append_curve(const Point& handle, const Point& end, Path& path) {
        const Point begin = path.pieces.back().end;
        path.curve_to(begin + 2. / 3 * (handle - begin), end + 2. / 3 * (handle - end), end);
    }

    stbtt_fontinfo font_ = {};
    double unit_;
};

const Font& font() {
    static const Font font;
    return font;
}

}  // namespace

double width_of(char32_t letter) {
    return font().advance_of(font().drawn_glyph_of(letter));
}

double width_of(const std::string& text) {
    double width = 0;
    for (const char32_t letter : letters_of(text))
        width += width_of(letter);
    return width;
}

SheetPath outlines_of(const SheetText& text) {
    Path path;
    path.fill_rule = FillRule::NonZero;
    double width = 0;
    for (const char32_t letter : letters_of(text.text)) {
        font().append(font().drawn_glyph_of(letter), {width, 0}, path);
        width += width_of(letter);
    }
    return {path.placed(text.height, text.begin(width * text.height))};
}

std::string missing_letter(const std::string& text) {
    for (const char32_t letter : letters_of(text))
        if (letter != kReplacement && font().glyph_of(letter) == 0) return in_utf8({&letter, 1});
    return {};
}

}  // namespace line_drawing
