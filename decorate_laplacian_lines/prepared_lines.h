// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "laplacian_lines/line_extractor.h"
#include "meshlab_host/field_attributes.h"
#include "surface.h"

/// What decides the lines of a mesh, the view and the style aside. Two meshes with equal keys have
/// the same lines, whatever layer or view they are in.
struct LineKey {
    meshlab_host::GeometryStamp stamp;
    std::vector<double> options;  ///< of the precomputation, in the order of its table

    bool operator<(const LineKey& other) const;
};

/// A mesh made ready for line extraction, or the reason why it cannot be.
struct PreparedLines {
    LineKey key;
    double diagonal = 0;   ///< of the usable mesh's bounding box, mesh units
    double mean_edge = 0;  ///< mesh units
    std::optional<laplacian_lines::LineExtractor> extractor;
    SurfacePointer surface;  ///< set if there is an extractor
    QString failure;         ///< one sentence, empty if there is an extractor
};
using PreparedLinesPointer = std::shared_ptr<const PreparedLines>;

/// Says whether a mesh's own attributes can be used, and which lines it will have.
struct LineSource {
    LineKey key;
    meshlab_host::FieldStatus status;
    laplacian_lines::PrecomputeOptions options;
};
LineSource lineSource(const CMeshO& mesh);

/// Prepares the lines of a mesh: from its attributes if they belong to it, otherwise by computing
/// the field with the default options, which takes seconds for a million triangles and is then
/// told to `say`. The mesh is not changed. Throws nothing but std::bad_alloc from the very end.
PreparedLinesPointer prepareLines(const CMeshO& mesh, const QString& mesh_name,
                                  const LineSource& source,
                                  const std::function<void(const QString&)>& say);
