// SPDX-License-Identifier: GPL-3.0-or-later
// A page as PDF: numbered objects, and a table of their places. Texts are in fonts that every
// reader has, whose widths are here; those with other letters are drawn by lettering.h.
#include <array>
#include <cmath>

#include "formats/sheet_writers.h"
#include "laplacian_lines/version.h"
#include "line_drawing/words.h"
#include "planes/lettering.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double kPointsPerMm = 72 / 25.4;
constexpr double kMostUnits = 14400;  // of a page's side, for readers: 5.08 m if these are points

std::string coordinates(const Vector2d& p) {
    return in_thousandths(p.x()) + ' ' + in_thousandths(p.y()) + ' ';
}

std::string path_data(const Path& path) {
    std::string data;
    for (std::size_t i = 0, begin = 0; i < path.pieces.size(); ++i) {
        const Path::Piece& piece = path.pieces[i];
        if (piece.step == Path::Step::Move) {
            begin = i;
            data += coordinates(piece.end) + "m ";
        } else if (piece.step == Path::Step::Line) {
            data += coordinates(piece.end) + "l ";
        } else {
            data += coordinates(piece.first) + coordinates(piece.second) + coordinates(piece.end) +
                    "c ";
        }
        const bool is_last =
            i + 1 == path.pieces.size() || path.pieces[i + 1].step == Path::Step::Move;
        if (is_last && i > begin && piece.end == path.pieces[begin].end) data += "h ";
    }
    return data;
}

/// A part of a text in one of the fonts that every PDF reader has: H, Helvetica in Windows' code
/// page 1252, or S, Symbol.
struct FontRun {
    char font;
    std::string codes;
};

struct StandardText {
    std::vector<FontRun> runs;
    double width = 0;      ///< for a font of height 1
    bool is_whole = true;  ///< false: letters that the fonts lack are question marks
};

// Helvetica's, in thousandths of the height, from code 32 on; 0: no letter. width_of() differs for
// ¯ ± µ · ÷.
// clang-format off
constexpr std::array<short, 224> kHelveticaWidths = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,
    0, 556, 0, 222, 556, 333, 1000, 556, 556, 333, 1000, 667, 333, 1000, 0, 611, 0, 0, 222, 222,
    333, 333, 350, 556, 1000, 333, 1000, 500, 333, 944, 0, 500, 667, 278, 333, 556, 556, 556, 556,
    260, 556, 333, 737, 370, 556, 584, 333, 737, 333, 400, 584, 333, 333, 333, 556, 537, 278, 333,
    333, 365, 556, 834, 834, 834, 611, 667, 667, 667, 667, 667, 667, 1000, 722, 667, 667, 667, 667,
    278, 278, 278, 278, 722, 722, 778, 778, 778, 778, 778, 584, 778, 722, 722, 722, 722, 667, 667,
    611, 556, 556, 556, 556, 556, 556, 889, 500, 556, 556, 556, 556, 278, 278, 278, 278, 556, 556,
    556, 556, 556, 556, 556, 584, 611, 556, 556, 556, 556, 500, 556, 500};
// clang-format on
constexpr char32_t kFirstCode = 32;

/// The letters of codes 0x80 to 0x9f, U+FFFD where there is none; other codes are Unicode's.
constexpr std::u32string_view kFrom0x80 =
    U"\u20ac\ufffd\u201a\u0192\u201e\u2026\u2020\u2021\u02c6\u2030\u0160\u2039\u0152\ufffd\u017d"
    U"\ufffd\ufffd\u2018\u2019\u201c\u201d\u2022\u2013\u2014\u02dc\u2122\u0161\u203a\u0153\ufffd"
    U"\u017e\u0178";

constexpr char32_t kRoot = U'\u221a', kCodeOfRoot = 0xd6;  // in Symbol
constexpr double kWidthOfRoot = 0.549;

/// 0 if there is none.
char32_t code_of(char32_t letter) {
    const std::size_t place = letter == kReplacement ? kFrom0x80.npos : kFrom0x80.find(letter);
    if (place != kFrom0x80.npos) return char32_t(0x80 + place);
    const bool is_same = letter >= kFirstCode && letter < 0x100 && (letter < 0x7f || letter > 0x9f);
    return is_same ? letter : 0;
}

StandardText in_standard_fonts(const std::string& text) {
    StandardText result;
    for (const char32_t letter : letters_of(text)) {
        const bool is_root = letter == kRoot;
        const char32_t found = is_root ? kCodeOfRoot : code_of(letter), code = found ? found : '?';
        const char font = is_root ? 'S' : 'H';
        if (result.runs.empty() || result.runs.back().font != font)
            result.runs.push_back({font, {}});
        result.runs.back().codes += char(code);
        result.width += is_root ? kWidthOfRoot : kHelveticaWidths[code - kFirstCode] / 1000.;
        result.is_whole &= found != 0;
    }
    return result;
}

/// A page's content stream, in millimetres, y down.
class Content {
public:
    std::string of(const Sheet& sheet, double units_per_mm) {
        data_ = in_digits(units_per_mm, 10) + " 0 0 -" + in_digits(units_per_mm, 10) + " 0 " +
                in_digits(units_per_mm * sheet.size.y(), 10) + " cm 1 J 1 j\n";
        for_each_mark(sheet.groups, [&](const auto& mark, const auto&, const auto&) { add(mark); });
        return data_;
    }

private:
    void add(const SheetPath& path) {
        if (path.path.is_empty()) return;
        if (path.pen_width == 0) {
            const char* fill = path.path.fill_rule == FillRule::EvenOdd ? "f*\n" : "f\n";
            data_ += in_digits(path.tone) + " g " + path_data(path.path) + fill;
        } else if (path.dash > 0) {
            data_ += "q 0 J [" + in_thousandths(path.dash) + ' ' + in_thousandths(path.dash / 2) +
                     "] 0 d ";
            stroke(path);
            data_ += "Q\n";
        } else {
            stroke(path);
        }
    }

    void stroke(const SheetPath& path) {
        data_ += in_thousandths(path.pen_width) + " w " + path_data(path.path) + "S\n";
    }

    void add(const SheetText& text) {
        const StandardText standard = in_standard_fonts(text.text);
        if (!standard.is_whole) return add(outlines_of(text));
        const std::string height = in_thousandths(text.height);
        data_ += "0 g BT " + height + " 0 0 -" + height + ' ' +
                 coordinates(text.begin(standard.width * text.height)) + "Tm";
        for (const FontRun& run : standard.runs)
            data_ += std::string(" /") + run.font + " 1 Tf (" + escaped(run.codes) + ") Tj";
        data_ += " ET\n";
    }

    static std::string escaped(const std::string& codes) {
        std::string result;
        for (const char c : codes) {
            if (c == '(' || c == ')' || c == '\\') result += '\\';
            result += c;
        }
        return result;
    }

    std::string data_;
};

/// Any characters: UTF-16 in hexadecimal, with a byte order mark.
std::string text_string(const std::string& text) {
    std::string digits = "<FEFF";
    for (const char32_t c : letters_of(text))
        digits += in_hexadecimal(c);
    return digits + '>';
}

/// Metadata that readers show; uncompressed, so that it can be searched.
std::string xmp(const std::string& provenance) {
    return R"(<?xpacket begin="" id="W5M0MpCehiHzreSzNTczkc9d"?>
<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
<rdf:Description rdf:about="" xmlns:ll="urn:laplacian-lines"><ll:provenance>)" +
           provenance + R"(</ll:provenance></rdf:Description>
</rdf:RDF></x:xmpmeta>
<?xpacket end="w"?>)";
}

class PdfWriter {
public:
    std::string write(const Sheet& sheet) {
        const double unit = std::ceil(kPointsPerMm * sheet.size.maxCoeff() / kMostUnits);
        const Vector2d size = kPointsPerMm / unit * sheet.size;
        object("<</Type /Catalog /Pages 2 0 R /ViewerPreferences <</PrintScaling /None>>" +
               std::string(sheet.provenance.empty() ? "" : " /Metadata 8 0 R") + ">>");
        object("<</Type /Pages /Kids [3 0 R] /Count 1>>");
        object("<</Type /Page /Parent 2 0 R /MediaBox [0 0 " + in_digits(size.x(), 10) + ' ' +
               in_digits(size.y(), 10) + (unit > 1 ? "] /UserUnit " + in_digits(unit, 10) : "]") +
               " /Contents 4 0 R /Resources <</Font <</H 5 0 R /S 6 0 R>>>>>>");
        stream("/Filter /FlateDecode", deflated(Content().of(sheet, kPointsPerMm / unit)));
        object("<</Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding>>");
        object("<</Type /Font /Subtype /Type1 /BaseFont /Symbol>>");
        object("<</Title " + text_string(sheet.title) + " /Creator " +
               text_string(std::string("Laplacian Lines ") + laplacian_lines::version()) + ">>");
        if (!sheet.provenance.empty())
            stream("/Type /Metadata /Subtype /XML", xmp(sheet.provenance));
        return end();
    }

private:
    void object(const std::string& content) {
        places_.push_back(pdf_.size());
        pdf_ += std::to_string(places_.size()) + " 0 obj\n" + content + "\nendobj\n";
    }
    void stream(const std::string& entries, const std::string& data) {
        object("<<" + entries + " /Length " + std::to_string(data.size()) + ">>\nstream\n" + data +
               "\nendstream");
    }
    std::string end() {
        const std::string count = std::to_string(places_.size() + 1);
        const std::size_t table = pdf_.size();
        pdf_ += "xref\n0 " + count + "\n0000000000 65535 f \n";
        for (const std::size_t place : places_) {
            const std::string digits = std::to_string(place);
            pdf_ += std::string(10 - digits.size(), '0') + digits + " 00000 n \n";
        }
        return pdf_ + "trailer\n<</Size " + count + " /Root 1 0 R /Info 7 0 R>>\nstartxref\n" +
               std::to_string(table) + "\n%%EOF\n";
    }

    std::string pdf_ = "%PDF-1.6\n%\xc2\xb5\xc2\xb6\n";  // other bytes than ASCII: a binary file
    std::vector<std::size_t> places_;
};

}  // namespace

std::string write_pdf(const Sheet& sheet, double) {
    return PdfWriter().write(sheet);
}

}  // namespace line_drawing
