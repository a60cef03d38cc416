// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <QColor>
#include <QImage>
#include <QPainter>
#include <QString>

#include "plane_lines.h"

namespace benchmarks {

/// A picture of lines on white, 10 pixels a mm.
class PlaneCanvas {
public:
    /// @throws std::runtime_error if the box is empty or larger than 2 m
    explicit PlaneCanvas(const Eigen::AlignedBox2d& box);

    void draw(const PlaneLine& line, const QColor& color, double width);
    void draw(const PlaneLines& lines, const QColor& color, double width);
    void dot(const PlanePoint& p, const QColor& color);
    void ring(const PlanePoint& p, const QColor& color);
    /// As PNG, also into a folder that is not there yet. @throws std::runtime_error
    void save(const QString& file);

private:
    QPointF place(const PlanePoint& p) const;

    PlanePoint corner_;
    QImage image_;
    QPainter painter_;
};

Eigen::AlignedBox2d box_of(const PlaneLines& lines);

}  // namespace benchmarks
