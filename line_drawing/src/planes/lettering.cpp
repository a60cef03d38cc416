// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/lettering.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

using Point = Path::Point;

constexpr char32_t no_character = 0xfffd;

/// Letters that the font lacks, and what is drawn for them.
constexpr std::u32string_view lacking = U"\u2300\u2205\u2011\u2236";
constexpr std::u32string_view substitutes = U"\u00d8\u00d8-:";

struct OutlinePoint {
    Point place;
    bool is_corner;
};

/// As much of TrueType as this font needs: letters from U+0000 to U+FFFF, accents moved, never
/// scaled. The font is our own, so it is trusted.
class Font {
public:
    /// 0 if there is none, nor a substitute.
    int glyphOf(char32_t letter) const {
        if (const int own = ownGlyphOf(letter)) return own;
        const std::size_t place = lacking.find(letter);
        return place == lacking.npos ? 0 : ownGlyphOf(substitutes[place]);
    }

    double advanceOf(int glyph) const {
        const int last = int(short2(table("hhea") + 34)) - 1;
        return short2(table("hmtx") + 4 * std::size_t(std::min(glyph, last))) / units();
    }

    /// Adds the outlines, moved by `shift` in the font's units.
    void append(int glyph, const Point& shift, const Point& begin, Path& path) const {
        const std::size_t loca = table("loca") + 2 * std::size_t(glyph);
        const std::size_t place = table("glyf") + 2 * short2(loca);
        if (short2(loca) == short2(loca + 2)) return;
        const int contours = signed2(place);
        if (contours >= 0)
            appendContours(place + 10, contours, shift, begin, path);
        else
            appendParts(place + 10, shift, begin, path);
    }

private:
    int ownGlyphOf(char32_t letter) const {
        const std::size_t map = table("cmap") + long4(table("cmap") + 8);
        const std::size_t bytes = short2(map + 6);  // of each of four lists
        for (std::size_t i = 0; i < bytes && letter <= 0xffff; i += 2) {
            const std::size_t end = map + 14 + i, start = end + bytes + 2, delta = start + bytes,
                              range = delta + bytes;
            if (letter > short2(end)) continue;
            if (letter < short2(start)) return 0;
            if (short2(range) == 0) return int((letter + short2(delta)) & 0xffff);
            const int glyph = int(short2(range + short2(range) + 2 * (letter - short2(start))));
            return glyph == 0 ? 0 : (glyph + int(short2(delta))) & 0xffff;
        }
        return 0;
    }

    double units() const { return short2(table("head") + 18); }

    void appendParts(std::size_t place, const Point& shift, const Point& begin, Path& path) const {
        enum { are_words = 1, has_more = 32 };
        for (unsigned flags = has_more; flags & has_more;) {
            flags = short2(place);
            const int part = int(short2(place + 2));
            place += 4;
            const bool words = flags & are_words;
            const Point by = words ? Point(signed2(place), signed2(place + 2))
                                   : Point(std::int8_t(byte(place)), std::int8_t(byte(place + 1)));
            place += words ? 4 : 2;
            append(part, shift + by, begin, path);
        }
    }

    void appendContours(std::size_t place, int contours, const Point& shift, const Point& begin,
                        Path& path) const {
        std::vector<std::size_t> ends;
        for (; contours > 0; --contours, place += 2)
            ends.push_back(short2(place) + 1);
        place += 2 + short2(place);  // no hints
        std::vector<OutlinePoint> points = pointsAt(place, ends.back());
        for (OutlinePoint& point : points) {
            const Point moved = (point.place + shift) / units();
            point.place = begin + Point(moved.x(), -moved.y());
        }
        auto first = points.begin();
        for (const std::size_t end : ends) {
            appendContour({first, points.begin() + std::ptrdiff_t(end)}, path);
            first = points.begin() + std::ptrdiff_t(end);
        }
    }

    std::vector<OutlinePoint> pointsAt(std::size_t place, std::size_t count) const {
        enum { is_corner = 1, repeats = 8 };
        std::vector<unsigned> flags;
        while (flags.size() < count) {
            const unsigned flag = byte(place++);
            flags.insert(flags.end(), 1 + (flag & repeats ? byte(place++) : 0), flag);
        }
        std::vector<OutlinePoint> points;
        for (const unsigned flag : flags)
            points.push_back({Point::Zero(), (flag & is_corner) != 0});
        for (const int axis : {0, 1}) {
            const unsigned is_byte = 2u << axis,
                           is_same = 16u << axis;  // of a byte: it is positive
            int value = 0;
            for (std::size_t i = 0; i < count; ++i) {
                if (flags[i] & is_byte) {
                    value += flags[i] & is_same ? int(byte(place)) : -int(byte(place));
                    ++place;
                } else if (!(flags[i] & is_same)) {
                    value += signed2(place);
                    place += 2;
                }
                points[i].place[axis] = value;
            }
        }
        return points;
    }

    /// Curves are quadratic; there is an implied corner halfway between two handles.
    static void appendContour(const std::vector<OutlinePoint>& points, Path& path) {
        const std::size_t count = points.size();
        const auto at = [&](std::size_t i) -> const OutlinePoint& { return points[i % count]; };
        const auto between = [&](std::size_t i) -> Point {
            return (at(i).place + at(i + 1).place) / 2;
        };
        std::size_t first = 0;
        while (first < count && !at(first).is_corner)
            ++first;
        if (first == count) first = 0;  // handles alone
        path.moveTo(at(first).is_corner ? at(first).place : between(first));
        for (std::size_t i = first + 1; i <= first + count; ++i) {
            const Point end = at(i + 1).is_corner ? at(i + 1).place : between(i);
            if (at(i).is_corner)
                path.lineTo(at(i).place);
            else
                curve(at(i).place, end, path);
        }
    }

    static void curve(const Point& handle, const Point& end, Path& path) {
        const Point begin = path.pieces.back().end;
        path.curveTo(begin + 2. / 3 * (handle - begin), end + 2. / 3 * (handle - end), end);
    }

    static std::size_t table(std::string_view tag) {
        std::size_t entry = 12;
        while (letters_font.substr(entry, 4) != tag)
            entry += 16;
        return long4(entry + 8);
    }
    static unsigned byte(std::size_t place) {
        return static_cast<unsigned char>(letters_font[place]);
    }
    static unsigned short2(std::size_t place) { return byte(place) << 8 | byte(place + 1); }
    static int signed2(std::size_t place) { return std::int16_t(short2(place)); }
    static std::size_t long4(std::size_t place) {
        return std::size_t(short2(place)) << 16 | short2(place + 2);
    }
};

/// A box if the font has neither the letter nor a substitute.
int drawnGlyphOf(char32_t letter, const Font& font) {
    const int glyph = font.glyphOf(letter == no_character ? U'?' : letter);
    return glyph ? glyph : font.glyphOf(U'\u25a1');
}

}  // namespace

double widthOf(char32_t letter) {
    const Font font;
    return font.advanceOf(drawnGlyphOf(letter, font));
}

Lettering letteringOf(const std::string& text) {
    const Font font;
    Lettering result;
    result.path.fill_rule = FillRule::NonZero;
    for (const char32_t letter : lettersOf(text)) {
        const int glyph = drawnGlyphOf(letter, font);
        font.append(glyph, Point::Zero(), {result.width, 0}, result.path);
        result.width += font.advanceOf(glyph);
    }
    return result;
}

SheetPath outlinesOf(const SheetText& text) {
    const Lettering letters = letteringOf(text.text);
    return {letters.path.placed(text.height, text.begin(letters.width * text.height))};
}

std::string lackingLetter(const std::string& text) {
    const Font font;
    for (const char32_t letter : lettersOf(text))
        if (letter != no_character && font.glyphOf(letter) == 0) return inUtf8({&letter, 1});
    return {};
}

}  // namespace line_drawing
