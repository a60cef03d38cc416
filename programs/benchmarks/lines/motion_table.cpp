// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the Laplacian lines pops in or out between frames, while the view turns by a degree
// and while it zooms in with kernels that follow.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <map>

#include "laplacian_lines/kernel_levels.h"
#include "laplacian_lines/precompute.h"
#include "line_scores.h"
#include "mesh_file.h"
#include "truth_options.h"

namespace benchmarks {
namespace {

using namespace laplacian_lines;

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr int kDegrees = 90, kFrames = 200;
constexpr double kOrbitRadius = 1.5, kZoom = 16;
constexpr double kPicture = 800, kPixels = 2, kLineWidth = 1.6;  // pixels

/// Within a box, length times opacity.
CurvePoints ink_of(const LineSet& lines, const Eigen::AlignedBox3d& box, double step) {
    CurvePoints ink;
    for (const Polyline& line : lines.lines) {
        if (line.kind != LineKind::Laplacian) continue;
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
            const LinePoint &a = lines.points[i - 1], &b = lines.points[i];
            if (!box.contains(b.position.cast<double>())) continue;
            std::size_t own = ink.lengths.size();
            ink.add(a.position.cast<double>(), b.position.cast<double>(), step);
            for (; own < ink.lengths.size(); ++own)
                ink.lengths[own] *= double(a.opacity + b.opacity) / 2;
        }
    }
    return ink;
}

/// Shares of length, from frame to frame.
class Motion {
public:
    /// A frame's lines within `shown`; lines within `around` may be near to them.
    void add(const LineSet& lines, const Eigen::AlignedBox3d& shown, double reach) {
        const Eigen::AlignedBox3d around(shown.min() - shown.sizes() / 8,
                                         shown.max() + shown.sizes() / 8);
        if (!before_.lines.empty()) {
            Share changed;
            const LineSet* const both[] = {&before_, &lines};
            for (const int i : {0, 1}) {
                const Share share = share_near(ink_of(*both[i], shown, reach),
                                               ink_of(*both[1 - i], around, reach), reach);
                changed += {share.all - share.part, share.all / 2};
            }
            sum_ += changed;
            worst_ = std::max(worst_, changed.value());
        }
        before_ = lines;
    }
    void print() const {
        std::printf(" %.3f, %.1f |", 100 * sum_.value(), 100 * worst_);
        std::fflush(stdout);
    }

private:
    LineSet before_;
    Share sum_;
    double worst_ = 0;
};

/// Drawn with kernels that suit the picture.
class MovedMesh {
public:
    explicit MovedMesh(const TriangleMesh& mesh)
        : mesh_(mesh), field_(precompute(mesh)), extractor_(mesh, field_) {
        for (const Eigen::Vector3d& p : mesh.positions)
            box_.extend(p);
    }

    void print_orbit() {
        Motion motion;
        for (int degree = -kDegrees / 2; degree <= kDegrees / 2; ++degree) {
            const Eigen::Vector3d offset(std::sin(degree * kDegree), 0.2,
                                         std::cos(degree * kDegree));
            extractor_.extract(
                View::perspective(box_.center() + kOrbitRadius * diagonal() * offset), {}, scratch_,
                lines_);
            motion.add(lines_, box_, 0.005 * diagonal());
        }
        motion.print();
    }

    /// Along z towards the front, with one or two levels per frame.
    void print_zoom(std::size_t levels) {
        Motion motion;
        const Eigen::Vector3d place = front();
        for (int frame = 0; frame <= kFrames; ++frame) {
            const double pixel = diagonal() / kPicture * std::pow(kZoom, -double(frame) / kFrames);
            draw(kDrawnKernelWidths * kLineWidth * pixel, levels);
            const Eigen::Vector3d half = Eigen::Vector3d::Constant(kPicture / 2 * pixel);
            motion.add(lines_, {place - half, place + half}, kPixels * pixel);
        }
        motion.print();
    }

private:
    double diagonal() const { return field_.scale.diagonal; }

    Eigen::Vector3d front() const {
        const auto height = [&](const Eigen::Vector3d& p) {
            return p.z() - 4 * (p - box_.center()).head<2>().squaredNorm() / diagonal();
        };
        return *std::max_element(
            mesh_.positions.begin(), mesh_.positions.end(),
            [&](const auto& a, const auto& b) { return height(a) < height(b); });
    }

    void draw(double kernel_size, std::size_t most_levels) {
        std::vector<DrawnKernel> kernels;
        for (const LevelShare& share : levels_.at(kernel_size))
            if (kernels.size() < most_levels)
                kernels.push_back(
                    {levels_.size(share.level), &laplacian(share.level), share.share});
        extract_kernels(extractor_, View::orthographic({0, 0, 1}), {}, kernels, scratch_, others_,
                        lines_);
    }

    const KernelLaplacian& laplacian(int level) {
        auto found = laplacians_.find(level);
        if (found == laplacians_.end()) {
            PrecomputeOptions options;
            options.drawn_kernel_size = levels_.size(level);
            found = laplacians_
                        .emplace(level, extractor_.laplacian_of(mesh_, precompute(mesh_, options)))
                        .first;
        }
        return found->second;
    }

    const TriangleMesh& mesh_;
    const Field field_;
    const LineExtractor extractor_;
    const KernelLevels levels_{field_.scale.mean_edge, field_.scale.diagonal};
    Eigen::AlignedBox3d box_;
    std::map<int, KernelLaplacian> laplacians_;
    ExtractionScratch scratch_;
    LineSet others_, lines_;
};

}  // namespace

void print_motion(const TruthOptions&, const std::vector<std::string>& files) {
    std::printf(
        "\nWhat appears or vanishes from frame to frame, %% of the length: mean, worst\n\n"
        "| mesh | 1 degree of an orbit | zoom to 1/%g in %d frames | without the second level |\n"
        "|---|---|---|---|\n",
        kZoom, kFrames);
    for (const std::string& file : files) {
        const TriangleMesh mesh = test_meshes::read_mesh(file);
        MovedMesh moved(mesh);
        std::printf("| %s |", test_meshes::mesh_name(file).c_str());
        moved.print_orbit();
        for (const std::size_t levels : {2, 1})
            moved.print_zoom(levels);
        std::printf("\n");
    }
}

}  // namespace benchmarks
