// SPDX-License-Identifier: GPL-3.0-or-later
// _core: internals of the Python package laplacian_lines, which documents them.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <limits>

#include "arrays.h"
#include "drawing.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/version.h"
#include "mesh_files/mesh_file.h"
#include "surface.h"

namespace nb = nanobind;
using namespace nb::literals;
using namespace laplacian_lines;
using namespace python_module;

namespace {

using Values = std::map<std::string, double>;
using Direction = std::array<double, 3>;

const char* name_of(OptionKind kind) {
    constexpr const char* names[] = {"real", "length", "boolean", "choice"};
    return names[std::size_t(kind)];
}

template <class Options>
nb::list rows_of(const std::vector<OptionDescription<Options>>& table) {
    nb::list rows;
    for (const auto& row : table) {
        nb::dict d;
        d["key"] = row.key;
        d["help"] = row.help;
        d["kind"] = name_of(row.kind);
        d["minimum"] = row.minimum;
        d["maximum"] =
            row.maximum == std::numeric_limits<double>::max() ? nb::none() : nb::cast(row.maximum);
        nb::list choices;
        for (const char* choice : row.choices)
            choices.append(choice);
        d["choices"] = choices;
        d["default"] = row.get(Options());
        rows.append(d);
    }
    return rows;
}

/// Unknown keys are a bug of the package: it looks them up before.
template <class Options>
Options options_of(const std::vector<OptionDescription<Options>>& table, const Values& values,
                   Options options = {}) {
    for (const auto& row : table)
        if (const auto found = values.find(row.key); found != values.end())
            row.set(options, found->second);
    validate(options);
    return options;
}

nb::list columns() {
    nb::list rows;
    for (const FieldColumn& column : field_columns)
        for (const FieldAttribute& attribute : column.attributes) {
            if (attribute.floats == 0) continue;
            nb::dict d;
            d["name"] = attribute.name;
            d["numbers"] = attribute.floats;
            d["help"] = column.help;
            d["unit"] = column.unit;
            d["optional"] = column.optional;
            rows.append(d);
        }
    return rows;
}

nb::list kinds() {
    nb::list rows;
    for (const LineKindDescription& kind : line_kinds) {
        nb::dict d;
        d["key"] = kind.key;
        d["one"] = kind.one;
        d["many"] = kind.many;
        d["outline"] = kind.is_outline;
        d["color"] = kind.color;
        d["width"] = kind.width;
        rows.append(d);
    }
    return rows;
}

nb::list keys_of_kinds(const std::string& names) {
    const std::optional<LineKindSet> set = kinds_named(names);
    if (!set)
        throw Error(ErrorCode::InvalidOption, "\"" + names +
                                                  "\" are not kinds of lines. Kinds and mixtures "
                                                  "of them are " +
                                                  names_of_kinds() + ".");
    nb::list keys;
    for (const LineKindDescription& kind : line_kinds)
        if ((*set)[kind.kind]) keys.append(kind.key);
    return keys;
}

/// Runs the core without Python's lock, and stops when Python is interrupted.
template <class Work>
auto unlocked(const Work& work) {
    const Progress until_interrupted = [](double, const char*) {
        const nb::gil_scoped_acquire locked;
        return PyErr_CheckSignals() == 0;
    };
    try {
        const nb::gil_scoped_release released;
        return work(until_interrupted);
    } catch (const Error&) {
        if (PyErr_Occurred()) throw nb::python_error();
        throw;
    }
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
    SightOptions options;
    options.has_hidden = hidden;
    options.in_picture = in_picture;
    return arrays_of(unlocked([&](const Progress& progress) {
        return surface.visible_lines(view_of(eye, w, light), style, options, progress);
    }));
}

nb::dict field(const Surface& surface) {
    return arrays_of(unlocked([&](const Progress&) { return surface.field(); }));
}

nb::dict measures(const Surface& surface) {
    const FieldScale& scale = surface.scale();
    const MeshReport& report = surface.report();
    nb::dict d;
    d["diagonal"] = scale.diagonal;
    d["mean_edge"] = scale.mean_edge;
    d["kernel_size"] = scale.kernel_size;
    d["normal_sigma"] = scale.normal_sigma;
    d["roughness"] = report.roughness;
    d["non_finite_vertices"] = report.non_finite_vertices;
    d["unreferenced_vertices"] = report.unreferenced_vertices;
    d["degenerate_triangles"] = report.degenerate_triangles;
    d["welded_vertices"] = report.welded_vertices;
    d["turned_triangles"] = report.turned_triangles;
    d["undone_subdivisions"] = report.undone_subdivisions;
    return d;
}

nb::object read_mesh(const std::string& ending, const nb::bytes& bytes) {
    const std::optional<mesh_files::Format> format = mesh_files::format_of(ending);
    if (!format) return nb::none();
    const mesh_files::MeshInFile read = unlocked([&](const Progress&) {
        return mesh_files::read_mesh(*format, {bytes.c_str(), bytes.size()});
    });
    return arrays_of(read.mesh) + nb::make_tuple(read.defect, read.remark);
}

/// `meshes`: positions, triangles, file name and file hash of each.
nb::dict draw_meshes(const nb::list& meshes, const std::vector<std::string>& words,
                     const std::string& ending) {
    DrawnMeshes drawn;
    for (const nb::handle mesh : meshes) {
        const auto [positions, triangles, name, hash] =
            nb::cast<std::tuple<Positions, Triangles, std::string, std::string>>(mesh);
        drawn.meshes.push_back(mesh_of(positions, triangles));
        drawn.sources.push_back({name, hash});
    }
    const Drawing drawing =
        unlocked([&](const Progress& progress) { return draw(drawn, words, ending, progress); });
    nb::dict d;
    d["content"] = nb::bytes(drawing.content.data(), drawing.content.size());
    d["paper"] = nb::make_tuple(drawing.width, drawing.height);
    d["scale"] = drawing.scale;
    d["kernel"] = drawing.kernel;
    d["remarks"] = nb::tuple(nb::cast(drawing.remarks));
    return d;
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
    m.def("keys_of_kinds", keys_of_kinds, "names"_a);
    m.def("draw", draw_meshes, "meshes"_a, "words"_a, "ending"_a);
    m.def("read_mesh", read_mesh, "ending"_a, "content"_a);
    nb::class_<Surface>(m, "Surface")
        .def("__init__", make_surface, "positions"_a, "triangles"_a, "options"_a)
        .def("field", field)
        .def("measures", measures)
        .def("lines", lines, "eye"_a, "w"_a, "light"_a.none(), "options"_a)
        .def("visible_lines", visible_lines, "eye"_a, "w"_a, "light"_a.none(), "options"_a,
             "hidden"_a, "in_picture"_a);
}
