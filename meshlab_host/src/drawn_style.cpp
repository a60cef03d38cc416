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

const char* const kProperty = "laplacian_lines_drawn_style";
const char* const kAzimuth = "light_azimuth";
const char* const kHidden = "hidden_lines";

// The kinds' own keys are those of their switches.
QString color_key(const laplacian_lines::LineKindDescription& kind) {
    return QString("color_of_") + kind.key;
}

}  // namespace

KindColors usual_kind_colors() {
    KindColors colors;
    std::transform(
        laplacian_lines::kLineKinds.begin(), laplacian_lines::kLineKinds.end(), colors.begin(),
        [](const laplacian_lines::LineKindDescription& kind) { return QColor(kind.color).rgb(); });
    return colors;
}

void note_drawn_style(const DrawnStyle& drawn) {
    QVariantMap map;
    for (const auto& row : laplacian_lines::line_style_table())
        map[row.key] = row.get(drawn.style);
    for (const auto& kind : laplacian_lines::kLineKinds)
        map[color_key(kind)] = drawn.colors[std::size_t(kind.kind)];
    map[kHidden] = drawn.shows_hidden;
    if (drawn.light_azimuth) map[kAzimuth] = *drawn.light_azimuth;
    if (QObject* application = QCoreApplication::instance())
        application->setProperty(kProperty, map);
}

DrawnStyle require_drawn_style() {
    const QObject* application = QCoreApplication::instance();
    const QVariantMap map = application ? application->property(kProperty).toMap() : QVariantMap();
    if (map.isEmpty())
        laplacian_lines::refuse(
            "The decoration Laplacian Lines has drawn nothing here. Switch it on in MeshLab's "
            "window first, or set \"Settings\" to 0 (Defaults).");
    DrawnStyle drawn;
    for (const auto& row : laplacian_lines::line_style_table())
        row.set(drawn.style, map.value(row.key, row.get(drawn.style)).toDouble());
    for (const auto& kind : laplacian_lines::kLineKinds) {
        QRgb& color = drawn.colors[std::size_t(kind.kind)];
        color = map.value(color_key(kind), color).toUInt();
    }
    drawn.shows_hidden = map.value(kHidden).toBool();
    if (map.contains(kAzimuth)) drawn.light_azimuth = map.value(kAzimuth).toDouble();
    return drawn;
}

}  // namespace meshlab_host
