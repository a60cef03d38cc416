// SPDX-License-Identifier: GPL-3.0-or-later
#include <QBuffer>
#include <QImage>
#include <cmath>

#include "sheet_painting/painted_file.h"
#include "sheet_painting/painting.h"
#include "sheet_painting/qt_words.h"

namespace sheet_painting {
namespace {

constexpr double most_pixels = 32000;  // of a side; Qt paints no farther

}  // namespace

std::string writePng(const line_drawing::Sheet& sheet, double dpi) {
    const double scale = dpi / mm_per_inch;
    const double width = std::ceil(sheet.size.x() * scale),
                 height = std::ceil(sheet.size.y() * scale);
    if (width > most_pixels || height > most_pixels)
        refuse(QString("A picture of %1 x %2 pixels is too large; take fewer dots per inch.")
                   .arg(width)
                   .arg(height));
    QImage image(int(width), int(height), QImage::Format_Grayscale8);
    if (image.isNull()) refuse("There is not enough memory for the picture.");
    image.fill(Qt::white);
    image.setDotsPerMeterX(int(std::lround(scale * 1000)));
    image.setDotsPerMeterY(int(std::lround(scale * 1000)));
    {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(scale, scale);
        paint(sheet, painter);
    }
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return buffer.data().toStdString();
}

}  // namespace sheet_painting
