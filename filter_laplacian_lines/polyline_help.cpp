// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyline_help.h"

#include <QStringList>

#include "laplacian_lines/line_kind.h"

namespace {

using Kind = laplacian_lines::LineKindDescription;

/// What `words` makes of each kind; nothing of those for which that is empty.
template <class Words>
QStringList forKinds(const Words& words) {
    QStringList parts;
    for (const Kind& kind : laplacian_lines::line_kinds)
        parts << words(kind);
    parts.removeAll(QString());
    return parts;
}

}  // namespace

QString polylineHelp() {
    const QStringList kinds = forKinds([](const Kind& kind) { return QString(kind.many); });
    const QStringList numbers = forKinds(
        [](const Kind& kind) { return QString("%1 %2").arg(int(kind.kind)).arg(kind.one); });
    const QStringList with_angles = forKinds([](const Kind& kind) {
        return QString(kind.gradient == laplacian_lines::LineGradient::Angle ? kind.many : "");
    });
    return QStringLiteral(
               "Creates a layer with the lines of the current layer as seen from one view: %1. "
               "They are "
               "polylines, that is, vertices and edges in the coordinates of the surface, to be "
               "saved for other programs "
               "(OBJ, DXF) or worked on with other filters.<br>"
               "<br>"
               "As the dialog opens, the view is the one in the window: just apply. For another "
               "one, "
               "choose perspective or orthographic and fill in the viewpoint or the direction.<br>"
               "<br>"
               "If the filter <i>Compute Laplacian Lines</i> has been run on the layer and it has "
               "not "
               "changed since, its results are used, otherwise those of its default parameters. "
               "The new "
               "layer has the transformation of the old one.<br>"
               "<br>"
               "Per-vertex attributes tell more about the lines:<br>"
               "<b>ll_line</b>: number of the line;<br>"
               "<b>ll_kind</b>: %2;<br>"
               "<b>ll_strength</b>: strength of the line, its gradient summed along its length;<br>"
               "<b>ll_slope</b>: mean slope of the Laplacian across the line (Laplacian lines);<br>"
               "<b>ll_gradient</b>: gradient of the illumination at the vertex times the "
               "bounding-box "
               "diagonal; of %3 an angle, in degrees;<br>"
               "<b>ll_weight</b>: share of the full line width, 0 to 1;<br>"
               "<b>ll_opacity</b>: 0 to 1, small where the line is about to vanish.<br>"
               "The vertex quality is weight times opacity, the vertex normal that of the "
               "surface.<br>")
        .arg(kinds.join(", "), numbers.join(", "), with_angles.join(" and "));
}
