// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include <utility>

#include "laplacian_lines/field_columns.h"

namespace python_module {

namespace nb = nanobind;
using namespace nb::literals;
using namespace laplacian_lines;

namespace {

/// Owns its numbers; flat if it has one column.
template <class Number>
nb::object array(std::vector<Number>&& numbers, std::size_t columns = 1) {
    auto* kept = new std::vector<Number>(std::move(numbers));
    const nb::capsule owner(kept,
                            [](void* p) noexcept { delete static_cast<std::vector<Number>*>(p); });
    const std::size_t shape[] = {kept->size() / columns, columns};
    return nb::cast(
        nb::ndarray<nb::numpy, Number>(kept->data(), columns == 1 ? 1 : 2, shape, owner));
}

template <class Number, class Rows>
nb::object array_of_rows(const Rows& rows) {
    std::vector<Number> numbers;
    numbers.reserve(3 * rows.size());
    for (const auto& row : rows)
        for (int i = 0; i < 3; ++i)
            numbers.push_back(row[i]);
    return array(std::move(numbers), 3);
}

struct LineArrays {
    std::vector<double> points;
    std::vector<float> weights, gradients, opacities, strengths;
    std::vector<std::int64_t> offsets{0};
    std::vector<std::uint8_t> kinds, closed, hidden, outline;

    template <class Point>
    void add_point(const Eigen::Vector3d& place, const Point& point) {
        points.insert(points.end(), place.begin(), place.end());
        weights.push_back(point.weight);
        gradients.push_back(point.gradient);
        opacities.push_back(point.opacity);
    }
    template <class Line>
    void end_line(const Line& line, bool is_hidden, bool is_outline) {
        offsets.push_back(std::int64_t(weights.size()));
        strengths.push_back(line.strength);
        kinds.push_back(std::uint8_t(line.kind));
        closed.push_back(line.closed);
        hidden.push_back(is_hidden);
        outline.push_back(is_outline);
    }
    nb::dict hand_over() {
        return dict_of(
            "points"_a = array(std::move(points), 3), "weights"_a = array(std::move(weights)),
            "gradients"_a = array(std::move(gradients)),
            "opacities"_a = array(std::move(opacities)),
            "strengths"_a = array(std::move(strengths)), "offsets"_a = array(std::move(offsets)),
            "kinds"_a = array(std::move(kinds)), "closed"_a = array(std::move(closed)),
            "hidden"_a = array(std::move(hidden)), "outline"_a = array(std::move(outline)));
    }
};

}  // namespace

TriangleMesh mesh_of(const Positions& positions, const Triangles& triangles) {
    TriangleMesh mesh;
    mesh.positions.reserve(positions.shape(0));
    for (std::size_t i = 0; i < positions.shape(0); ++i)
        mesh.positions.emplace_back(positions.data() + 3 * i);
    mesh.triangles.reserve(triangles.shape(0));
    for (std::size_t i = 0; i < triangles.shape(0); ++i) {
        const std::uint32_t* corners = triangles.data() + 3 * i;
        mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    }
    return mesh;
}

nb::tuple arrays_of(const TriangleMesh& mesh) {
    return nb::make_tuple(array_of_rows<double>(mesh.positions),
                          array_of_rows<std::uint32_t>(mesh.triangles));
}

nb::dict arrays_of(const Field& field) {
    nb::dict result;
    for (const FieldColumn& column : present_columns(field)) {
        const std::size_t entries = column.size(field);
        int first = 0;
        for (const FieldAttribute& attribute : column.attributes) {
            if (attribute.floats == 0) continue;
            std::vector<float> numbers;
            numbers.reserve(entries * attribute.floats);
            for (std::size_t i = 0; i < entries; ++i) {
                const float* entry = column.read(field) + i * column.floats + first;
                numbers.insert(numbers.end(), entry, entry + attribute.floats);
            }
            result[attribute.name] = array(std::move(numbers), attribute.floats);
            first += attribute.floats;
        }
    }
    return result;
}

nb::dict arrays_of(const LineSet& set) {
    LineArrays arrays;
    for (const Polyline& line : set.lines) {
        for (std::uint32_t i = 0; i < line.count; ++i)
            arrays.add_point(set.place(set.points[line.first + i]), set.points[line.first + i]);
        arrays.end_line(line, false, false);
    }
    return arrays.hand_over();
}

nb::dict arrays_of(const std::vector<SightLine>& lines) {
    LineArrays arrays;
    for (const SightLine& line : lines) {
        for (const SightPoint& point : line.points)
            arrays.add_point(point.position, point);
        arrays.end_line(line, line.is_hidden, line.is_outline);
    }
    return arrays.hand_over();
}

}  // namespace python_module
