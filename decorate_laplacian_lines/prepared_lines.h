// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>

#include "laplacian_lines/kernel_levels.h"
#include "laplacian_lines/line_extractor.h"
#include "line_renderer/surface.h"
#include "meshlab_host/field_source.h"
#include "surface_samples.h"

/// A mesh's levels of laplacian_lines::KernelLevels. Those computed ahead and never used go first,
/// then the least recently used.
class KeptLevels {
public:
    /// Null if it is not there. Valid until add().
    const laplacian_lines::KernelLaplacian* find(int level) const;
    /// For a level that a drawing asked for, not one that stands in for another.
    const laplacian_lines::KernelLaplacian* use(int level);
    bool has(int level) const { return find(level) != nullptr; }
    /// The nearest level that is there; -1 if there is none.
    int nearest(int level) const;
    /// Whether another one fits into `most_bytes` for all.
    bool hasRoom(std::size_t most_bytes) const;
    /// Keeps at most `most_bytes` for all, but always the four last used: what drawings in two
    /// views have.
    void add(int level, laplacian_lines::KernelLaplacian laplacian, std::size_t most_bytes);
    std::size_t bytes() const;

private:
    struct Entry {
        int level;
        laplacian_lines::KernelLaplacian laplacian;
        bool is_used = false;
    };
    /// Never the first one: if it is new, a drawing waits for it.
    void dropOne();

    std::list<Entry> entries_;  ///< the one used last comes first
};

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
