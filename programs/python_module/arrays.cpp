// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include "laplacian_lines/field_columns.h"

namespace python_module {

namespace nb = nanobind;
using namespace nb::literals;
using namespace laplacian_lines;

namespace {

/// An array that owns the numbers read(row, column); one-dimensional if it has one column.
template <class Number, class Read>
nb::object array(std::size_t rows, std::size_t columns, const Read& read) {
    auto* numbers = new std::vector<Number>;
    const nb::capsule owner(numbers,
                            [](void* p) noexcept { delete static_cast<std::vector<Number>*>(p); });
    numbers->reserve(rows * columns);
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j)
            numbers->push_back(Number(read(i, j)));
    const std::size_t shape[] = {rows, columns};
    return nb::cast(
        nb::ndarray<nb::numpy, Number>(numbers->data(), columns == 1 ? 1 : 2, shape, owner));
}

template <class Number, class Row, class Value>
nb::object array_of(const std::vector<Row>& rows, Value Row::*member) {
    return array<Number>(rows.size(), 1,
                         [&](std::size_t i, std::size_t) { return rows[i].*member; });
}

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
    const auto position = [&](std::size_t i, std::size_t j) { return mesh.positions[i][j]; };
    const auto corner = [&](std::size_t i, std::size_t j) { return mesh.triangles[i][j]; };
    return nb::make_tuple(array<double>(mesh.positions.size(), 3, position),
                          array<std::uint32_t>(mesh.triangles.size(), 3, corner));
}

nb::dict arrays_of(const Field& field) {
    nb::dict result;
    for (const FieldColumn& column : present_columns(field)) {
        const float* numbers = column.read(field);
        for (const FieldAttribute& attribute : column.attributes) {
            if (attribute.floats == 0) continue;
            result[attribute.name] = array<float>(
                column.size(field), attribute.floats,
                [&](std::size_t i, std::size_t j) { return numbers[i * column.floats + j]; });
            numbers += attribute.floats;
        }
    }
    return result;
}

nb::dict arrays_of(const std::vector<ViewLine>& lines) {
    std::vector<ViewLinePoint> points;
    std::vector<std::size_t> offsets{0};
    for (const ViewLine& line : lines) {
        points.insert(points.end(), line.points.begin(), line.points.end());
        offsets.push_back(points.size());
    }
    using Flag = std::uint8_t;
    return dict_of(
        "points"_a = array<double>(
            points.size(), 3, [&](std::size_t i, std::size_t j) { return points[i].position[j]; }),
        "weights"_a = array_of<float>(points, &ViewLinePoint::weight),
        "gradients"_a = array_of<float>(points, &ViewLinePoint::gradient),
        "opacities"_a = array_of<float>(points, &ViewLinePoint::opacity),
        "offsets"_a = array<std::int64_t>(offsets.size(), 1,
                                          [&](std::size_t i, std::size_t) { return offsets[i]; }),
        "kinds"_a = array_of<std::uint8_t>(lines, &ViewLine::kind),
        "strengths"_a = array_of<float>(lines, &ViewLine::strength),
        "closed"_a = array_of<Flag>(lines, &ViewLine::closed),
        "hidden"_a = array_of<Flag>(lines, &ViewLine::is_hidden),
        "outline"_a = array_of<Flag>(lines, &ViewLine::is_outline));
}

}  // namespace python_module
