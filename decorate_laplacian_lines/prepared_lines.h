// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "laplacian_lines/line_extractor.h"
#include "line_renderer/surface.h"
#include "meshlab_host/field_source.h"

class PrintedScene;
struct PrintableMesh;

/// A mesh ready for line extraction, or why it is not.
struct PreparedLines {
    meshlab_host::FieldKey key;
    double diagonal = 0;         ///< of the usable mesh's bounding box, mesh units
    double depth_bias_edge = 0;  ///< as depth_bias_edge() has it, mesh units
    std::shared_ptr<laplacian_lines::LineExtractor> extractor;
    line_renderer::SurfacePointer surface;        ///< set if there is an extractor
    QString failure;                              ///< one sentence, empty if there is an extractor
    bool is_out_of_memory = false;                ///< the failure: another try may succeed
    std::size_t bytes = 0;                        ///< of all members, of the scene by estimate
    bool has_derivatives = false;                 ///< for kinds of lines that need them
    QString missing_reason;                       ///< why they could not be computed
    std::optional<laplacian_lines::Field> field;  ///< to compute them from, if it was computed
    std::shared_ptr<PrintableMesh> printable;     ///< null if the mesh is too large
    std::shared_ptr<PrintedScene> scene;          ///< the last one whose first object it is
    double preparation = 0;                       ///< time it took, milliseconds
    std::optional<double> first_redraw;           ///< the plugin's time of it, milliseconds
};
using PreparedLinesPointer = std::shared_ptr<PreparedLines>;

/// With the field of find_or_compute_field(). Throws only std::bad_alloc, if not even the message
/// fits.
PreparedLinesPointer prepare_lines(const CMeshO& mesh, const QString& mesh_name,
                                   const meshlab_host::FieldSource& source,
                                   const std::function<void(const QString&)>& say);

/// Adds derivatives, or sets `missing_reason` and leaves the lines alone. Throws only
/// std::bad_alloc, if not even the message fits.
void add_derivatives(PreparedLines& lines, const CMeshO& mesh, const QString& mesh_name,
                     const meshlab_host::FieldSource& source,
                     const std::function<void(const QString&)>& say);
