// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "kept_levels.h"
#include "laplacian_lines/kernel_levels.h"
#include "line_renderer/surface.h"
#include "meshlab_host/field_source.h"
#include "surface_samples.h"

/// A mesh ready for line extraction, or why it is not.
struct PreparedLines {
    meshlab_host::FieldKey key;
    double diagonal = 0;    ///< of the usable mesh's bounding box, mesh units
    double sight_edge = 0;  ///< as sight_edge() has it, mesh units
    std::optional<laplacian_lines::LineExtractor> extractor;
    line_renderer::SurfacePointer surface;        ///< set if there is an extractor
    QString failure;                              ///< one sentence, empty if there is an extractor
    bool lacked_memory = false;                   ///< why it failed: another try may succeed
    std::size_t bytes = 0;                        ///< of all members
    bool has_derivatives = false;                 ///< for kinds of lines that need them
    QString lack;                                 ///< why it has none although they were asked for
    std::optional<laplacian_lines::Field> field;  ///< to compute them from, if it was computed
    laplacian_lines::PrecomputeOptions options;   ///< of the extractor's field
    laplacian_lines::KernelLevels levels;         ///< other kernels than the extractor's
    KeptLevels kept_levels;                       ///< those that are there
    std::map<int, QString> failed_levels;         ///< why they cannot be
    SurfaceSamples samples;
    double preparation = 0;              ///< time it took, milliseconds
    std::optional<double> first_redraw;  ///< the plugin's time of it, milliseconds
};
using PreparedLinesPointer = std::shared_ptr<PreparedLines>;

/// From the mesh's attributes if current, else by computing the field with the defaults, which
/// takes seconds for a million triangles and is logged by `say`. Does not change the mesh. Throws
/// only std::bad_alloc, at the very end.
PreparedLinesPointer prepareLines(const CMeshO& mesh, const QString& mesh_name,
                                  const meshlab_host::FieldSource& source,
                                  const std::function<void(const QString&)>& say);

/// Levels take at most .7 times the memory of their extractor, unless drawings need more at once.
void addLevel(PreparedLines& lines, int level, laplacian_lines::KernelLaplacian laplacian);
/// For another one without dropping any.
bool hasRoomForLevel(const PreparedLines& lines);

/// Adds derivatives only; or says in `lack` why not and leaves the lines alone. Throws only
/// std::bad_alloc, at the very end.
void addDerivatives(PreparedLines& lines, const CMeshO& mesh, const QString& mesh_name,
                    const meshlab_host::FieldSource& source,
                    const std::function<void(const QString&)>& say);
