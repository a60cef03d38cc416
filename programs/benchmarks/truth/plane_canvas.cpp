// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_canvas.h"

#include <QDir>
#include <QFileInfo>
#include <stdexcept>

namespace benchmarks {
namespace {

constexpr double pixels_per_mm = 10, margin = 3, largest = 2000;  // mm

QSize size_of(const Eigen::AlignedBox2d& box) {
    if (box.isEmpty() || !(box.sizes().maxCoeff() < largest))
        throw std::runtime_error("a picture has no size, or one of metres");
    const Eigen::Vector2d size = pixels_per_mm * (box.sizes().array() + 2 * margin);
    return {int(size.x()), int(size.y())};
}

}  // namespace

PlaneCanvas::PlaneCanvas(const Eigen::AlignedBox2d& box)
    : image_(size_of(box), QImage::Format_RGB32) {
    corner_ = {box.min().x() - margin, box.max().y() + margin};
    image_.fill(Qt::white);
    painter_.begin(&image_);
    painter_.setRenderHint(QPainter::Antialiasing);
}

void PlaneCanvas::draw(const PlaneLine& line, const QColor& color, double width) {
    painter_.setPen(QPen(color, width));
    QPolygonF polygon;
    for (const PlanePoint& p : line)
        polygon.push_back(place(p));
    painter_.drawPolyline(polygon);
}

void PlaneCanvas::draw(const PlaneLines& lines, const QColor& color, double width) {
    for (const PlaneLine& line : lines)
        draw(line, color, width);
}

void PlaneCanvas::dot(const PlanePoint& p, const QColor& color) {
    painter_.fillRect(QRectF(place(p) - QPointF(1.5, 1.5), QSizeF(3, 3)), color);
}

void PlaneCanvas::ring(const PlanePoint& p, const QColor& color) {
    painter_.setPen(QPen(color, 2));
    painter_.drawEllipse(place(p), 8, 8);
}

void PlaneCanvas::save(const QString& file) {
    painter_.end();
    if (!QDir().mkpath(QFileInfo(file).path()) || !image_.save(file))
        throw std::runtime_error(file.toStdString() + " cannot be written");
}

QPointF PlaneCanvas::place(const PlanePoint& p) const {
    return {pixels_per_mm * (p.x() - corner_.x()), pixels_per_mm * (corner_.y() - p.y())};
}

Eigen::AlignedBox2d box_of(const PlaneLines& lines) {
    Eigen::AlignedBox2d box;
    for (const PlaneLine& line : lines)
        for (const PlanePoint& p : line)
            box.extend(p);
    return box;
}

}  // namespace benchmarks
