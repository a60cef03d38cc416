// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

struct DecorationDescription {
    QString plugin_name;
    QString decoration_name;  ///< menu entry
    QString help;             ///< tool tip
};

/// A plugin with one decoration of meshes, with the same virtual functions in every version of
/// MeshLab. A plugin class adds Q_OBJECT and
///     MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_DECORATE_IID)
///     Q_INTERFACES(MESHLAB_HOST_DECORATE_INTERFACE)
/// MeshLab calls it from the GUI thread, with its GL context current in start() and draw(). After
/// each filter and each edit of a decoration parameter it restarts the decoration in every view and
/// ignores what start() returns then. Virtual functions must not throw. `view` is only a key:
/// GLArea is not available to plugins.
class DecoratePluginBase : public QObject, public MESHLAB_HOST_DECORATE_INTERFACE {
public:
    explicit DecoratePluginBase(DecorationDescription description);

protected:
    virtual void list_parameters(RichParameterList& list) const = 0;

    /// False: nothing can be drawn.
    virtual bool start(MeshModel& mesh, const RichParameterList& parameters, GLArea* view) = 0;
    virtual void draw(MeshModel& mesh, const RichParameterList& parameters, GLArea* view,
                      QPainter* painter, GLLogStream& log) = 0;
    virtual void end(MeshModel& mesh, GLArea* view) = 0;
    /// The view is being closed, with all its meshes.
    virtual void end_all(GLArea* view) = 0;
    /// A mesh decorated in `view` is gone; MeshLab does not say which.
    virtual void mesh_gone(GLArea* view) = 0;

    /// To the log of the document being served.
    void say(const QString& line) { MESHLAB_HOST_LOG(line.toStdString()); }

    // MeshLab's interface, final here.
public:
    QString pluginName() const final { return description_.plugin_name; }
    QString decorationName(int) const final { return description_.decoration_name; }
    QString decorationInfo(int) const final { return description_.help; }
    using MESHLAB_HOST_DECORATE_INTERFACE::decorationInfo;
    using MESHLAB_HOST_DECORATE_INTERFACE::decorationName;
    int getDecorationClass(ActionPointer) const final { return PerMesh; }
    bool startDecorate(ActionPointer, MeshModel&, const RichParameterList*, GLArea*) final;
    bool startDecorate(ActionPointer, MeshDocument&, const RichParameterList*, GLArea*) final {
        return false;
    }
    void decorateMesh(ActionPointer, MeshModel&, const RichParameterList*, GLArea*, QPainter*,
                      GLLogStream&) final;
    void decorateDoc(ActionPointer, MeshDocument&, const RichParameterList*, GLArea*, QPainter*,
                     GLLogStream&) final {}
    void endDecorate(ActionPointer, MeshModel&, const RichParameterList*, GLArea*) final;
    void endDecorate(ActionPointer, MeshDocument&, const RichParameterList*, GLArea*) final;
#if MESHLAB_API < 2022
    void initGlobalParameterSet(QAction*, RichParameterList& list) final {
        list_parameters(list);
    }
#else
    QString vendor() const final {
        return "Laplacian Lines";
    }
    void initGlobalParameterList(const QAction*, RichParameterList& list) final {
        list_parameters(list);
    }
#endif

private:
    DecorationDescription description_;
};

}  // namespace meshlab_host
