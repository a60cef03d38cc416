// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraws.h"

#include <thread>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/threads.h"

namespace benchmarks {

using namespace laplacian_lines;

namespace {

constexpr double kOrbitRadius = 1.25;  // in D

const char* name_of(InstructionSet set) {
    switch (set) {
        case InstructionSet::Avx512:
            return "AVX-512";
        case InstructionSet::Avx2:
            return "AVX2";
        default:
            return "baseline x86-64";
    }
}

/// Like the plain loops.
LineStyle all_zeros(LineKind kind) {
    LineStyle style;
    style.gradient_threshold = style.strength_threshold = 0;
    style.segment_slope = style.line_slope = style.line_smoothing = 0;
    style.shortest_line = style.shortest_contour = 0;
    style.reject_phantoms = style.single_strokes = style.shows[LineKind::Ridge] =
        style.shows[LineKind::Border] = style.shows[LineKind::Crease] = style.exact_outlines =
            false;
    style.least_facing = -1;
    style.shows[LineKind::Laplacian] = kind == LineKind::Laplacian;
    style.shows[LineKind::Contour] = kind == LineKind::Contour;
    return style;
}

}  // namespace

std::vector<View> orbit(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh.positions)
        if (p.allFinite()) box.extend(p);
    std::vector<View> views;
    for (int i = 0; i < kEyes; ++i) {
        const double angle = 2 * std::acos(-1.0) * i / kEyes;
        const Eigen::Vector3d direction(std::cos(angle), 0.4, std::sin(angle));
        views.push_back(View::perspective(box.center() + kOrbitRadius * box.diagonal().norm() *
                                                             direction.normalized()));
    }
    return views;
}

Redraws::Redraws(const TriangleMesh& mesh, const Field& field)
    : mesh_(mesh),
      views_(orbit(mesh)),
      best_(instruction_set()),
      plain_(mesh),
      contours_(plain_, field.normals),
      laplacian_(plain_, field.laplacian_normals),
      diagonal_(field.scale.diagonal) {
    style_.shows[LineKind::Ridge] = style_.shows[LineKind::Border] =
        style_.shows[LineKind::Crease] = false;
    const auto build = [&] { extractor_ = std::make_unique<LineExtractor>(mesh, field); };
    extractor_seconds_ = seconds(build);
    memory_.assign(std::max(plain_bytes(), extractor_->memory()) / sizeof(memory_[0]), 1);
}

Redraws::~Redraws() {
    use_instruction_set(best_);
    set_thread_limit(0);
}

Contender Redraws::extraction(const std::string& key, const std::string& text, InstructionSet set,
                              int threads, const LineStyle& style) {
    return {key, text, [this, set, threads, style](std::size_t view) {
                use_instruction_set(set);
                set_thread_limit(threads);
                lines(view, style);
            }};
}

std::vector<Contender> Redraws::fast() {
    std::vector<Contender> contenders = {extraction(
        "lines", std::string("Laplacian lines and contours, ") + name_of(best_), best_, 1, style_)};
    if (int(std::thread::hardware_concurrency()) > 1)
        contenders.push_back(
            extraction("lines_two_threads", "the same on two threads", best_, 2, style_));
    for (const auto& [set, key] : {std::pair{InstructionSet::Avx2, "lines_avx2"},
                                   {InstructionSet::Baseline, "lines_baseline"}})
        if (set != best_ && use_instruction_set(set))
            contenders.push_back(
                extraction(key, std::string("the same by ") + name_of(set), set, 1, style_));
    contenders.push_back(
        extraction("default_style", "the same with ridges and borders", best_, 1, LineStyle()));
    return contenders;
}

std::vector<Contender> Redraws::kinds() {
    std::vector<Contender> contenders;
    LineStyle style;
    for (const LineKind kind :
         {LineKind::Contour, LineKind::Laplacian, LineKind::SuggestiveContour,
          LineKind::SuggestiveHighlight, LineKind::ApparentRidge, LineKind::PhoticExtremum,
          LineKind::Ridge, LineKind::Valley, LineKind::DemarcatingCurve}) {
        style.shows = only_kinds({kind});
        contenders.push_back(extraction(describe(kind).key, describe(kind).many, best_, 1, style));
    }
    contenders.push_back(extraction("default", "the default style", best_, 1, LineStyle()));
    style.shows = all_kinds();
    contenders.push_back(extraction("all", "all kinds at once", best_, 1, style));
    return contenders;
}

std::vector<Contender> Redraws::plain() {
    return {
        {"plain_contours", "plain contours, not traced",
         [this](std::size_t view) { contours_.extract(views_[view], points_); }},
        {"plain_laplacian", "plain Laplacian lines, not traced",
         [this](std::size_t view) { laplacian_.extract(views_[view], points_); }},
    };
}

std::vector<Contender> Redraws::reading() {
    return {
        {"read_plain_mesh", "reading 16 bytes a vertex, 12 a triangle",
         [this](std::size_t) { read(plain_bytes()); }},
        {"read_extractor", "reading as many bytes as the extractor holds",
         [this](std::size_t) { read(extractor_->memory()); }},
    };
}

std::size_t Redraws::plain_bytes() const {
    return 16 * mesh_.positions.size() + 12 * mesh_.triangles.size();
}

void Redraws::read(std::size_t bytes) {
    const auto end = memory_.begin() + std::ptrdiff_t(bytes / sizeof(memory_[0]));
    sum_ = std::accumulate(memory_.begin(), end, std::uint64_t(0));
}

void Redraws::check_zeros() {
    check_zeros(LineKind::Contour, contours_);
    check_zeros(LineKind::Laplacian, laplacian_);
}

void Redraws::check_zeros(LineKind kind, PlainLines& plain) {
    extractor_->extract(views_[0], all_zeros(kind), scratch_, lines_);
    plain.extract(views_[0], points_);
    double length = 0, expected = 0;
    for (const Polyline& line : lines_.lines)
        length += line.length;
    for (std::size_t i = 1; i < points_.size(); i += 2)
        expected += (points_[i] - points_[i - 1]).norm() / diagonal_;
    if (std::abs(length - expected) > 1e-3 * expected)
        throw std::runtime_error("the extractor finds zeros of a length of " +
                                 std::to_string(length) + " D, the plain loop of " +
                                 std::to_string(expected));
}

const LineSet& Redraws::lines(std::size_t view, const LineStyle& style) {
    extractor_->extract(views_[view], style, scratch_, lines_);
    return lines_;
}

Redraws::Crossings Redraws::crossings(std::size_t view) {
    laplacian_.extract(views_[view], points_);
    const std::size_t laplacian = points_.size() / 2;
    contours_.extract(views_[view], points_);
    return {laplacian, points_.size() / 2};
}

}  // namespace benchmarks
