// SPDX-License-Identifier: GPL-3.0-or-later
// A page as DXF of AutoCAD's release 12, which every program reads: it has polylines but no Bézier
// curves, and names of ASCII letters.
#include <algorithm>
#include <initializer_list>
#include <map>

#include "formats/sheet_writers.h"
#include "line_drawing/words.h"

namespace line_drawing {
namespace {

constexpr double kTolerance = 0.01;  // of polylines to curves, mm

/// AutoCAD's color numbers by keys of layers.
const std::map<std::string, std::string> kColors = {
    {"outline", "7"}, {"contour", "3"}, {"edge", "5"},    {"inner", "4"},
    {"fine", "8"},    {"hidden", "2"},  {"section", "1"}, {"marks", "6"},
    {"area", "9"},    {"names", "30"},  {"scale", "40"},  {"title", "50"}};

constexpr std::size_t kCommentLength = 250;  // R12 has at most 255 characters in a line
const char* const kAnnotationsKey = "sheet";

/// As R12 allows: letters, digits, - and _.
std::string in_signs(const std::string& name) {
    std::string signs;
    for (const char32_t c : letters_of(upper(name)))
        signs += (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? char(c) : '-';
    return signs;
}

class DxfWriter {
public:
    explicit DxfWriter(const Sheet& sheet) : sheet_(sheet) {
        for (const SheetGroup& group : sheet.groups)
            for (const SheetLayer& layer : group.layers)
                add_layer(name_of(group, layer), layer);
    }

    std::string write() {
        for (std::size_t i = 0; i < sheet_.provenance.size(); i += kCommentLength)
            write({{999, sheet_.provenance.substr(i, kCommentLength)}});
        write_header();
        write_layers();
        write({{0, "SECTION"}, {2, "ENTITIES"}});
        for_each_mark(sheet_.groups, [&](const auto& mark, const auto& group, const auto& layer) {
            write_mark(mark, name_of(group, layer));
        });
        write({{0, "ENDSEC"}, {0, "EOF"}});
        return data_;
    }

private:
    struct Layer {
        std::string name, color;
        double dash;  ///< of its paths, which have all the same
    };

    /// With the view's name, if there are several.
    std::string name_of(const SheetGroup& group, const SheetLayer& layer) const {
        const auto views =
            std::count_if(sheet_.groups.begin(), sheet_.groups.end(),
                          [](const SheetGroup& other) { return other.key != kAnnotationsKey; });
        const bool is_one_of_many = views > 1 && group.key != kAnnotationsKey;
        return (is_one_of_many ? in_signs(group.key) + '_' : "") + in_signs(layer.key);
    }

    void add_layer(const std::string& name, const SheetLayer& layer) {
        if (layer.paths.empty() && layer.texts.empty()) return;
        const double dash = layer.paths.empty() ? 0 : layer.paths[0].dash;
        for (Layer& known : layers_)
            if (known.name == name) {
                if (known.dash == 0) known.dash = dash;
                return;
            }
        const auto color = kColors.find(layer.key);
        layers_.push_back({name, color == kColors.end() ? "7" : color->second, dash});
    }

    /// Group codes and values, a line each.
    void write(std::initializer_list<std::pair<int, std::string>> groups) {
        for (const auto& [code, value] : groups)
            data_ += std::to_string(code) + '\n' + value + '\n';
    }
    static std::string number(double value) { return in_decimals(value, 4); }
    void write_point(int code, const Eigen::Vector2d& p) {
        write({{code, number(p.x())},
               {code + 10, number(sheet_.size.y() - p.y())},
               {code + 20, number(0)}});
    }

    void write_header() {
        write({{0, "SECTION"}, {2, "HEADER"}, {9, "$ACADVER"}, {1, "AC1009"}});
        write({{9, "$INSUNITS"}, {70, "4"}, {9, "$EXTMIN"}});  // millimetres
        write_point(10, {0, sheet_.size.y()});
        write({{9, "$EXTMAX"}});
        write_point(10, {sheet_.size.x(), 0});
        write({{0, "ENDSEC"}});
    }

    void write_layers() {
        write({{0, "SECTION"}, {2, "TABLES"}, {0, "TABLE"}, {2, "LTYPE"}, {70, "2"}});
        write({{0, "LTYPE"}, {2, "CONTINUOUS"}, {70, "0"}, {3, "Solid line"}});
        write({{72, "65"}, {73, "0"}, {40, number(0)}});
        write_dashes();
        const std::string count = std::to_string(layers_.size());
        write({{0, "ENDTAB"}, {0, "TABLE"}, {2, "LAYER"}, {70, count}});
        for (const Layer& layer : layers_) {
            write({{0, "LAYER"}, {2, layer.name}, {70, "0"}, {62, layer.color}});
            write({{6, layer.dash > 0 ? "DASHED" : "CONTINUOUS"}});
        }
        write({{0, "ENDTAB"}, {0, "ENDSEC"}});
    }

    void write_dashes() {
        double dash = 0;
        for (const Layer& layer : layers_)
            dash = std::max(dash, layer.dash);
        if (dash == 0) return;
        write({{0, "LTYPE"}, {2, "DASHED"}, {70, "0"}, {3, "Hidden lines"}, {72, "65"}});
        write({{73, "2"}, {40, number(1.5 * dash)}, {49, number(dash)}, {49, number(-dash / 2)}});
    }

    void write_mark(const SheetPath& path, const std::string& layer) {
        for (const auto& line : path.path.flattened(kTolerance))
            if (line.size() > 1) write_polyline(line, layer);
    }

    void write_polyline(const std::vector<Eigen::Vector2d>& points, const std::string& layer) {
        const bool closed = points.size() > 2 && points.front() == points.back();
        write({{0, "POLYLINE"}, {8, layer}, {66, "1"}});
        write_point(10, {0, sheet_.size.y()});  // without a meaning, but R12 wants one
        write({{70, closed ? "1" : "0"}});
        for (std::size_t i = 0; i < points.size() - std::size_t(closed); ++i) {
            write({{0, "VERTEX"}, {8, layer}});
            write_point(10, points[i]);
        }
        write({{0, "SEQEND"}, {8, layer}});
    }

    /// %% begins a code, so a percent sign beside another or a code is written as %%%, and ^ a
    /// control character. Codes of letters have four digits; others, such as emoji, become "?".
    static std::string in_letters(const std::string& text) {
        const std::map<char32_t, std::string> codes = {
            {U'\u00b0', "%%d"}, {U'\u2300', "%%c"}, {U'\u00b1', "%%p"}, {U'^', "^ "}};
        const std::u32string all = letters_of(text);
        const auto begins_code = [&](std::size_t i) {
            return i < all.size() && (all[i] == '%' || codes.count(all[i]) > 0);
        };
        std::string letters;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const char32_t c = all[i];
            const auto code = codes.find(c);
            const bool follows_percent = i > 0 && all[i - 1] == '%';
            if (code != codes.end())
                letters += code->second;
            else if (c == '%')
                letters += follows_percent || begins_code(i + 1) ? "%%%" : "%";
            else if (c < 128)
                letters += c < ' ' ? ' ' : char(c);
            else if (c < 0x10000)
                letters += in_hexadecimal(c, "\\U+");
            else
                letters += '?';
        }
        return letters;
    }

    void write_mark(const SheetText& text, const std::string& layer) {
        write({{0, "TEXT"}, {8, layer}});
        write_point(10, text.position);
        write({{40, number(text.height * 0.7)}, {1, in_letters(text.text)}});  // of capital letters
        if (text.anchor == TextAnchor::Left) return;
        write({{72, text.anchor == TextAnchor::Middle ? "1" : "2"}});
        write_point(11, text.position);
    }

    const Sheet& sheet_;
    std::vector<Layer> layers_;
    std::string data_;
};

}  // namespace

std::string write_dxf(const Sheet& sheet, double) {
    return DxfWriter(sheet).write();
}

}  // namespace line_drawing
