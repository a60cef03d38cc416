// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "laplacian_lines/line_extractor.h"
#include "naive_lines.h"
#include "naive_tracing.h"
#include "redraw/simd/simd_functions.h"
#include "suggestive_contours.h"
#include "turns.h"

namespace benchmarks {

/// All ways to redraw one mesh, seen by the eyes of orbit.h. Their cases are the eyes.
class Redraws {
public:
    /// Both have to outlive this object.
    Redraws(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Field& field);
    ~Redraws();  ///< puts instruction set and number of threads back

    /// The extractor in the default style, but for ridges and borders, which do not depend on the
    /// view; by instruction set and threads. They use this object.
    std::vector<Contender> fast();
    /// Each style of kind_styles(), likewise. Kinds that need C have nothing to draw without it.
    std::vector<Contender> kinds();
    /// Plain ways to draw less, on one thread. They use this object.
    std::vector<Contender> plain();
    /// Reading the memory of the plain mesh, and as much as the extractor holds.
    std::vector<Contender> reading();

    /// @throws std::runtime_error if the zeros that the extractor finds are not as long as those of
    /// the plain loops.
    void check_zeros();

    std::size_t view_count() const { return views_.size(); }
    const laplacian_lines::LineExtractor& extractor() const { return *extractor_; }
    double extractor_seconds() const { return extractor_seconds_; }
    double curvature_seconds() const { return curvature_seconds_; }
    /// Of a view, in the style of fast().
    const laplacian_lines::LineSet& lines(std::size_t view);
    /// Triangles that zeros of Δn·l, of n·l, and suggestive contours pass.
    struct Crossings {
        std::size_t laplacian, contour, suggestive;
    };
    Crossings crossings(std::size_t view);

private:
    Contender extraction(const std::string& key, const std::string& text,
                         laplacian_lines::InstructionSet set, int threads,
                         const laplacian_lines::LineStyle& style);
    void check_zeros(laplacian_lines::LineKind kind, NaiveLines& plain);
    std::size_t plain_bytes() const;
    void read(std::size_t bytes);

    const laplacian_lines::TriangleMesh& mesh_;
    const std::vector<laplacian_lines::View> views_;
    const laplacian_lines::InstructionSet best_;
    const PlainMesh plain_;
    NaiveLines contours_, laplacian_;
    NaiveTracing traced_;
    const double diagonal_;
    laplacian_lines::LineStyle style_;
    double extractor_seconds_ = 0, curvature_seconds_ = 0;
    std::unique_ptr<laplacian_lines::LineExtractor> extractor_;
    std::unique_ptr<SuggestiveContours> suggestive_;
    std::vector<std::uint64_t> memory_;
    volatile std::uint64_t sum_ = 0;
    laplacian_lines::ExtractionScratch scratch_;
    laplacian_lines::LineSet lines_;
    std::vector<Eigen::Vector3f> points_;
    std::vector<std::uint32_t> starts_;
};

}  // namespace benchmarks
