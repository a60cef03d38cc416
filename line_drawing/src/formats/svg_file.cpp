// SPDX-License-Identifier: GPL-3.0-or-later
// A page as SVG, in millimetres: a group for each view and a layer for each class of lines in it.
#include <cmath>
#include <cstdint>

#include "formats/sheet_writers.h"
#include "line_drawing/words.h"

namespace line_drawing {
namespace {

/// Path commands, relative after each M, rounded to thousandths of a millimetre without
/// accumulating errors.
class PathData {
public:
    std::string of(const Path& path) {
        for (const Path::Piece& piece : path.pieces) {
            if (piece.step == Path::Step::Move) {
                close();
                command('M');
                x_ = y_ = 0;
                add(piece.end);
                start_x_ = x_, start_y_ = y_;
            } else if (piece.step == Path::Step::Line) {
                command('l');
                add(piece.end);
            } else {
                command('c');
                add(piece.first, false);
                add(piece.second, false);
                add(piece.end);
            }
        }
        close();
        return data_;
    }

private:
    void command(char letter) {
        data_ += letter;
        has_number_ = false;
    }
    void add(const Eigen::Vector2d& p, bool moves = true) {
        const std::int64_t x = std::llround(1000 * p.x()), y = std::llround(1000 * p.y());
        write(x - x_);
        write(y - y_);
        if (!moves) return;
        x_ = x, y_ = y;
        ++points_;
    }
    void write(std::int64_t value) {
        const std::string digits = thousandths(value);
        if (has_number_ && digits[0] != '-') data_ += ' ';
        data_ += digits;
        has_number_ = true;
    }
    void close() {
        if (points_ > 1 && x_ == start_x_ && y_ == start_y_) data_ += 'z';
        points_ = 0;
    }

    std::string data_;
    bool has_number_ = false;
    std::int64_t x_ = 0, y_ = 0, start_x_ = 0, start_y_ = 0;
    int points_ = 0;
};

/// For text and attributes; control characters, of which XML forbids most, become spaces.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else if (c == '"')
            result += "&quot;";
        else
            result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return result;
}

class SvgWriter {
public:
    std::string write(const Sheet& sheet) {
        const std::string width = in_thousandths(sheet.size.x()),
                          height = in_thousandths(sheet.size.y());
        svg_ = R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape")";
        attribute("width", width + "mm");
        attribute("height", height + "mm");
        attribute("viewBox", "0 0 " + width + ' ' + height);
        svg_ += '>';
        if (!sheet.title.empty()) {
            begin("title");
            content("title", escaped(sheet.title));
        }
        if (!sheet.provenance.empty()) {
            begin("metadata");
            content("metadata", "<![CDATA[" + sheet.provenance + "]]>");  // quotes stay as they are
        }
        for (const SheetGroup& group : sheet.groups)
            write_group(group);
        return svg_ + "\n</svg>\n";
    }

private:
    void begin(const char* element) { svg_ += '\n' + std::string(depth_, ' ') + '<' + element; }
    void attribute(const char* name, const std::string& value) {
        svg_ += std::string(" ") + name + "=\"" + value + '"';
    }
    void content(const char* element, const std::string& text) {
        svg_ += '>' + text + "</" + element + '>';
    }

    void begin_layer(const std::string& id, const std::string& name, const std::string& css_class) {
        begin("g");
        attribute("id", escaped(id));
        attribute("class", css_class);
        attribute("inkscape:groupmode", "layer");
        attribute("inkscape:label", escaped(name));
        svg_ += '>';
        ++depth_;
    }
    void end_layer() {
        --depth_;
        svg_ += '\n' + std::string(depth_, ' ') + "</g>";
    }

    void write_group(const SheetGroup& group) {
        begin_layer(group.key, group.name, "view");
        for (const SheetLayer& layer : group.layers) {
            if (layer.paths.empty() && layer.texts.empty()) continue;
            begin_layer(group.key + '-' + layer.key, layer.name, layer.key);
            for (const SheetPath& path : layer.paths)
                write_path(path);
            for (const SheetText& text : layer.texts)
                write_text(text);
            end_layer();
        }
        end_layer();
    }

    void write_path(const SheetPath& path) {
        begin("path");
        attribute("d", PathData().of(path.path));
        if (path.pen_width == 0) {  // filled with black, as is usual
            if (path.tone > 0) attribute("fill", grey(path.tone));
            if (path.path.fill_rule == FillRule::EvenOdd) attribute("fill-rule", "evenodd");
        } else {
            attribute("fill", "none");
            attribute("stroke", "#000");
            attribute("stroke-width", in_thousandths(path.pen_width));
            if (path.dash > 0)
                attribute("stroke-dasharray",
                          in_thousandths(path.dash) + ' ' + in_thousandths(path.dash / 2));
            else
                attribute("stroke-linecap", "round");
            attribute("stroke-linejoin", "round");
        }
        svg_ += "/>";
    }

    static std::string grey(double tone) {
        constexpr const char* digits = "0123456789abcdef";
        const auto value = std::size_t(std::lround(255 * tone));
        const std::string byte = {digits[value / 16], digits[value % 16]};
        return '#' + byte + byte + byte;
    }

    void write_text(const SheetText& text) {
        begin("text");
        attribute("x", in_thousandths(text.position.x()));
        attribute("y", in_thousandths(text.position.y()));
        attribute("font-size", in_thousandths(text.height));
        attribute("font-family", "sans-serif");
        if (text.anchor == TextAnchor::Right) attribute("text-anchor", "end");
        if (text.anchor == TextAnchor::Middle) attribute("text-anchor", "middle");
        content("text", escaped(text.text));
    }

    std::string svg_;
    std::size_t depth_ = 1;  ///< of the element to begin
};

}  // namespace

std::string write_svg(const Sheet& sheet, double) {
    return SvgWriter().write(sheet);
}

}  // namespace line_drawing
