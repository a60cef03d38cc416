// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_help.h"

#include <QStringList>

#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/version.h"

// Dialogs have to fit small screens, and not all scroll: a few lines, the rest is in the documents.

QString computeHelp() {
    return QStringLiteral(
               "Chooses how the surface is analysed for Laplacian lines, once for all views. To "
               "see them, "
               "switch on <b>Laplacian Lines</b> in the Render menu; without this filter, that "
               "does the "
               "same with the default parameters.<br>"
               "The mesh is not changed: the result is in per-vertex attributes <b>ll_...</b>, "
               "until the "
               "mesh changes. Cuts whose sides only nearly meet leave lines along them: run "
               "<i>Merge "
               "Close Vertices</i> first.<br>"
               "After Zhang, He and Seah, <i>Laplacian Lines for Real-Time Shape Illustration</i>, "
               "2009. "
               "Version ") +
           laplacian_lines::version() + '.';
}

QString polylineHelp() {
    QStringList kinds;
    for (const laplacian_lines::LineKindDescription& kind : laplacian_lines::line_kinds)
        if (kind.shown) kinds << kind.many;
    return QStringLiteral(
               "Creates a layer with the lines of the current layer as seen from one view: %1. "
               "They "
               "are vertices and edges, for other filters and programs (OBJ, DXF), with attributes "
               "<b>ll_...</b> that tell more about them.<br>"
               "The view is that of the window: just apply, or choose another one.<br>"
               "The results of <i>Compute Laplacian Lines</i> are used while they belong to the "
               "mesh, otherwise those of its defaults.")
        .arg(kinds.join(", "));
}

QString drawingHelp() {
    return QStringLiteral(
        "Writes a measured drawing: lines at scale on paper, as vectors, from the window's view or "
        "several sides.");
}
