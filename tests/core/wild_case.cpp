// SPDX-License-Identifier: GPL-3.0-or-later
#include "wild_case.h"

#include <algorithm>
#include <cmath>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"

namespace wild {

using namespace laplacian_lines;

namespace {

// Rays meet most of a tangle's triangles: sanitizers take half a minute for 500.
constexpr std::size_t kMostTrianglesForRays = 100;
constexpr std::uint8_t kNoVertex = 255;

/// Numbers by the bytes of a fuzzer or file; 0 after the last.
class Bytes {
public:
    Bytes(const std::uint8_t* bytes, std::size_t size) : next_(bytes), end_(bytes + size) {}

    std::uint8_t byte() { return next_ == end_ ? std::uint8_t(0) : *next_++; }
    bool are_left() const { return next_ != end_; }
    /// Any, not finite ones too.
    template <class Number>
    Number number() {
        Number number;
        auto* const to = reinterpret_cast<std::uint8_t*>(&number);
        for (std::size_t i = 0; i < sizeof number; ++i)
            to[i] = byte();
        return number;
    }
    Eigen::Vector3d vector() {
        const double x = number<double>(), y = number<double>();
        return {x, y, number<double>()};
    }

private:
    const std::uint8_t *next_, *end_;
};

template <class Options>
Options wild_options(const std::vector<OptionRow<Options>>& table, Bytes& bytes) {
    Options options;
    for (unsigned changes = bytes.byte() % 6; changes > 0; --changes) {
        const auto& row = table[bytes.byte() % table.size()];
        const bool is_real = row.kind == OptionKind::Real || row.kind == OptionKind::Length;
        row.set(options, is_real ? bytes.number<double>()
                                 : row.minimum + bytes.byte() % int(row.maximum - row.minimum + 1));
    }
    return options;
}

TriangleMesh wild_mesh(Bytes& bytes) {
    TriangleMesh mesh;
    mesh.positions.resize(bytes.byte());
    for (Eigen::Vector3d& p : mesh.positions)
        p = bytes.vector();
    mesh.triangles.resize(bytes.number<std::uint16_t>() % 512);
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t) {
            v = bytes.byte();
            if (v != kNoVertex && !mesh.positions.empty()) v %= mesh.positions.size();
        }
    return mesh;
}

View wild_view(const TriangleMesh& mesh, Bytes& bytes) {
    View view;
    view.w = bytes.byte() % 4 == 0 ? bytes.number<double>() : bytes.byte() % 2;
    const unsigned at_vertex = bytes.byte();
    view.eye = at_vertex < mesh.positions.size() ? mesh.positions[at_vertex] : bytes.vector();
    if (bytes.byte() % 4 == 1) view.light = bytes.vector();
    return view;
}

/// Any numbers, as far as there are bytes.
Field random_field(const TriangleMesh& mesh, Bytes& bytes) {
    Field field;
    field.scale = measure_scale(mesh);
    for (const FieldColumn& column : kFieldColumns) {
        column.resize(field, mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size() * std::size_t(column.floats); ++i)
            column.write(field)[i] = bytes.are_left() ? bytes.number<float>() : float(i % 7) - 3;
    }
    return field;
}

bool is_share(float x) {
    return x >= 0 && x <= 1;
}

bool is_positive(const FieldScale& s) {
    return std::isfinite(s.diagonal) && s.diagonal > 0 && std::isfinite(s.mean_edge) &&
           s.mean_edge > 0 && std::isfinite(s.kernel_size) && s.kernel_size > 0;
}

std::string lines_complaint(const TriangleMesh& mesh, const Field& field, Bytes& bytes) {
    const LineExtractor extractor(mesh, field);
    const View view = wild_view(mesh, bytes);
    const LineStyle style = bytes.byte() % 2 ? helpers::all_crossings_of_all_kinds()
                                             : wild_options(line_style_table(), bytes);
    const LineSet lines = helpers::extract(extractor, view, style);
    std::string found = violation(lines);
    if (found.empty() && !helpers::same_lines(lines, helpers::extract(extractor, view, style)))
        found = "the same view gives other lines";
    if (found.empty() && mesh.triangles.size() <= kMostTrianglesForRays)
        found = violation(mesh, extractor, view, style);
    return found;
}

}  // namespace

std::string violation(const TriangleMesh& mesh, const Field& field) {
    const std::size_t n = mesh.positions.size();
    if (!has_entries(field, n)) return "the field has another number of vertices";
    if (!is_positive(field.scale)) return "a length of the scale is not positive and finite";
    for (std::size_t v = 0; v < n; ++v) {
        const std::string at = " at vertex " + std::to_string(v);
        const float length = field.normals[v].norm();
        if (!(length == 0 || std::abs(length - 1) < 1e-4)) return "no unit normal" + at;
        if (!field.laplacian_normals[v].allFinite()) return "no finite Laplacian" + at;
        if (!helpers::matrix(field.shape_operators[v]).allFinite()) return "no finite tensor" + at;
        if (!field.has_derivatives()) continue;
        if (!field.smooth_curvatures[v].allFinite()) return "no finite smooth curvature" + at;
        if (!field.curvature_derivatives[v].allFinite()) return "no finite derivative" + at;
    }
    return {};
}

std::string violation(const LineSet& lines) {
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

std::string violation(const TriangleMesh& mesh, const LineExtractor& extractor, const View& view,
                      const LineStyle& style) {
    const LineVisibility visibility(mesh);
    ExtractionScratch scratch;
    const LineSet lines = extract_on_surface(extractor, view, style, scratch);
    std::string found;
    for (const bool in_picture : {false, true}) {
        const LineParts parts =
            visibility.parts(view, {lines}, {style.shows, style.line_smoothing, true, in_picture});
        if (found.empty()) found = violation(parts.seen);
        if (found.empty()) found = violation(parts.hidden);
    }
    return found;
}

std::string violation_of_bytes(const std::uint8_t* first, std::size_t size) {
    Bytes bytes(first, size);
    PrecomputeOptions options = wild_options(precompute_option_table(), bytes);
    options.curvature_derivatives = true;
    const bool makes_up = bytes.byte() % 4 == 1;
    const TriangleMesh mesh = wild_mesh(bytes);
    try {
        const Field field = makes_up ? random_field(mesh, bytes) : precompute(mesh, options);
        const std::string found = makes_up ? "" : violation(mesh, field);
        return found.empty() ? lines_complaint(mesh, field, bytes) : found;
    } catch (const Error& error) {
        const std::string sentence = error.what();
        return sentence.empty() || sentence.back() != '.' ? "no sentence: " + sentence : "";
    }
}

std::vector<std::uint8_t> bytes_of(const TriangleMesh& mesh) {
    std::vector<std::uint8_t> bytes = {0, 0};  // no option changed, the mesh's own field
    const auto add = [&](auto number) {
        const auto* first = reinterpret_cast<const std::uint8_t*>(&number);
        bytes.insert(bytes.end(), first, first + sizeof number);
    };
    const auto vertices = std::min<std::size_t>(mesh.positions.size(), kNoVertex - 1);
    add(std::uint8_t(vertices));
    for (std::size_t v = 0; v < vertices; ++v)
        for (const double x : mesh.positions[v])
            add(x);
    std::vector<Triangle> triangles;
    for (const Triangle& t : mesh.triangles)
        if (triangles.size() < 511 && *std::max_element(t.begin(), t.end()) < vertices)
            triangles.push_back(t);
    add(std::uint16_t(triangles.size()));
    for (const Triangle& t : triangles)
        for (const std::uint32_t v : t)
            add(std::uint8_t(v));
    return bytes;
}

}  // namespace wild
