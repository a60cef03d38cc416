// SPDX-License-Identifier: GPL-3.0-or-later
// How dense front views of a mesh are, so many mm wide: strokes with inner lines per cm² that the
// mesh covers, the median length of strokes by length, mm, and the share of the length of inner
// lines with less than half a pen of white beside it.
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <string>
#include <tuple>

#include "flat_drawing.h"
#include "inner_strokes.h"
#include "laplacian_lines/precompute.h"
#include "line_drawing/make_sheet.h"
#include "mesh_file.h"
#include "program.h"
#include "strokes/drawn_lines.h"
#include "strokes/refining.h"

namespace {

using namespace benchmarks;
using Eigen::Vector2d;

constexpr double pixels_of_mm = 10;
constexpr double sample_step = 0.1;    // mm
constexpr double own_course = 6;       // pens of a stroke, beyond which it can be beside itself
constexpr double beside_cosine = 0.7;  // of the angle between a stroke and what is beside it
constexpr double widest_reach = 1;     // mm

/// Within a piece a stroke is not beside itself.
struct Piece {
    std::vector<Vector2d> points;
    double length = 0;
};

/// cm²
double sizeOf(const QPainterPath& area) {
    const QRectF box = area.boundingRect();
    QImage image((box.size() * pixels_of_mm).toSize(), QImage::Format_Grayscale8);
    image.fill(0);
    QPainter painter(&image);
    painter.scale(pixels_of_mm, pixels_of_mm);
    painter.translate(-box.topLeft());
    painter.fillPath(area, Qt::white);
    painter.end();
    std::size_t covered = 0;
    for (int y = 0; y < image.height(); ++y)
        covered += std::size_t(std::count_if(image.scanLine(y), image.scanLine(y) + image.width(),
                                             [](uchar v) { return v > 127; }));
    return double(covered) / (pixels_of_mm * pixels_of_mm * 100);
}

/// Of inner lines, mm.
double penOf(const line_drawing::Sheet& sheet) {
    for (const auto& layer : sheet.groups[0].layers)
        if (layer.key == "inner" && !layer.paths.empty()) return layer.paths[0].pen_width;
    return line_drawing::pensOf(
        line_drawing::Weights::Illustrator)[std::size_t(line_drawing::LineClass::Inner)];
}

/// Lengths of strokes that are inner lines in whole or part: from end to end where strokes taper.
/// `plain`: with even strokes, where contours and inner lines differ.
std::vector<double> strokeLengths(const line_drawing::Sheet& tapered,
                                  const line_drawing::Sheet& plain) {
    std::vector<std::vector<QPointF>> inner;  // places within each inner line
    for (const auto& layer : plain.groups[0].layers)
        for (const auto& path : layer.paths) {
            if (!is_inner(layer)) continue;
            const QPainterPath line = painterPath(path.path);
            inner.emplace_back();
            for (const double share : {0.2, 0.35, 0.5, 0.65, 0.8})
                inner.back().push_back(line.pointAtPercent(share));
        }
    std::vector<double> lengths;
    for (const auto& layer : tapered.groups[0].layers)
        for (const auto& path : layer.paths) {
            const QPainterPath outline = painterPath(path.path);
            const auto covers = [&](const QPointF& p) { return outline.contains(p); };
            const auto goes_on = [&](const std::vector<QPointF>& places) {
                return std::count_if(places.begin(), places.end(), covers) > 1;
            };
            if (!is_inner(layer) &&
                (layer.key != "contour" || std::none_of(inner.begin(), inner.end(), goes_on)))
                continue;
            lengths.push_back(0);  // half of the edges
            for (const PlaneLine& line : path.path.flattened(flatness))
                lengths.back() += length_of(line) / 2;
        }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

std::vector<Piece> piecesOf(const PlaneLine& line, double longest) {
    std::vector<Piece> pieces(1);
    for (const Vector2d& p : line) {
        if (!pieces.back().points.empty()) {
            const Vector2d before = pieces.back().points.back();
            if (pieces.back().length > longest) pieces.push_back({{before}, 0});
            pieces.back().length += (p - before).norm();
        }
        pieces.back().points.push_back(p);
    }
    return pieces;
}

/// The share of the length of inner lines with less than half a pen of white beside it. For even
/// strokes.
double closeShare(const line_drawing::Sheet& sheet) {
    const double pen = penOf(sheet);
    std::map<double, line_drawing::DrawnLines> all;  // by width
    std::vector<std::tuple<Piece, double, std::size_t>> inner;
    std::size_t number = 0;
    for (const auto& layer : sheet.groups[0].layers)
        for (const auto& path : layer.paths)
            for (const PlaneLine& line : path.path.flattened(flatness)) {
                if (layer.key == "area") continue;
                number += 2;  // pieces beside this one belong to one course
                for (const Piece& piece : piecesOf(line, own_course * pen)) {
                    all.try_emplace(path.pen_width, widest_reach)
                        .first->second.add(piece.points, ++number);
                    if (is_inner(layer)) inner.emplace_back(piece, path.pen_width, number);
                }
            }
    double close = 0, length = 0;
    for (const auto& [piece, width, own] : inner) {
        const std::vector<Vector2d> points = line_drawing::refine(piece.points, sample_step);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vector2d step = points[i] - points[i - 1];
            length += step.norm();
            for (const auto& [other_width, lines] : all) {
                const auto place =
                    lines.nearestOn(points[i], {own - 1, own + 1}, (width + other_width + pen) / 2);
                if (!place) continue;
                const Vector2d way = place->position - points[i];
                if (std::abs(way.dot(step)) > beside_cosine * way.norm() * step.norm()) continue;
                close += step.norm();
                break;
            }
        }
    }
    return length > 0 ? close / length : 0;
}

/// Median by length.
double usualLength(const std::vector<double>& lengths) {
    double rest = std::accumulate(lengths.begin(), lengths.end(), 0.) / 2;
    for (const double length : lengths)
        if ((rest -= length) <= 0) return length;
    return 0;
}

/// With tapered strokes, which are whole, and with even ones.
std::vector<line_drawing::Sheet> draw(const laplacian_lines::TriangleMesh& mesh, double width,
                                      bool segments) {
    line_drawing::SheetOptions options = front_options(mesh, width);
    options.style.whole_lines = !segments;
    const laplacian_lines::Field field =
        segments ? laplacian_lines::precompute(mesh) : laplacian_lines::Field();
    line_drawing::SheetOptions plain = options;
    plain.strokes = line_drawing::StrokeStyle::Plain;
    return line_drawing::makeSheets({{mesh, segments ? &field : nullptr}}, {options, plain});
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<double> sizes = {20, 50, 100, 200};
    bool segments = false;
    const std::vector<Option> options = {
        numbers("--sizes MM,MM...", "widths (20,50,100,200)", sizes),
        flag("--segments", "lines tested segment by segment, of the mesh's own kernel", segments)};
    return run_program(argc, argv, "MESH...", options, [&](const auto& files) {
        std::printf("%-20s %6s  strokes/cm2  usual mm  close %%\n", "mesh", "mm");
        for (const std::string& file : files) {
            const auto mesh = test_meshes::read_mesh(file);
            for (const double size : sizes) {
                const auto sheets = draw(mesh, size, segments);
                const auto lengths = strokeLengths(sheets[0], sheets[1]);
                std::printf("%-20s %6g  %11.1f  %9.1f  %7.1f\n",
                            test_meshes::mesh_name(file).c_str(), size,
                            double(lengths.size()) / sizeOf(covered_area(sheets[0])),
                            usualLength(lengths), 100 * closeShare(sheets[1]));
                std::fflush(stdout);
            }
        }
        return true;
    });
}
