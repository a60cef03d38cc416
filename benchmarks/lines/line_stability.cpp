// SPDX-License-Identifier: GPL-3.0-or-later
// line_stability [--zoom] MESH...: how much the lines flicker while the view turns, with the
// default style, with one that cuts hard instead of fading, and with whole lines; and how many
// lines there are by detail. For each degree of an orbit around the vertical axis, the length of
// line that appears or vanishes: that has no line of the other view within 0.5 % of D, weighted
// with its opacity. In D per degree, mean of 90 degrees. The same while the view zooms in, from all
// of the mesh to a sixteenth in 200 frames, with lines that follow their size: of the length in the
// picture, within 2 pixels, in all frames and in the worst one; that alone with --zoom.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <unordered_set>
#include <utility>

#include "laplacian_lines/kernel_levels.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"

namespace {

using namespace laplacian_lines;

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kReach = 0.005, kDistance = 1.5;  // in D
constexpr int kFirstDegree = -45, kLastDegree = 45;
constexpr int kFrames = 200;
constexpr double kZoom = 16, kPicture = 800, kPixels = 2, kLineWidth = 1.6;  // pixels

/// The cells of a grid that lines of a view pass through or beside, within a frame.
class Neighbourhood {
public:
    Neighbourhood(const LineSet& lines, double cell, const Eigen::AlignedBox3f& frame)
        : cell_(cell) {
        for (const LinePoint& p : lines.points) {
            if (!frame.contains(p.position)) continue;
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

/// Length of the Laplacian lines within `frame`, times opacity, and of the part that `others` do
/// not have.
Length measure(const LineSet& lines, const Neighbourhood& others,
               const Eigen::AlignedBox3f& frame) {
    Length length;
    for (const Polyline& line : lines.lines) {
        if (line.kind != LineKind::Laplacian) continue;
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
            const LinePoint &a = lines.points[i - 1], &b = lines.points[i];
            if (!frame.contains(b.position)) continue;
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

const Eigen::AlignedBox3f kEverywhere(Eigen::Vector3f::Constant(-1e30f),
                                      Eigen::Vector3f::Constant(1e30f));

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
        const Length appeared =
            measure(now, Neighbourhood(before, kReach * d, kEverywhere), kEverywhere);
        const Length vanished =
            measure(before, Neighbourhood(now, kReach * d, kEverywhere), kEverywhere);
        mean.all += appeared.all / d / (kLastDegree - kFirstDegree);
        mean.alone += (appeared.alone + vanished.alone) / d / (kLastDegree - kFirstDegree);
    }
    return mean;
}

/// A mesh that is drawn with kernels of the size that suits the picture.
class Zoom {
public:
    Zoom(const TriangleMesh& mesh, const LineExtractor& extractor, const FieldScale& scale)
        : mesh_(mesh),
          extractor_(extractor),
          levels_(scale.mean_edge, scale.diagonal),
          d_(scale.diagonal) {}

    /// Looks along −z at a place. Prints how much of the lines appears or vanishes in a frame.
    void measure_frames(const Eigen::Vector3d& place, bool fades, const char* name) {
        LineSet lines[2];
        double changed = 0, all = 0, worst = 0, kernels = 0;
        for (int frame = 0; frame <= kFrames; ++frame) {
            const double pixel = d_ / kPicture * std::pow(kZoom, -double(frame) / kFrames);
            LineSet &before = lines[(frame + 1) & 1], &now = lines[frame & 1];
            kernels += double(draw(kDrawnKernelWidths * kLineWidth * pixel, fades, now));
            if (frame == 0) continue;
            const Eigen::Vector3f half = Eigen::Vector3f::Constant(float(kPicture / 2 * pixel));
            const Eigen::AlignedBox3f shown(place.cast<float>() - half, place.cast<float>() + half);
            const double reach = kPixels * pixel;
            const Eigen::AlignedBox3f around(shown.min() - half / 8, shown.max() + half / 8);
            const Length appeared = measure(now, Neighbourhood(before, reach, around), shown);
            const Length vanished = measure(before, Neighbourhood(now, reach, around), shown);
            changed += appeared.alone + vanished.alone;
            all += appeared.all;
            if (appeared.all > 0)
                worst = std::max(worst, (appeared.alone + vanished.alone) / appeared.all);
        }
        std::printf(
            "zoom, %s: %.3f %% of the length appears or vanishes in a frame, %.1f %% in the "
            "worst; %.2f kernels a frame\n",
            name, 100 * changed / all, 100 * worst, kernels / (kFrames + 1));
    }

private:
    /// Returns how many kernels there are.
    std::size_t draw(double kernel_size, bool fades, LineSet& lines) {
        std::vector<LevelShare> shares = levels_.at(kernel_size);
        if (!fades) shares.resize(1);
        std::vector<DrawnKernel> kernels;
        for (const LevelShare& share : shares)
            kernels.push_back({levels_.size(share.level), &laplacian(share.level), share.share});
        extract_kernels(extractor_, View::orthographic({0, 0, 1}), {}, kernels, scratch_, others_,
                        lines);
        return kernels.size();
    }
    const KernelLaplacian& laplacian(int level) {
        const auto found = laplacians_.find(level);
        if (found != laplacians_.end()) return found->second;
        PrecomputeOptions options;
        options.drawn_kernel_size = levels_.size(level);
        return laplacians_
            .emplace(level, extractor_.laplacian_of(mesh_, precompute(mesh_, options)))
            .first->second;
    }

    const TriangleMesh& mesh_;
    const LineExtractor& extractor_;
    const KernelLevels levels_;
    const double d_;
    std::map<int, KernelLaplacian> laplacians_;
    ExtractionScratch scratch_;
    LineSet others_;
};

/// The point of the mesh in front of its middle.
Eigen::Vector3d front_of(const TriangleMesh& mesh, const Eigen::Vector3d& centre, double d) {
    Eigen::Vector3d front = mesh.positions.at(0);
    const auto height = [&](const Eigen::Vector3d& p) {
        return p.z() - 4 * (p - centre).head<2>().squaredNorm() / d;
    };
    for (const Eigen::Vector3d& p : mesh.positions)
        if (height(p) > height(front)) front = p;
    return front;
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

void print_orbits(const char* file, const LineExtractor& extractor, const Eigen::Vector3d& centre,
                  double d) {
    LineStyle hard;
    hard.fading = hard.end_length = hard.contour_clearance = 0;
    LineStyle segments, whole;
    segments.whole_lines = false;
    whole.whole_lines = true;
    for (const auto& [name, style] :
         {std::pair{"hard cut", hard}, {"by segments", segments}, {"whole lines", whole}}) {
        const Length mean = measure_orbit(extractor, centre, d, style);
        std::printf("%s, %s: %.2f D of Laplacian lines, %.4f D appear or vanish per degree\n", file,
                    name, mean.all, mean.alone);
    }
}

void measure_mesh(const char* file, bool zoom_alone) {
    const TriangleMesh mesh = test_meshes::read_mesh(file);
    const Field field = precompute(mesh);
    const LineExtractor extractor(mesh, field);
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh.positions)
        box.extend(p);
    const double d = field.scale.diagonal;
    if (!zoom_alone) {
        print_orbits(file, extractor, box.center(), d);
        print_detail(file, extractor, orbit_view(box.center(), d, 0));
    }
    Zoom zoom(mesh, extractor, field.scale);
    const Eigen::Vector3d place = front_of(mesh, box.center(), d);
    zoom.measure_frames(place, false, "hard cut");
    zoom.measure_frames(place, true, "default");
}

}  // namespace

int main(int argc, char** argv) {
    const bool zoom_alone = argc > 1 && std::string(argv[1]) == "--zoom";
    for (int i = 1 + zoom_alone; i < argc; ++i)
        measure_mesh(argv[i], zoom_alone);
    return argc > 1 + zoom_alone ? 0 : 2;
}
