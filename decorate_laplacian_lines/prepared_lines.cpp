// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared_lines.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <new>
#include <numeric>

#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/line_visibility.h"
#include "meshlab_host/mesh_conversion.h"

using laplacian_lines::Field;
using laplacian_lines::TriangleMesh;

namespace {

constexpr std::size_t least_kept_levels = 4;

/// Of an extractor's memory.
constexpr double share_of_levels = 0.7;

class WaitCursor {
public:
    WaitCursor() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
    ~WaitCursor() { QGuiApplication::restoreOverrideCursor(); }
    WaitCursor(const WaitCursor&) = delete;
    WaitCursor& operator=(const WaitCursor&) = delete;
};

std::size_t bytesOf(const PreparedLines& lines) {
    std::size_t sum = lines.extractor->memory() + line_renderer::bytesOf(*lines.surface) +
                      lines.kept_levels.bytes() + lines.samples.bytes();
    if (lines.field)
        for (const auto& column : laplacian_lines::present_columns(*lines.field))
            sum += column.size(*lines.field) * std::size_t(column.floats) * sizeof(float);
    return sum;
}

std::size_t bytesForLevels(const PreparedLines& lines) {
    return std::size_t(share_of_levels * double(lines.extractor->memory()));
}

}  // namespace

const laplacian_lines::KernelLaplacian* KeptLevels::find(int level) const {
    for (const Entry& entry : entries_)
        if (entry.level == level) return &entry.laplacian;
    return nullptr;
}

const laplacian_lines::KernelLaplacian* KeptLevels::use(int level) {
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [=](const Entry& entry) { return entry.level == level; });
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    found->is_used = true;
    return &found->laplacian;
}

int KeptLevels::nearest(int level) const {
    const auto found =
        std::min_element(entries_.begin(), entries_.end(), [=](const Entry& a, const Entry& b) {
            return std::abs(a.level - level) < std::abs(b.level - level);
        });
    return found == entries_.end() ? -1 : found->level;
}

bool KeptLevels::hasRoom(std::size_t most_bytes) const {
    return entries_.empty() || bytes() + entries_.front().laplacian.memory() <= most_bytes;
}

void KeptLevels::add(int level, laplacian_lines::KernelLaplacian laplacian,
                     std::size_t most_bytes) {
    entries_.remove_if([=](const Entry& entry) { return entry.level == level; });
    entries_.push_front({level, std::move(laplacian)});
    while (entries_.size() > least_kept_levels && bytes() > most_bytes)
        dropOne();
}

void KeptLevels::dropOne() {
    auto dropped = std::prev(entries_.end());
    for (auto entry = std::next(entries_.begin()); entry != entries_.end(); ++entry)
        if (!entry->is_used) dropped = entry;
    entries_.erase(dropped);
}

std::size_t KeptLevels::bytes() const {
    return std::accumulate(
        entries_.begin(), entries_.end(), std::size_t(0),
        [](std::size_t sum, const Entry& entry) { return sum + entry.laplacian.memory(); });
}

PreparedLinesPointer prepareLines(const CMeshO& mesh, const QString& mesh_name,
                                  const meshlab_host::FieldSource& source,
                                  const std::function<void(const QString&)>& say) {
    QElapsedTimer clock;
    clock.start();
    auto result = std::make_shared<PreparedLines>();
    result->key = source.key;
    try {
        const WaitCursor wait_cursor;
        const TriangleMesh triangles = meshlab_host::toTriangleMesh(mesh);
        Field field = meshlab_host::demandField(mesh, triangles, mesh_name, source, say);
        result->diagonal = field.scale.diagonal;
        result->sight_edge = laplacian_lines::sight_edge(field);
        result->options = source.options;
        result->levels = laplacian_lines::KernelLevels(field.scale.mean_edge, field.scale.diagonal);
        result->samples = SurfaceSamples(triangles, field);
        result->surface = line_renderer::makeSurface(triangles, field);
        result->extractor.emplace(triangles, field);
        result->has_derivatives = field.has_derivatives();
        const bool is_in_mesh = source.status == meshlab_host::FieldStatus::Current;
        if (!is_in_mesh && !result->has_derivatives) result->field = std::move(field);
        result->bytes = bytesOf(*result);
    } catch (const std::bad_alloc&) {
        result->failure = "There is not enough memory for the lines of this mesh.";
        result->lacked_memory = true;
    } catch (const std::exception& error) {
        result->failure = QString::fromUtf8(error.what());
    }
    result->preparation = 1e-6 * double(clock.nsecsElapsed());
    return result;
}

void addLevel(PreparedLines& lines, int level, laplacian_lines::KernelLaplacian laplacian) {
    lines.kept_levels.add(level, std::move(laplacian), bytesForLevels(lines));
    lines.bytes = bytesOf(lines);
}

bool hasRoomForLevel(const PreparedLines& lines) {
    return lines.kept_levels.hasRoom(bytesForLevels(lines));
}

void addDerivatives(PreparedLines& lines, const CMeshO& mesh, const QString& mesh_name,
                    const meshlab_host::FieldSource& source,
                    const std::function<void(const QString&)>& say) {
    QElapsedTimer clock;
    clock.start();
    try {
        const WaitCursor wait_cursor;
        const TriangleMesh triangles = meshlab_host::toTriangleMesh(mesh);
        if (lines.field)
            meshlab_host::demandDerivatives(triangles, *lines.field);
        else
            lines.field = meshlab_host::demandField(mesh, triangles, mesh_name,
                                                    meshlab_host::withDerivatives(source), say);
        lines.extractor->add_derivatives(triangles, *lines.field);
        lines.field.reset();
        lines.has_derivatives = true;
        lines.lack.clear();
        lines.bytes = bytesOf(lines);
        say(QString("Laplacian Lines: %1: computed in %2 s what the chosen kinds of lines also "
                    "need")
                .arg(mesh_name)
                .arg(1e-3 * double(clock.elapsed()), 0, 'f', 2));
    } catch (const std::bad_alloc&) {
        lines.lack = "There is not enough memory for some of the chosen kinds of lines.";
    } catch (const std::exception& error) {
        lines.lack = QString::fromUtf8(error.what());
    }
}
