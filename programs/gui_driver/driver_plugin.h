// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <meshlab_host/decorate_plugin_base.h>

/// Drives MeshLab from a script, for tests and pictures: see README.md. A plugin without any
/// decoration, which does nothing unless LAPLACIAN_LINES_DRIVER names a script.
class DriverPlugin : public meshlab_host::DecoratePluginBase {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_DECORATE_IID)
    Q_INTERFACES(MESHLAB_HOST_DECORATE_INTERFACE)

public:
    DriverPlugin();

protected:
    void listParameters(RichParameterList&) const override {}
    bool start(MeshModel&, const RichParameterList&, GLArea*) override { return false; }
    void draw(MeshModel&, const RichParameterList&, GLArea*, QPainter*, GLLogStream&) override {}
    void end(MeshModel&, GLArea*) override {}
    void endAll(GLArea*) override {}
    void meshGone(GLArea*) override {}
};
