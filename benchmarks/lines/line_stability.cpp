// SPDX-License-Identifier: GPL-3.0-or-later
// line_stability MESH...: how much the lines flicker while the view turns, with the default style
// and with one that cuts hard instead of fading; and how many lines there are by detail. For each
// degree of an orbit around the vertical axis, the length of line that appears or vanishes: that
// has no line of the other view within 0.5 % of D, weighted with its opacity. In D per degree, mean
// of 90 degrees.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <unordered_set>
#include <utility>

#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"

namespace {

using namespace laplacian_lines;

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kReach = 0.005, kDistance = 1.5;  // in D
constexpr int kFirstDegree = -45, kLastDegree = 45;

/// The cells of a grid that lines of a view pass through or beside.
class Neighbourhood {
public:
    Neighbourhood(const LineSet& lines, double cell) : cell_(cell) {
        for (const LinePoint& p : lines.points) {
            const Eigen::Vector3i c = cell_of(p.position);
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y)
                    for (int z = -1; z <= 1; ++z)
                        cells_.insert(key(c + Eigen::Vector3i(x, y, z)));
        }
    }
    bool has(const Eigen::Vector3f& p) const { return cells_.count(key(cell_of(p))) > 0; }

private:
    Eigen::Vector3i cell_of(const Eigen::Vector3f& p) const {
        return (p.cast<double>() / cell_).array().floor().cast<int>();
    }
    static std::uint64_t key(const Eigen::Vector3i& c) {
        return (std::uint64_t(c.x() & 0x1fffff) << 42) | (std::uint64_t(c.y() & 0x1fffff) << 21) |
               std::uint64_t(c.z() & 0x1fffff);
    }
    double cell_;
    std::unordered_set<std::uint64_t> cells_;
};

struct Length {
    double all = 0, alone = 0;
};

/// Length of the Laplacian lines, times opacity, and of the part that `others` do not have.
Length measure(const LineSet& lines, const Neighbourhood& others) {
    Length length;
    for (const Polyline& line : lines.lines) {
        if (line.kind != LineKind::Laplacian) continue;
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
            const LinePoint &a = lines.points[i - 1], &b = lines.points[i];
            const double ink = (b.position - a.position).norm() * (a.opacity + b.opacity) / 2.0;
            length.all += ink;
            if (!others.has(b.position)) length.alone += ink;
        }
    }
    return length;
}

View orbit_view(const Eigen::Vector3d& centre, double d, int degree) {
    const Eigen::Vector3d offset(std::sin(degree * kDegree), 0.2, std::cos(degree * kDegree));
    return View::perspective(centre + kDistance * d * offset);
}

/// Mean over the orbit of the length that is shown, and that changes with each degree; in D.
Length measure_orbit(const LineExtractor& extractor, const Eigen::Vector3d& centre, double d,
                     const LineStyle& style) {
    ExtractionScratch scratch;
    LineSet lines[2];
    Length mean;
    for (int degree = kFirstDegree; degree <= kLastDegree; ++degree) {
        LineSet &before = lines[(degree + 1) & 1], &now = lines[degree & 1];
        extractor.extract(orbit_view(centre, d, degree), style, scratch, now);
        if (degree == kFirstDegree) continue;
        const Length appeared = measure(now, Neighbourhood(before, kReach * d));
        const Length vanished = measure(before, Neighbourhood(now, kReach * d));
        mean.all += appeared.all / d / (kLastDegree - kFirstDegree);
        mean.alone += (appeared.alone + vanished.alone) / d / (kLastDegree - kFirstDegree);
    }
    return mean;
}

/// Number of Laplacian lines from the middle of the orbit at each tenth of the detail.
void print_detail(const char* file, const LineExtractor& extractor, const View& view) {
    ExtractionScratch scratch;
    LineSet lines;
    LineStyle style;
    style.shows[LineKind::Contour] = false;
    std::printf("%s, lines by detail 0, 10, ... 100:", file);
    for (style.detail = 0; style.detail <= 100; style.detail += 10) {
        extractor.extract(view, style, scratch, lines);
        std::printf(" %zu", lines.lines.size());
    }
    std::printf("\n");
}

void measure_mesh(const char* file) {
    const TriangleMesh mesh = test_meshes::read_mesh(file);
    const Field field = precompute(mesh);
    const LineExtractor extractor(mesh, field);
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh.positions)
        box.extend(p);
    LineStyle hard;
    hard.fading = hard.end_length = hard.contour_clearance = 0;
    for (const auto& [name, style] : {std::pair{"hard cut", hard}, {"default", LineStyle()}}) {
        const Length mean = measure_orbit(extractor, box.center(), field.scale.diagonal, style);
        std::printf("%s, %s: %.2f D of Laplacian lines, %.4f D appear or vanish per degree\n", file,
                    name, mean.all, mean.alone);
    }
    print_detail(file, extractor, orbit_view(box.center(), field.scale.diagonal, 0));
}

}  // namespace

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i)
        measure_mesh(argv[i]);
    return argc > 1 ? 0 : 2;
}
