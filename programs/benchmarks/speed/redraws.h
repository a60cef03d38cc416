// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "laplacian_lines/line_extractor.h"
#include "plain_methods.h"
#include "system/simd_sets.h"
#include "turns.h"

namespace benchmarks {

constexpr int kEyes = 24;

/// Perspective views all around a mesh, 1.25 D from its middle, a little from above.
std::vector<laplacian_lines::View> orbit(const laplacian_lines::TriangleMesh& mesh);

/// All ways to redraw one mesh; cases are the eyes of orbit().
class Redraws {
public:
    /// Both outlive this.
    Redraws(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Field& field);
    ~Redraws();  ///< puts instruction set and number of threads back

    /// The default style without ridges and borders, which do not depend on the view, by
    /// instruction set and threads. They refer to this, like all that follow.
    std::vector<Contender> fast();
    /// Contours, each other kind worth timing, the default style, and all kinds, on one thread.
    /// Kinds that need C draw nothing without it.
    std::vector<Contender> kinds();
    /// Plain ways to draw less, on one thread.
    std::vector<Contender> plain();
    /// Reading the plain mesh's memory, and as much as the extractor holds.
    std::vector<Contender> reading();

    /// @throws std::runtime_error if the extractor's zeros are not as long as the plain loops'
    void check_zeros();

    std::size_t view_count() const { return views_.size(); }
    const laplacian_lines::LineExtractor& extractor() const { return *extractor_; }
    double extractor_seconds() const { return extractor_seconds_; }
    const laplacian_lines::LineSet& lines(std::size_t view) { return lines(view, style_); }
    const laplacian_lines::LineSet& lines(std::size_t view,
                                          const laplacian_lines::LineStyle& style);
    /// Triangles with zeros of Δn·l and of n·l.
    struct Crossings {
        std::size_t laplacian, contour;
    };
    Crossings crossings(std::size_t view);

private:
    Contender extraction(const std::string& key, const std::string& text,
                         laplacian_lines::InstructionSet set, int threads,
                         const laplacian_lines::LineStyle& style);
    void check_zeros(laplacian_lines::LineKind kind, PlainLines& plain);
    std::size_t plain_bytes() const;
    void read(std::size_t bytes);

    const laplacian_lines::TriangleMesh& mesh_;
    const std::vector<laplacian_lines::View> views_;
    const laplacian_lines::InstructionSet best_;
    const PlainMesh plain_;
    PlainLines contours_, laplacian_;
    const double diagonal_;
    laplacian_lines::LineStyle style_;
    double extractor_seconds_ = 0;
    std::unique_ptr<laplacian_lines::LineExtractor> extractor_;
    std::vector<std::uint64_t> memory_;
    volatile std::uint64_t sum_ = 0;
    laplacian_lines::ExtractionScratch scratch_;
    laplacian_lines::LineSet lines_;
    std::vector<Eigen::Vector3f> points_;
};

}  // namespace benchmarks
