// SPDX-License-Identifier: GPL-3.0-or-later
// _core: internals of the Python package laplacian_lines, which documents them.
#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "arrays.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/version.h"
#include "line_drawing/atomic_file.h"
#include "mesh_files/mesh_file.h"
#include "surface.h"

namespace nb = nanobind;
using namespace nb::literals;
using namespace laplacian_lines;
using namespace python_module;

namespace {

using Values = std::map<std::string, double>;
using Direction = std::array<double, 3>;

template <class Options>
nb::list rows_of(const std::vector<OptionRow<Options>>& table) {
    constexpr const char* kinds[] = {"real", "length", "boolean", "choice"};  // as OptionKind
    nb::list rows;
    for (const auto& row : table) {
        const bool is_limited = row.maximum != kUnlimited;
        rows.append(dict_of("key"_a = row.key, "help"_a = row.help,
                            "kind"_a = kinds[std::size_t(row.kind)], "minimum"_a = row.minimum,
                            "maximum"_a = is_limited ? nb::cast(row.maximum) : nb::none(),
                            "choices"_a = list_of(row.choices), "default"_a = row.get(Options())));
    }
    return rows;
}

/// Unknown keys are a bug of the package: it looks them up before.
template <class Options>
Options options_of(const std::vector<OptionRow<Options>>& table, const Values& values) {
    Options options;
    for (const auto& row : table)
        if (const auto found = values.find(row.key); found != values.end())
            row.set(options, found->second);
    validate(options);
    return options;
}

nb::list columns() {
    nb::list rows;
    for (const FieldColumn& column : kFieldColumns)
        for (const FieldAttribute& attribute : column.attributes)
            if (attribute.floats > 0)
                rows.append(dict_of("name"_a = attribute.name, "numbers"_a = attribute.floats,
                                    "help"_a = column.help, "unit"_a = column.unit,
                                    "optional"_a = column.optional));
    return rows;
}

nb::list kinds() {
    nb::list rows;
    for (const LineKindDescription& kind : kLineKinds)
        rows.append(dict_of("key"_a = kind.key, "one"_a = kind.one, "many"_a = kind.many,
                            "outline"_a = kind.bounds_form, "color"_a = kind.color,
                            "width"_a = kind.width));
    return rows;
}

nb::list keys_of_kinds(const std::string& names) {
    const std::optional<LineKindSet> set = kinds_named(names);
    if (!set)
        refuse("\"" + names + "\" are not kinds of lines. Kinds and mixtures of them are " +
               names_of_kinds() + ".");
    nb::list keys;
    for (const LineKindDescription& kind : kLineKinds)
        if ((*set)[kind.kind]) keys.append(kind.key);
    return keys;
}

View view_of(const Direction& eye, double w, const std::optional<Direction>& light) {
    View view;
    view.eye = Eigen::Vector3d(eye.data());
    view.w = w;
    if (light) view.light = Eigen::Vector3d(light->data());
    return view;
}

void make_surface(Surface* place, const Positions& positions, const Triangles& triangles,
                  const Values& values) {
    const PrecomputeOptions options = options_of(precompute_option_table(), values);
    TriangleMesh mesh = mesh_of(positions, triangles);
    unlocked([&](const Progress& progress) {
        return new (place) Surface(std::move(mesh), options, progress);
    });
}

nb::dict lines(Surface& surface, const Direction& eye, double w,
               const std::optional<Direction>& light, const Values& values) {
    const LineStyle style = options_of(line_style_table(), values);
    return arrays_of(unlocked([&](const Progress& progress) {
        return surface.lines(view_of(eye, w, light), style, progress);
    }));
}

nb::dict visible_lines(Surface& surface, const Direction& eye, double w,
                       const std::optional<Direction>& light, const Values& values, bool hidden,
                       bool in_picture) {
    const LineStyle style = options_of(line_style_table(), values);
    VisibilityOptions options;
    options.has_hidden = hidden;
    options.in_picture = in_picture;
    return arrays_of(unlocked([&](const Progress& progress) {
        return surface.visible_lines(view_of(eye, w, light), style, options, progress);
    }));
}

/// The strokes of a picture with these axes, which are also those of the light.
nb::dict strokes(Surface& surface, const std::array<Direction, 3>& axes,
                 const std::optional<Direction>& eye, const std::optional<Direction>& light,
                 const Values& values, double size) {
    line_drawing::ViewFrame frame;
    frame.side = line_drawing::Side::Other;
    frame.right = Eigen::Vector3d(axes[0].data());
    frame.up = Eigen::Vector3d(axes[1].data());
    frame.towards_viewer = Eigen::Vector3d(axes[2].data());
    if (eye) frame.eye = Eigen::Vector3d(eye->data());
    line_drawing::SheetOptions options;
    options.style = line_drawing::style_on_paper(options_of(line_style_table(), values));
    if (light) options.light = Eigen::Vector3d(light->data());
    return arrays_of(unlocked(
        [&](const Progress& progress) { return surface.strokes(frame, options, size, progress); }));
}

nb::dict field(const Surface& surface) {
    return arrays_of(unlocked([&](const Progress&) { return surface.field(); }));
}

nb::dict measures(const Surface& surface) {
    const FieldScale& scale = surface.scale();
    const MeshReport& report = surface.report();
    return dict_of("diagonal"_a = scale.diagonal, "mean_edge"_a = scale.mean_edge,
                   "kernel_size"_a = scale.kernel_size, "normal_sigma"_a = scale.normal_sigma,
                   "roughness"_a = report.roughness,
                   "non_finite_vertices"_a = report.non_finite_vertices,
                   "unreferenced_vertices"_a = report.unreferenced_vertices,
                   "degenerate_triangles"_a = report.degenerate_triangles,
                   "welded_vertices"_a = report.welded_vertices,
                   "flipped_triangles"_a = report.flipped_triangles);
}

nb::object read_mesh(const std::string& ending, const nb::bytes& bytes) {
    const std::optional<mesh_files::Format> format = mesh_files::format_of(ending);
    if (!format) return nb::none();
    const mesh_files::MeshInFile read = unlocked([&](const Progress&) {
        return mesh_files::read_mesh(*format, {bytes.c_str(), bytes.size()});
    });
    return arrays_of(read.mesh) + nb::make_tuple(read.defect, read.remark);
}

/// Whole or not at all.
void write_atomically(const nb::bytes& file, const nb::bytes& content) {
    line_drawing::write_atomically({file.c_str(), file.size()}, {content.c_str(), content.size()});
}

}  // namespace

NB_MODULE(_core, m) {
    nb::exception<Error>(m, "Error", PyExc_ValueError);
    m.attr("version") = version();
    m.attr("field_options") = rows_of(precompute_option_table());
    m.attr("line_options") = rows_of(line_style_table());
    m.attr("sheet_options") = sheet_options();
    m.attr("columns") = columns();
    m.attr("kinds") = kinds();
    m.def("keys_of_kinds", keys_of_kinds);
    m.def("draw", draw);
    m.def("read_mesh", read_mesh);
    m.def("write_atomically", write_atomically);
    nb::class_<Surface>(m, "Surface")
        .def("__init__", make_surface)
        .def("field", field)
        .def("measures", measures)
        .def("lines", lines)
        .def("visible_lines", visible_lines)
        .def("strokes", strokes);
}
