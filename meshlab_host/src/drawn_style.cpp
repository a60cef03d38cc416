// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/drawn_style.h"

#include <QColor>
#include <QCoreApplication>
#include <QVariantMap>
#include <algorithm>

#include "laplacian_lines/error.h"
#include "laplacian_lines/option_table.h"

namespace meshlab_host {
namespace {

const char* const property = "laplacian_lines_drawn_style";
const char* const azimuth = "light_azimuth";
const char* const hidden = "hidden_lines";

// The kinds' own keys are those of their switches.
QString colorKey(const laplacian_lines::LineKindDescription& kind) {
    return QString("color_of_") + kind.key;
}

}  // namespace

KindColors usualKindColors() {
    KindColors colors;
    std::transform(
        laplacian_lines::line_kinds.begin(), laplacian_lines::line_kinds.end(), colors.begin(),
        [](const laplacian_lines::LineKindDescription& kind) { return QColor(kind.color).rgb(); });
    return colors;
}

void noteDrawnStyle(const DrawnStyle& drawn) {
    QVariantMap map;
    for (const auto& row : laplacian_lines::line_style_table())
        map[row.key] = row.get(drawn.style);
    for (const auto& kind : laplacian_lines::line_kinds)
        map[colorKey(kind)] = drawn.colors[std::size_t(kind.kind)];
    map[hidden] = drawn.shows_hidden;
    if (drawn.light_azimuth) map[azimuth] = *drawn.light_azimuth;
    if (QObject* application = QCoreApplication::instance())
        application->setProperty(property, map);
}

DrawnStyle demandDrawnStyle() {
    const QObject* application = QCoreApplication::instance();
    const QVariantMap map = application ? application->property(property).toMap() : QVariantMap();
    if (map.isEmpty())
        laplacian_lines::refuse(
            "The decoration Laplacian Lines has drawn nothing here. Switch it on in MeshLab's "
            "window first, or set \"Settings\" to 0 (Defaults).");
    DrawnStyle drawn;
    for (const auto& row : laplacian_lines::line_style_table())
        row.set(drawn.style, map.value(row.key, row.get(drawn.style)).toDouble());
    for (const auto& kind : laplacian_lines::line_kinds) {
        QRgb& color = drawn.colors[std::size_t(kind.kind)];
        color = map.value(colorKey(kind), color).toUInt();
    }
    drawn.shows_hidden = map.value(hidden).toBool();
    if (map.contains(azimuth)) drawn.light_azimuth = map.value(azimuth).toDouble();
    return drawn;
}

}  // namespace meshlab_host
