// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/decorate_plugin_base.h"

#include <memory>
#include <utility>

#include "meshlab_host/documents.h"

namespace meshlab_host {
namespace {

/// For deleted layers MeshLab passes "*null". Volatile: a compiler may assume that a reference's
/// address is never null.
bool exists(MeshModel& mesh) {
    MeshModel* volatile address = std::addressof(mesh);
    return address != nullptr;
}

/// For null. A variable, lest each redraw copy all of MeshLab's settings.
const RichParameterList kNoParameters{};

}  // namespace

DecoratePluginBase::DecoratePluginBase(DecorationDescription description)
    : description_(std::move(description)) {
    typeList.push_back(0);
    auto* action = new QAction(description_.decoration_name, this);
    action->setCheckable(true);
    actionList.push_back(action);
}

bool DecoratePluginBase::startDecorate(ActionPointer, MeshModel& mesh,
                                       const RichParameterList* parameters, GLArea* view) {
    if (!exists(mesh)) {
        mesh_gone(view);
        return false;
    }
    if (MeshDocument* document = document_of(mesh))
        setLog(&document->Log);  // MeshLab may have set another, or none
    return start(mesh, parameters ? *parameters : kNoParameters, view);
}

void DecoratePluginBase::decorateMesh(ActionPointer, MeshModel& mesh,
                                      const RichParameterList* parameters, GLArea* view,
                                      QPainter* painter, GLLogStream& log) {
    if (!exists(mesh)) return;
    setLog(&log);  // switching the decoration off in another view has taken the log away
    draw(mesh, parameters ? *parameters : kNoParameters, view, painter, log);
}

void DecoratePluginBase::endDecorate(ActionPointer, MeshModel& mesh, const RichParameterList*,
                                     GLArea* view) {
    if (exists(mesh))
        end(mesh, view);
    else
        mesh_gone(view);
}

void DecoratePluginBase::endDecorate(ActionPointer, MeshDocument&, const RichParameterList*,
                                     GLArea* view) {
    end_all(view);
}

}  // namespace meshlab_host
