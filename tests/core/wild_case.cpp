// SPDX-License-Identifier: GPL-3.0-or-later
#include "wild_case.h"

#include <cmath>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"
#include "wild_mesh.h"

namespace wild {

using namespace laplacian_lines;
using test_meshes::Choices;

namespace {

// Rays meet most of a tangle's triangles: sanitizers take half a minute for 500.
constexpr std::size_t kMostTrianglesForRays = 100;

/// Mostly in range, else the least, the largest or odd.
template <class Options>
Options wild_options(const std::vector<OptionDescription<Options>>& table, Choices& choices) {
    Options options;
    for (unsigned changes = choices.below(6); changes > 0; --changes) {
        const auto& row = table[choices.byte() % table.size()];
        const bool is_real = row.kind == OptionKind::Real || row.kind == OptionKind::Length;
        const double span = row.maximum < 1e300 ? row.maximum - row.minimum : 4;
        switch (choices.below(5)) {
            case 0:
                row.set(options, row.minimum);
                break;
            case 1:
                row.set(options, row.maximum);
                break;
            case 2:
                if (is_real) row.set(options, test_meshes::odd_number(choices));
                break;
            default:
                row.set(options, row.minimum + (is_real ? span * std::pow(choices.unit(), 4)
                                                        : choices.below(unsigned(span) + 1)));
        }
    }
    return options;
}

Eigen::Vector3d wild_vector(const TriangleMesh& mesh, Choices& choices) {
    const auto odd = [&] { return test_meshes::odd_number(choices); };
    const auto vertex = [&]() -> Eigen::Vector3d {
        if (mesh.positions.empty()) return Eigen::Vector3d::Zero();
        return mesh.positions[choices.word() % mesh.positions.size()];
    };
    Eigen::Vector3d v;
    switch (choices.below(5)) {
        case 0:
            return vertex();
        case 1:
            v = vertex();
            return v + 1e-3 * vertex();
        case 2:
            v = vertex();
            v[choices.below(3)] = odd();
            return v;
        case 3:
            for (double& x : v)
                x = odd();
            return v;
        default:
            for (double& x : v)
                x = 20 * choices.unit() - 10;
            return v;
    }
}

View wild_view(const TriangleMesh& mesh, Choices& choices) {
    View view = View::perspective(wild_vector(mesh, choices));
    if (choices.one_in(3)) view.w = 0;
    if (choices.one_in(8)) view.w = test_meshes::odd_number(choices);
    if (choices.one_in(4)) view.light = wild_vector(mesh, choices);
    return view;
}

float wild_float(Choices& choices) {
    return choices.one_in(64) ? float(test_meshes::odd_number(choices))
                              : choices.byte() / 128.f - 1;
}

/// Any numbers, few not finite.
Field made_up_field(const TriangleMesh& mesh, Choices& choices) {
    Field field;
    for (std::size_t v = 0; v < mesh.positions.size() && !choices.exhausted(); ++v) {
        const auto vector = [&] {
            const float x = wild_float(choices), y = wild_float(choices);
            return Eigen::Vector3f(x, y, wild_float(choices));
        };
        field.normals.push_back(vector());
        field.laplacian_normals.push_back(10 * vector());
        const Eigen::Vector3f a = 10 * vector(), b = 10 * vector();
        field.shape_operators.push_back({a.x(), a.y(), a.z(), b.x(), b.y(), b.z()});
        field.kernel_sizes.push_back(wild_float(choices));
        field.smooth_curvatures.push_back({b.y(), a.z(), b.x()});
        field.curvature_derivatives.push_back({10 * a.y(), 10 * b.x(), 10 * a.x(), 10 * b.z()});
    }
    const std::size_t count = mesh.positions.size() + choices.one_in(32);
    field.normals.resize(count, Eigen::Vector3f::UnitX());
    field.laplacian_normals.resize(count, Eigen::Vector3f::UnitY());
    field.shape_operators.resize(count);
    field.kernel_sizes.resize(count, 0.1f);
    field.smooth_curvatures.resize(count, Eigen::Vector3f(3, -2, 1));
    field.curvature_derivatives.resize(count, Eigen::Vector4f(1, 2, 3, 4));
    field.scale = measure_scale(mesh);
    return field;
}

bool is_share(float x) {
    return x >= 0 && x <= 1;
}

bool is_positive(const FieldScale& s) {
    return std::isfinite(s.diagonal) && s.diagonal > 0 && std::isfinite(s.mean_edge) &&
           s.mean_edge > 0 && std::isfinite(s.kernel_size) && s.kernel_size > 0;
}

/// Of what is seen and hidden, in space and in the picture.
std::string look_complaint(const TriangleMesh& mesh, const LineExtractor& extractor,
                           const View& view, const LineStyle& style) {
    const LineVisibility visibility(mesh);
    ExtractionScratch scratch;
    const LineSet lines = extract_on_surface(extractor, view, style, scratch);
    std::string found;
    for (const bool in_picture : {false, true}) {
        const LineParts parts =
            visibility.parts(view, {lines}, {style.shows, style.line_smoothing, true, in_picture});
        if (found.empty()) found = complaint(parts.seen);
        if (found.empty()) found = complaint(parts.hidden);
    }
    return found;
}

std::string extract_views(const TriangleMesh& mesh, const Field& field, Choices& choices) {
    const LineExtractor extractor(mesh, field);
    ExtractionScratch scratch;
    LineSet lines;
    for (unsigned views = 1 + choices.below(4); views > 0; --views) {
        const View view = wild_view(mesh, choices);
        const LineStyle style = choices.one_in(2) ? helpers::all_crossings_of_all_kinds()
                                                  : wild_options(line_style_table(), choices);
        try {
            extractor.extract(view, style, scratch, lines);
        } catch (const Error&) {  // of the view or the style; the next one is welcome
            continue;
        }
        std::string found = complaint(lines);
        if (found.empty() && !helpers::same_lines(lines, helpers::extract(extractor, view, style)))
            found = "the same view gives other lines";
        if (found.empty() && choices.one_in(4) && mesh.triangles.size() <= kMostTrianglesForRays)
            found = look_complaint(mesh, extractor, view, style);
        if (!found.empty()) return found;
    }
    return {};
}

}  // namespace

std::string complaint(const TriangleMesh& mesh, const Field& field) {
    const std::size_t n = mesh.positions.size();
    if (!has_entries(field, n)) return "the field has another number of vertices";
    if (!is_positive(field.scale)) return "a length of the scale is not positive and finite";
    for (std::size_t v = 0; v < n; ++v) {
        const std::string at = " at vertex " + std::to_string(v);
        const float length = field.normals[v].norm();
        if (!(length == 0 || std::abs(length - 1) < 1e-4)) return "no unit normal" + at;
        if (!field.laplacian_normals[v].allFinite()) return "no finite Laplacian" + at;
        if (!helpers::matrix(field.shape_operators[v]).allFinite()) return "no finite tensor" + at;
        if (!std::isfinite(field.kernel_sizes[v]) || field.kernel_sizes[v] < 0)
            return "no finite kernel size" + at;
        if (!field.has_derivatives()) continue;
        if (!field.smooth_curvatures[v].allFinite()) return "no finite smooth curvature" + at;
        if (!field.curvature_derivatives[v].allFinite()) return "no finite derivative" + at;
    }
    return {};
}

std::string complaint(const LineSet& lines) {
    std::size_t points = 0;
    for (const Polyline& line : lines.lines) {
        if (line.first != points) return "lines are not one after the other";
        if (line.count < 2) return "a line of fewer than two points";
        points += line.count;
        if (points > lines.points.size()) return "a line beyond the last point";
        if (!std::isfinite(line.strength) || !std::isfinite(line.length) ||
            !std::isfinite(line.slope))
            return "a line without a finite strength, length or slope";
        if (line.closed && lines.points[line.first].position != lines.points[points - 1].position)
            return "a closed line that is open";
    }
    if (points != lines.points.size()) return "points without a line";
    for (const LinePoint& p : lines.points) {
        if (!p.position.allFinite()) return "a point that is not finite";
        if (!std::isfinite(p.gradient)) return "a gradient that is not finite";
        if (!is_share(p.weight) || !is_share(p.opacity)) return "a weight or opacity not in 0..1";
    }
    return {};
}

std::string precompute_case(Choices& choices) {
    const PrecomputeOptions options = wild_options(precompute_option_table(), choices);
    const TriangleMesh mesh = test_meshes::wild_mesh(choices, true);
    try {
        const Field field = precompute(mesh, options);
        return complaint(mesh, field);
    } catch (const Error& error) {
        const std::string sentence = error.what();
        return sentence.empty() || sentence.back() != '.' ? "no sentence: " + sentence : "";
    }
}

std::string extract_case(Choices& choices) {
    const bool make_up = choices.one_in(3);
    const TriangleMesh mesh = test_meshes::wild_mesh(choices, true);
    try {
        return extract_views(
            mesh, make_up ? made_up_field(mesh, choices) : helpers::complete_field(mesh), choices);
    } catch (const Error&) {
        return {};
    }
}

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes joined(Bytes first, const Bytes& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

}  // namespace

Bytes precompute_seed(const TriangleMesh& mesh) {
    return joined({0}, test_meshes::wild_mesh_bytes(mesh));
}

Bytes precompute_seed(const TriangleMesh& mesh, unsigned changed_option) {
    const std::uint8_t row = std::uint8_t(changed_option), end = changed_option % 2;
    return joined({1, row, end}, test_meshes::wild_mesh_bytes(mesh));
}

Bytes extract_seed(const TriangleMesh& mesh, unsigned seed) {
    const std::uint8_t field_of_mesh = 0;
    return joined(joined({field_of_mesh}, test_meshes::wild_mesh_bytes(mesh)),
                  test_meshes::random_bytes(seed, 100));
}

}  // namespace wild
