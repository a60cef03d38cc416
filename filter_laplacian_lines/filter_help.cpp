// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_help.h"

#include <QStringList>

#include "laplacian_lines/field_columns.h"
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

/// A line for each column of a field, with its attributes and what they hold.
QString attributeList() {
    QStringList lines;
    for (const laplacian_lines::FieldColumn& column : laplacian_lines::field_columns) {
        QStringList names;
        for (const laplacian_lines::FieldAttribute& attribute : column.attributes)
            if (attribute.floats > 0) names << QString("<b>%1</b>").arg(attribute.name);
        QString line = names.join(", ") + ": " + QString::fromUtf8(column.help);
        if (*column.unit) line += ", " + QString::fromUtf8(column.unit);
        if (column.optional) line += ", if it was computed";
        lines << line;
    }
    return lines.join(";<br>") + ".<br>";
}

}  // namespace

QString computeHelp() {
    const QString help = QStringLiteral(
        "Computes what Laplacian lines need to know about a surface, once and for every later "
        "view. Laplacian lines are drawn where the Laplacian of the illumination, with the light "
        "at the eye, changes its sign: the edge detector of image processing, applied on the "
        "surface instead of in the picture.<br>"
        "<br>"
        "To see the lines, switch on the decoration <b>Laplacian Lines</b> in the Render menu. It "
        "uses what this filter has computed; without it, it computes the same with the default "
        "parameters, so the filter is only needed to choose other ones.<br>"
        "<br>"
        "The result is stored in per-vertex attributes, which other filters can read and which PLY "
        "files can hold (see the options when saving):<br>"
        "%1"
        "Vertices, faces, normals and colors stay as they are. If the mesh changes afterwards, the "
        "attributes no longer belong to it and the decoration ignores them.<br>"
        "<br>"
        "Where vertices at exactly the same place cut the surface open, as in files with texture "
        "seams or without shared vertices, they count as one. For cuts whose sides only nearly "
        "meet, run <i>Merge Close Vertices</i> first.<br>"
        "<br>"
        "See:<br>"
        "<i>Long Zhang, Ying He, Hock Soon Seah</i>, <b>\"Laplacian Lines for Real-Time Shape "
        "Illustration\"</b>, Symposium on Interactive 3D Graphics and Games (I3D), 2009<br>"
        "<i>Mikhail Belkin, Jian Sun, Yusu Wang</i>, <b>\"Discrete Laplace Operator on Meshed "
        "Surfaces\"</b>, Symposium on Computational Geometry (SoCG), 2008<br>"
        "<i>Szymon Rusinkiewicz</i>, <b>\"Estimating Curvatures and Their Derivatives on Triangle "
        "Meshes\"</b>, 3D Data Processing, Visualization and Transmission (3DPVT), 2004<br>"
        "<i>Nelson Max</i>, <b>\"Weights for Computing Vertex Normals from Facet Normals\"</b>, "
        "Journal of Graphics Tools 4(2), 1999<br>");
    return help.arg(attributeList());
}

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
