// SPDX-License-Identifier: GPL-3.0-or-later
// How dense measured drawings of a mesh are from the front, so many mm wide: inner strokes a cm² of
// what the mesh covers, their median length in mm, and which share of their length has less than
// half a pen of white beside it.
#include <QImage>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "laplacian_lines/precompute.h"
#include "line_drawing/bounds.h"
#include "line_drawing/make_sheet.h"
#include "mesh_file.h"
#include "program.h"

namespace {

using Eigen::Vector2d;

constexpr double pixels_of_mm = 10;
constexpr double sample_step = 0.1;    // mm
constexpr double own_course = 6;       // pens along a stroke within which it is not beside itself
constexpr double beside_cosine = 0.7;  // of the angle between a stroke and what is beside it

struct Sample {
    Vector2d position, along;
    std::size_t stroke;
    double at, width;  // length along the stroke
};

struct Density {
    double strokes_a_cm2, median_length, close_share;
};

std::vector<Sample> samplesOf(const QPolygonF& line, std::size_t stroke, double width) {
    std::vector<Sample> samples;
    double at = 0;
    for (int i = 1; i < line.size(); ++i) {
        const Vector2d a(line[i - 1].x(), line[i - 1].y()), b(line[i].x(), line[i].y());
        const double length = (b - a).norm();
        if (length == 0) continue;
        for (double d = 0; d < length; d += sample_step)
            samples.push_back({a + d / length * (b - a), (b - a) / length, stroke, at + d, width});
        at += length;
    }
    return samples;
}

double areaOf(const line_drawing::Sheet& sheet) {
    QImage image((sheet.size * pixels_of_mm).toSize(), QImage::Format_Grayscale8);
    image.fill(0);
    QPainter painter(&image);
    painter.scale(pixels_of_mm, pixels_of_mm);
    for (const auto& layer : sheet.groups[0].layers)
        if (layer.key == "area")
            for (const auto& path : layer.paths)
                painter.fillPath(path.path, Qt::white);
    painter.end();
    std::size_t covered = 0;
    for (int y = 0; y < image.height(); ++y)
        covered += std::size_t(std::count_if(image.scanLine(y), image.scanLine(y) + image.width(),
                                             [](uchar v) { return v > 127; }));
    return double(covered) / (pixels_of_mm * pixels_of_mm * 100);
}

class Neighbours {
public:
    void add(const Sample& sample) { cells_[cellOf(sample.position)].push_back(sample); }

    bool isClose(const Sample& s, double pen) const {
        const auto [x, y] = cellOf(s.position);
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy) {
                const auto found = cells_.find({x + dx, y + dy});
                if (found == cells_.end()) continue;
                for (const Sample& other : found->second)
                    if (isBeside(s, other, pen)) return true;
            }
        return false;
    }

private:
    static std::pair<int, int> cellOf(const Vector2d& p) {
        return {int(std::floor(p.x())), int(std::floor(p.y()))};
    }
    static bool isBeside(const Sample& s, const Sample& other, double pen) {
        if (other.stroke == s.stroke && std::abs(other.at - s.at) < own_course * pen) return false;
        const Vector2d way = other.position - s.position;
        const double distance = way.norm();
        return distance < (s.width + other.width + pen) / 2 &&
               std::abs(way.dot(s.along)) <= beside_cosine * distance;
    }
    std::map<std::pair<int, int>, std::vector<Sample>> cells_;
};

/// Of the inner lines, mm.
double penOf(const line_drawing::Sheet& sheet) {
    for (const auto& layer : sheet.groups[0].layers)
        if (layer.key == "inner" && !layer.paths.empty()) return layer.paths[0].pen_width;
    return line_drawing::pensOf(
        line_drawing::Weights::Illustrator)[std::size_t(line_drawing::LineClass::Inner)];
}

Density densityOf(const line_drawing::Sheet& sheet) {
    const double pen = penOf(sheet);
    std::vector<double> lengths;
    std::vector<Sample> inner;
    Neighbours all;
    std::size_t stroke = 0;
    for (const auto& layer : sheet.groups[0].layers) {
        if (layer.key == "area") continue;
        const bool is_inner = layer.key == "inner" || layer.key == "fine";
        for (const auto& path : layer.paths)
            for (const QPolygonF& line : path.path.toSubpathPolygons()) {
                const auto samples = samplesOf(line, stroke++, path.pen_width);
                if (samples.empty()) continue;
                for (const Sample& sample : samples)
                    all.add(sample);
                if (!is_inner) continue;
                inner.insert(inner.end(), samples.begin(), samples.end());
                lengths.push_back(samples.back().at);
            }
    }
    const auto close = std::count_if(inner.begin(), inner.end(),
                                     [&](const Sample& s) { return all.isClose(s, pen); });
    std::nth_element(lengths.begin(), lengths.begin() + std::ptrdiff_t(lengths.size() / 2),
                     lengths.end());
    return {double(lengths.size()) / areaOf(sheet),
            lengths.empty() ? 0 : lengths[lengths.size() / 2],
            double(close) / double(std::max<std::size_t>(1, inner.size()))};
}

line_drawing::Sheet draw(const laplacian_lines::TriangleMesh& mesh, double width, bool segments) {
    line_drawing::SheetOptions options;
    options.views = line_drawing::parseViews("front", line_drawing::UpAxis::Y);
    options.paper = "fit";
    options.strokes = line_drawing::StrokeStyle::Plain;
    options.area = line_drawing::OutlineArea::Filled;
    options.scale = width / line_drawing::boundsOf(mesh).sizes().x();
    options.style.whole_lines = !segments;
    const laplacian_lines::Field field =
        segments ? laplacian_lines::precompute(mesh) : laplacian_lines::Field();
    return line_drawing::makeSheets({{mesh, segments ? &field : nullptr}}, {options}).front();
}

}  // namespace

int main(int argc, char** argv) {
    using namespace benchmarks;
    std::vector<double> sizes = {20, 50, 100, 200};
    bool segments = false;
    const std::vector<Option> options = {
        numbers("--sizes MM,MM...", "widths (20,50,100,200)", sizes),
        flag("--segments", "lines tested segment by segment, of the mesh's own kernel", segments)};
    return run_program(argc, argv, "MESH...", options, [&](const auto& files) {
        std::printf("%-20s %6s  strokes/cm2  median mm  close %%\n", "mesh", "mm");
        for (const std::string& file : files) {
            const auto mesh = test_meshes::read_mesh(file);
            for (const double size : sizes) {
                const Density d = densityOf(draw(mesh, size, segments));
                std::printf("%-20s %6g  %11.1f  %9.1f  %7.1f\n",
                            test_meshes::mesh_name(file).c_str(), size, d.strokes_a_cm2,
                            d.median_length, 100 * d.close_share);
                std::fflush(stdout);
            }
        }
        return true;
    });
}
