// SPDX-License-Identifier: GPL-3.0-or-later
#include <QBuffer>
#include <QXmlStreamWriter>
#include <cmath>

#include "formats/sheet_painting.h"
#include "formats/sheet_writers.h"

namespace line_drawing {
namespace {

const char* const svg_namespace = "http://www.w3.org/2000/svg";
const char* const inkscape_namespace = "http://www.inkscape.org/namespaces/inkscape";

/// A number given in thousandths, as short as it can be written.
QString decimal(qint64 thousandths) {
    QString digits = QString::number(std::abs(thousandths)).rightJustified(4, '0');
    digits.insert(digits.size() - 3, '.');
    while (digits.endsWith('0'))
        digits.chop(1);
    if (digits.endsWith('.')) digits.chop(1);
    if (digits.startsWith("0.")) digits.remove(0, 1);
    return thousandths < 0 ? '-' + digits : digits;
}

qint64 thousandths(double mm) {
    return std::llround(mm * 1000);
}
QString number(double mm) {
    return decimal(thousandths(mm));
}

/// Path data in thousandths of a millimetre, each place relative to the one before: short, and
/// rounding does not add up.
class PathData {
public:
    QString of(const QPainterPath& path) {
        for (int i = 0; i < path.elementCount(); ++i) {
            const QPainterPath::Element& e = path.elementAt(i);
            if (e.isMoveTo()) {
                close();
                command('M');
                x_ = y_ = 0;
                add(e);
                start_x_ = x_, start_y_ = y_;
            } else if (e.isLineTo()) {
                command('l');
                add(e);
            } else if (e.isCurveTo()) {
                command('c');
                add(e, false);
                add(path.elementAt(i + 1), false);
                add(path.elementAt(i += 2));
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
    void add(const QPainterPath::Element& e, bool moves = true) {
        const qint64 x = thousandths(e.x), y = thousandths(e.y);
        write(x - x_);
        write(y - y_);
        if (!moves) return;
        x_ = x, y_ = y;
        ++points_;
    }
    void write(qint64 value) {
        const QString digits = decimal(value);
        if (has_number_ && !digits.startsWith('-')) data_ += ' ';
        data_ += digits;
        has_number_ = true;
    }
    void close() {
        if (points_ > 1 && x_ == start_x_ && y_ == start_y_) data_ += 'z';
        points_ = 0;
    }

    QString data_;
    bool has_number_ = false;
    qint64 x_ = 0, y_ = 0, start_x_ = 0, start_y_ = 0;
    int points_ = 0;
};

class SvgWriter {
public:
    explicit SvgWriter(QBuffer& buffer) : xml_(&buffer) {
        xml_.setAutoFormatting(true);
        xml_.setAutoFormattingIndent(1);
    }

    void write(const Sheet& sheet) {
        xml_.writeStartDocument();
        xml_.writeDefaultNamespace(svg_namespace);
        xml_.writeNamespace(inkscape_namespace, "inkscape");
        xml_.writeStartElement(svg_namespace, "svg");
        const QString width = number(sheet.size.width()), height = number(sheet.size.height());
        xml_.writeAttribute("width", width + "mm");
        xml_.writeAttribute("height", height + "mm");
        xml_.writeAttribute("viewBox", QString("0 0 %1 %2").arg(width, height));
        if (!sheet.title.isEmpty()) xml_.writeTextElement(svg_namespace, "title", sheet.title);
        if (!sheet.provenance.isEmpty()) {
            xml_.writeStartElement(svg_namespace, "metadata");
            xml_.writeCDATA(sheet.provenance);  // keeps quotes as they are
            xml_.writeEndElement();
        }
        for (const SheetGroup& group : sheet.groups)
            writeGroup(group);
        xml_.writeEndDocument();
    }

private:
    void beginLayer(const QString& id, const QString& name, const QString& css_class) {
        xml_.writeStartElement(svg_namespace, "g");
        xml_.writeAttribute("id", id);
        xml_.writeAttribute("class", css_class);
        xml_.writeAttribute(inkscape_namespace, "groupmode", "layer");
        xml_.writeAttribute(inkscape_namespace, "label", name);
    }

    void writeGroup(const SheetGroup& group) {
        beginLayer(group.key, group.name, "view");
        for (const SheetLayer& layer : group.layers) {
            if (layer.paths.empty() && layer.texts.empty()) continue;
            beginLayer(group.key + '-' + layer.key, layer.name, layer.key);
            for (const SheetPath& path : layer.paths)
                writePath(path);
            for (const SheetText& text : layer.texts)
                writeText(text);
            xml_.writeEndElement();
        }
        xml_.writeEndElement();
    }

    void writePath(const SheetPath& path) {
        xml_.writeEmptyElement(svg_namespace, "path");
        xml_.writeAttribute("d", PathData().of(path.path));
        if (path.pen_width == 0) {  // filled with black, as is usual
            if (path.tone > 0) xml_.writeAttribute("fill", grey(path.tone).name());
            if (path.path.fillRule() == Qt::OddEvenFill)
                xml_.writeAttribute("fill-rule", "evenodd");
            return;
        }
        xml_.writeAttribute("fill", "none");
        xml_.writeAttribute("stroke", "#000");
        xml_.writeAttribute("stroke-width", number(path.pen_width));
        if (path.dash > 0)
            xml_.writeAttribute("stroke-dasharray",
                                number(path.dash) + ' ' + number(path.dash / 2));
        else
            xml_.writeAttribute("stroke-linecap", "round");
        xml_.writeAttribute("stroke-linejoin", "round");
    }

    void writeText(const SheetText& text) {
        xml_.writeStartElement(svg_namespace, "text");
        xml_.writeAttribute("x", number(text.position.x()));
        xml_.writeAttribute("y", number(text.position.y()));
        xml_.writeAttribute("font-size", number(text.height));
        xml_.writeAttribute("font-family", "sans-serif");
        if (text.alignment == Qt::AlignRight) xml_.writeAttribute("text-anchor", "end");
        if (text.alignment == Qt::AlignHCenter) xml_.writeAttribute("text-anchor", "middle");
        xml_.writeCharacters(text.text);
        xml_.writeEndElement();
    }

    QXmlStreamWriter xml_;
};

}  // namespace

QByteArray writeSvg(const Sheet& sheet) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    SvgWriter(buffer).write(sheet);
    return buffer.data();
}

}  // namespace line_drawing
