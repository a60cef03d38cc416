// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_levels.h"

#include <optional>

#include "meshlab_host/geometry_stamp.h"
#include "meshlab_host/mesh_conversion.h"

using laplacian_lines::DrawnKernel;
using laplacian_lines::LevelShare;

namespace {

bool isMissing(const PreparedLines& lines, int level) {
    return !lines.kept_levels.has(level) && !lines.failed_levels.count(level);
}

/// The first missing level of a drawing, or else of those it may need next.
std::optional<int> levelToCompute(const PreparedLines& lines,
                                  const std::vector<LevelShare>& shares) {
    for (const LevelShare& share : shares)
        if (isMissing(lines, share.level)) return share.level;
    const int drawn = shares.front().level;
    for (const int next : {drawn - 1, drawn + 1})
        if (next >= 0 && next < lines.levels.count() && isMissing(lines, next) &&
            hasRoomForLevel(lines))
            return next;
    return std::nullopt;
}

void computeNow(const PreparedLinesPointer& lines, const CMeshO& mesh, int level) {
    try {
        addLevel(*lines, level, computeLevel({lines, meshlab_host::toTriangleMesh(mesh), level}));
        lines->kept_levels.use(level);  // nor dropped for the next one of this drawing
    } catch (...) {
        lines->failed_levels[level] = reasonWithoutLevel();
    }
}

std::vector<DrawnKernel> kernelsThatAreThere(PreparedLines& lines,
                                             const std::vector<LevelShare>& shares) {
    const int nearest = lines.kept_levels.nearest(shares.front().level);
    if (nearest < 0) return {DrawnKernel()};
    if (nearest != shares.front().level)
        return {DrawnKernel{lines.levels.size(nearest), lines.kept_levels.find(nearest), 1}};
    std::vector<DrawnKernel> kernels;
    for (const LevelShare& share : shares)
        if (const auto* laplacian = lines.kept_levels.use(share.level))
            kernels.push_back({lines.levels.size(share.level), laplacian, share.share});
    return kernels;
}

}  // namespace

std::vector<DrawnKernel> ViewLevels::demand(const PreparedLinesPointer& lines, const CMeshO& mesh,
                                            double wanted, QWidget* widget, bool waits) {
    if (!(wanted > 0)) return {DrawnKernel()};
    const std::vector<LevelShare> shares = lines->levels.at(wanted);
    if (!waits)
        computeInBackground(lines, mesh, shares, widget);
    else
        for (const LevelShare& share : shares)
            if (isMissing(*lines, share.level)) computeNow(lines, mesh, share.level);
    return kernelsThatAreThere(*lines, shares);
}

void ViewLevels::computeInBackground(const PreparedLinesPointer& lines, const CMeshO& mesh,
                                     const std::vector<LevelShare>& shares, QWidget* widget) {
    const std::optional<int> level = levelToCompute(*lines, shares);
    if (!level) return;
    worker_.redrawAtEnd(widget);
    if (worker_.isBusy()) return;
    // While the camera moves, redraws check for changes of the mesh only now and then.
    if (meshlab_host::geometryStamp(mesh) != lines->key.stamp) return;
    try {
        worker_.start({lines, meshlab_host::toTriangleMesh(mesh), *level});
    } catch (...) {
        lines->failed_levels[*level] = reasonWithoutLevel();
    }
}
