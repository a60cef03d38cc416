// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_picture.h"

#include "plane_canvas.h"

namespace benchmarks {
namespace {

QColor color_of(Mistake mistake) {
    switch (mistake) {
        case Mistake::Missed:
            return Qt::red;
        case Mistake::Wrong:
            return Qt::blue;
        default:
            return QColor(0, 170, 0);
    }
}

}  // namespace

void write_truth_picture(const QString& file, const DrawnPaths& drawing, const ExactLines& exact,
                         const TruthDetails& details) {
    const PlaneLines lines = lines_of(drawing);
    PlaneCanvas canvas(box_of(lines).merged(box_of(exact.demanded)).merged(box_of(exact.allowed)));
    canvas.draw(exact.allowed, QColor(225, 225, 245), 5);
    canvas.draw(exact.demanded, QColor(205, 205, 205), 5);
    canvas.draw(lines, Qt::black, 1);
    for (const MistakenPart& part : details.parts)
        canvas.draw(part.points, color_of(part.mistake), 3);
    for (const PlanePoint& p : details.loose_ends)
        canvas.ring(p, QColor(255, 140, 0));
    canvas.save(file);
}

}  // namespace benchmarks
