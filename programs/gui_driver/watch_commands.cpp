// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include <memory>

#include "command_table.h"
#include "drawing_watch.h"
#include "gui.h"
#include "situation.h"

namespace driver {
namespace {

std::unique_ptr<DrawingWatch> watch;

DrawingWatch& requireWatch() {
    if (!watch) throw CommandError("say watch-drawings before");
    return *watch;
}

void forgetDrawings(const Command&) {
    requireWatch().takeDrawn();
    requireWatch().takeProblems();
}

void expectTrueDrawings(const Command&) {
    if (requireWatch().takeDrawn().empty()) throw CommandError("nothing was drawn");
    const QStringList problems = requireWatch().takeProblems();
    if (!problems.isEmpty()) throw CommandError(problems.join("; "));
}

void expectNoDrawings(const Command&) {
    if (!requireWatch().takeDrawn().empty()) throw CommandError("something was drawn");
}

Outcome awaitTrueDrawing(const Command&) {
    return requireWatch().endsWell() ? Outcome::Done : Outcome::Retry;
}

/// √h in mesh units of the first kernel of the latest drawing, 0 as it was computed.
double drawnKernel() {
    const std::vector<laplacian_lines::DrawnKernel>& kernels = requireWatch().kernels();
    return kernels.empty() ? 0 : kernels.front().size;
}

/// "LEAST MOST"
Outcome awaitKernel(const Command& command) {
    const double size = drawnKernel();
    return size >= command.number(0) && size <= command.number(1) ? Outcome::Done : Outcome::Retry;
}

void expectKernel(const Command& command) {
    const double size = drawnKernel();
    if (size < command.number(0) || size > command.number(1))
        throw CommandError(QString("the kernel size is %1").arg(size));
}

void stretch(const Command& command) {
    MeshModel* mesh = presentSituation().current;
    if (!mesh) throw CommandError("there is no layer");
    for (CVertexO& vertex : mesh->cm.vert)
        if (!vertex.IsD()) vertex.P()[2] *= Scalarm(command.number(0));
    vcg::tri::UpdateBounding<CMeshO>::Box(mesh->cm);
}

}  // namespace

void addWatchCommands(CommandTable& table) {
    table.addSimple("watch-drawings",
                    [](const Command&) { watch = std::make_unique<DrawingWatch>(); });
    table.addSimple("forget-drawings", forgetDrawings);
    table.addSimple("expect-true-drawings", expectTrueDrawings);
    table.addSimple("expect-no-drawings", expectNoDrawings);
    table.add("await-true-drawing", awaitTrueDrawing);
    table.add("await-kernel", awaitKernel);
    table.addSimple("expect-kernel", expectKernel);
    table.addSimple("stretch", stretch);
    table.addSimple("redraw", [](const Command&) { requireView()->repaint(); });
}

}  // namespace driver
