// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <string>
#include <vector>

#include "laplacian_lines/error.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/progress.h"

namespace python_module {

template <class Number, int Columns>
using Rows = nanobind::ndarray<const Number, nanobind::numpy, nanobind::shape<-1, Columns>,
                               nanobind::c_contig, nanobind::device::cpu>;
using Positions = Rows<double, 3>;
using Triangles = Rows<std::uint32_t, 3>;

laplacian_lines::TriangleMesh mesh_of(const Positions& positions, const Triangles& triangles);
/// Positions and triangles.
nanobind::tuple arrays_of(const laplacian_lines::TriangleMesh& mesh);
/// By attribute names of field_columns.h: (vertices, 3) or (vertices,).
nanobind::dict arrays_of(const laplacian_lines::Field& field);
/// By the names in laplacian_lines/polylines.py.
nanobind::dict arrays_of(const std::vector<laplacian_lines::ViewLine>& lines);

/// Options of measured drawings that do not concern files, for laplacian_lines/options.py.
nanobind::list sheet_options();
/// A drawing of meshes, each positions, triangles, file name and file hash, by the command's words.
nanobind::dict draw(const nanobind::list& meshes, const std::vector<std::string>& words,
                    const std::string& ending);

/// Python's dict(name=value, ...).
template <class... Named>
nanobind::dict dict_of(Named&&... named) {
    const nanobind::handle dict(reinterpret_cast<PyObject*>(&PyDict_Type));
    return nanobind::cast<nanobind::dict>(dict(std::forward<Named>(named)...));
}

template <class Items>
nanobind::list list_of(const Items& items) {
    nanobind::list list;
    for (const auto& item : items)
        list.append(item);
    return list;
}

/// Runs the core without Python's lock, and stops when Python is interrupted.
template <class Work>
auto unlocked(const Work& work) {
    const laplacian_lines::Progress until_interrupted = [](double, const char*) {
        const nanobind::gil_scoped_acquire locked;
        return PyErr_CheckSignals() == 0;
    };
    try {
        const nanobind::gil_scoped_release released;
        return work(until_interrupted);
    } catch (const laplacian_lines::Error&) {
        if (PyErr_Occurred()) throw nanobind::python_error();
        throw;
    }
}

}  // namespace python_module
