// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/lettering.h"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

using Point = Path::Point;

constexpr char32_t no_character = 0xfffd;

/// Letters that the font lacks, and what is drawn for them.
constexpr std::u32string_view lacking = U"\u2300\u2205\u2011\u2236";
constexpr std::u32string_view substitutes = U"\u00d8\u00d8-:";

/// Of height 1.
class Font {
public:
    Font() {
        stbtt_InitFont(&font_, reinterpret_cast<const unsigned char*>(letters_font.data()), 0);
        unit_ = double(stbtt_ScaleForMappingEmToPixels(&font_, 1));
    }

    /// 0 if there is none, nor a substitute.
    int glyphOf(char32_t letter) const {
        const std::size_t place = lacking.find(letter);
        const int own = stbtt_FindGlyphIndex(&font_, int(letter));
        if (own != 0 || place == lacking.npos) return own;
        return stbtt_FindGlyphIndex(&font_, int(substitutes[place]));
    }

    /// A box if the font has neither the letter nor a substitute.
    int drawnGlyphOf(char32_t letter) const {
        const int glyph = glyphOf(letter == no_character ? U'?' : letter);
        return glyph ? glyph : glyphOf(U'\u25a1');
    }

    double advanceOf(int glyph) const {
        int advance = 0;
        stbtt_GetGlyphHMetrics(&font_, glyph, &advance, nullptr);
        return unit_ * advance;
    }

    /// Adds the outlines.
    void append(int glyph, const Point& begin, Path& path) const {
        stbtt_vertex* vertices = nullptr;
        const int count = stbtt_GetGlyphShape(&font_, glyph, &vertices);
        for (int i = 0; i < count; ++i) {
            const stbtt_vertex& v = vertices[i];
            const Point end = begin + unit_ * Point(v.x, -v.y);
            if (v.type == STBTT_vmove)
                path.moveTo(end);
            else if (v.type == STBTT_vline)
                path.lineTo(end);
            else
                appendCurve(begin + unit_ * Point(v.cx, -v.cy), end, path);
        }
        stbtt_FreeShape(&font_, vertices);
    }

private:
    /// Curves of TrueType are quadratic.
    static void appendCurve(const Point& handle, const Point& end, Path& path) {
        const Point begin = path.pieces.back().end;
        path.curveTo(begin + 2. / 3 * (handle - begin), end + 2. / 3 * (handle - end), end);
    }

    stbtt_fontinfo font_ = {};
    double unit_;
};

const Font& font() {
    static const Font font;
    return font;
}

}  // namespace

double widthOf(char32_t letter) {
    return font().advanceOf(font().drawnGlyphOf(letter));
}

double widthOf(const std::string& text) {
    double width = 0;
    for (const char32_t letter : lettersOf(text))
        width += widthOf(letter);
    return width;
}

SheetPath outlinesOf(const SheetText& text) {
    Path path;
    path.fill_rule = FillRule::NonZero;
    double width = 0;
    for (const char32_t letter : lettersOf(text.text)) {
        font().append(font().drawnGlyphOf(letter), {width, 0}, path);
        width += widthOf(letter);
    }
    return {path.placed(text.height, text.begin(width * text.height))};
}

std::string lackingLetter(const std::string& text) {
    for (const char32_t letter : lettersOf(text))
        if (letter != no_character && font().glyphOf(letter) == 0) return inUtf8({&letter, 1});
    return {};
}

}  // namespace line_drawing
