// SPDX-License-Identifier: GPL-3.0-or-later
#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>

#include "laplacian_lines/version.h"
#include "sheet_painting/painted_file.h"
#include "sheet_painting/painting.h"
#include "sheet_painting/qt_words.h"

namespace sheet_painting {
namespace {

constexpr int dots_per_inch = 1200;

/// The metadata of PDF, of which readers show what they know.
QByteArray xmp(const std::string& provenance) {
    return QString(R"(<?xpacket begin="" id="W5M0MpCehiHzreSzNTczkc9d"?>
<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
<rdf:Description rdf:about="" xmlns:ll="urn:laplacian-lines"><ll:provenance>%1</ll:provenance></rdf:Description>
</rdf:RDF></x:xmpmeta>
<?xpacket end="w"?>
)")
        .arg(inQt(provenance))
        .toUtf8();
}

/// The writer notes the time, by which equal drawings would differ.
void forgetTime(QByteArray& pdf) {
    const QByteArray key = "/CreationDate (D:";
    const int place = pdf.indexOf(key) + key.size();
    if (place < key.size()) return;
    const QByteArray date = "20000101000000";
    if (pdf.indexOf(')', place) >= place + date.size()) pdf.replace(place, date.size(), date);
}

}  // namespace

std::string writePdf(const line_drawing::Sheet& sheet) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setCreator(QString("Laplacian Lines ") + laplacian_lines::version());
        if (!sheet.provenance.empty()) writer.setDocumentXmpMetadata(xmp(sheet.provenance));
        writer.setTitle(inQt(sheet.title));
        writer.setResolution(dots_per_inch);
        writer.setPageSize(QPageSize(QSizeF(sheet.size.x(), sheet.size.y()), QPageSize::Millimeter,
                                     QString(), QPageSize::ExactMatch));
        writer.setPageMargins({0, 0, 0, 0});
        QPainter painter(&writer);
        painter.scale(dots_per_inch / mm_per_inch, dots_per_inch / mm_per_inch);
        paint(sheet, painter);
    }
    QByteArray pdf = buffer.data();
    forgetTime(pdf);
    return pdf.toStdString();
}

}  // namespace sheet_painting
