// SPDX-License-Identifier: GPL-3.0-or-later
#include <QPolygonF>
#include <QSet>
#include <QTransform>
#include <map>

#include "formats/sheet_writers.h"

namespace line_drawing {
namespace {

// Qt makes polygons of curves to half a unit: to a hundredth of a millimetre.
constexpr double flattening = 50;

/// So that classes of lines can be told apart on a screen: AutoCAD's numbers of colours, by keys of
/// layers. 7, black or white, of others.
const std::map<QString, QByteArray> colors = {{"contour", "3"}, {"edge", "5"},   {"inner", "4"},
                                              {"fine", "8"},    {"hidden", "2"}, {"section", "1"},
                                              {"marks", "6"},   {"area", "9"}};

class DxfWriter {
public:
    explicit DxfWriter(const Sheet& sheet) : sheet_(sheet) {}

    QByteArray write() {
        writeHeader();
        writeLayers();
        begin("ENTITIES");
        for (const SheetGroup& group : sheet_.groups)
            for (const SheetLayer& layer : group.layers) {
                for (const SheetPath& path : layer.paths)
                    writePath(path, nameOf(layer));
                for (const SheetText& text : layer.texts)
                    writeText(text, nameOf(layer));
            }
        end();
        write(0, "EOF");
        return data_;
    }

private:
    static QByteArray nameOf(const SheetLayer& layer) { return layer.key.toUpper().toLatin1(); }

    void write(int code, const QByteArray& value) {
        data_ += QByteArray::number(code) + '\n' + value + '\n';
    }
    void write(int code, double value) { write(code, QByteArray::number(value, 'f', 4)); }
    void writePoint(int code, const QPointF& p) {
        write(code, p.x());
        write(code + 10, sheet_.size.height() - p.y());
        write(code + 20, 0.);
    }
    void begin(const QByteArray& section) {
        write(0, "SECTION");
        write(2, section);
    }
    void end() { write(0, "ENDSEC"); }

    void writeHeader() {
        begin("HEADER");
        write(9, "$ACADVER");
        write(1, "AC1009");
        write(9, "$INSUNITS");
        write(70, "4");  // millimetres
        write(9, "$EXTMIN");
        writePoint(10, {0, sheet_.size.height()});
        write(9, "$EXTMAX");
        writePoint(10, {sheet_.size.width(), 0});
        end();
    }

    void writeLayers() {
        QList<QByteArray> names;
        std::map<QByteArray, QByteArray> color_of;
        for (const SheetGroup& group : sheet_.groups)
            for (const SheetLayer& layer : group.layers) {
                if (!names.contains(nameOf(layer))) names << nameOf(layer);
                const auto color = colors.find(layer.key);
                color_of[nameOf(layer)] = color == colors.end() ? "7" : color->second;
            }
        begin("TABLES");
        write(0, "TABLE");
        write(2, "LTYPE");
        write(70, "2");
        write(0, "LTYPE");
        write(2, "CONTINUOUS");
        write(70, "0");
        write(3, "Solid line");
        write(72, "65");
        write(73, "0");
        write(40, 0.);
        writeDashes();
        write(0, "ENDTAB");
        write(0, "TABLE");
        write(2, "LAYER");
        write(70, QByteArray::number(names.size()));
        for (const QByteArray& name : names) {
            write(0, "LAYER");
            write(2, name);
            write(70, "0");
            write(62, color_of[name]);
            write(6, dashOf(name) > 0 ? "DASHED" : "CONTINUOUS");
        }
        write(0, "ENDTAB");
        end();
    }

    /// Of the paths in a layer, which have all the same.
    double dashOf(const QByteArray& name) const {
        for (const SheetGroup& group : sheet_.groups)
            for (const SheetLayer& layer : group.layers)
                if (nameOf(layer) == name && !layer.paths.empty()) return layer.paths[0].dash;
        return 0;
    }
    void writeDashes() {
        double dash = 0;
        for (const SheetGroup& group : sheet_.groups)
            for (const SheetLayer& layer : group.layers)
                dash = std::max(dash, dashOf(nameOf(layer)));
        if (dash == 0) return;
        write(0, "LTYPE");
        write(2, "DASHED");
        write(70, "0");
        write(3, "Hidden lines");
        write(72, "65");
        write(73, "2");
        write(40, 1.5 * dash);
        write(49, dash);
        write(49, -dash / 2);
    }

    void writePath(const SheetPath& path, const QByteArray& layer) {
        const QTransform larger = QTransform::fromScale(flattening, flattening);
        for (const QPolygonF& polygon : path.path.toSubpathPolygons(larger))
            writePolyline(larger.inverted().map(polygon), layer);
    }

    void writePolyline(const QPolygonF& points, const QByteArray& layer) {
        const bool closed = points.size() > 2 && points.isClosed();
        write(0, "POLYLINE");
        write(8, layer);
        write(66, "1");
        writePoint(10, {0, sheet_.size.height()});
        write(70, closed ? "1" : "0");
        for (int i = 0; i < points.size() - int(closed); ++i) {
            write(0, "VERTEX");
            write(8, layer);
            writePoint(10, points[i]);
        }
        write(0, "SEQEND");
        write(8, layer);
    }

    /// Codes of DXF are of up to four digits; letters that take more, such as emoji, are "?".
    static QByteArray inLetters(const QString& text) {
        QByteArray letters;
        for (const uint c : text.toUcs4()) {
            if (c == '%')
                letters += "%%%";
            else if (c < 128)
                letters += c < ' ' ? ' ' : char(c);
            else if (c == 0x00b0)
                letters += "%%d";
            else if (c < 0x10000)
                letters += "\\U+" + QByteArray::number(c, 16).rightJustified(4, '0').toUpper();
            else
                letters += '?';
        }
        return letters;
    }

    void writeText(const SheetText& text, const QByteArray& layer) {
        write(0, "TEXT");
        write(8, layer);
        writePoint(10, text.position);
        write(40, text.height * 0.7);  // of capital letters
        write(1, inLetters(text.text));
        const int alignment = text.alignment == Qt::AlignRight     ? 2
                              : text.alignment == Qt::AlignHCenter ? 1
                                                                   : 0;
        if (alignment == 0) return;
        write(72, QByteArray::number(alignment));
        writePoint(11, text.position);
    }

    const Sheet& sheet_;
    QByteArray data_;
};

}  // namespace

QByteArray writeDxf(const Sheet& sheet) {
    return DxfWriter(sheet).write();
}

}  // namespace line_drawing
