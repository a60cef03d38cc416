// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>

#include "command_table.h"
#include "meshlab_host/decorate_plugin_base.h"
#include "process.h"

/// Drives MeshLab from a script, for ./run and tests: see README.md. A plugin without any
/// decoration, which does nothing unless LAPLACIAN_LINES_DRIVER names a script.
class DriverPlugin : public meshlab_host::DecoratePluginBase {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_DECORATE_IID)
    Q_INTERFACES(MESHLAB_HOST_DECORATE_INTERFACE)

public:
    DriverPlugin();

protected:
    void list_parameters(RichParameterList&) const override {}
    bool start(MeshModel&, const RichParameterList&, GLArea*) override { return false; }
    void draw(MeshModel&, const RichParameterList&, GLArea*, QPainter*, GLLogStream&) override {}
    void end(MeshModel&, GLArea*) override {}
    void end_all(GLArea*) override {}
    void mesh_gone(GLArea*) override {}
};

DriverPlugin::DriverPlugin() : DecoratePluginBase({"LaplacianLinesDriver", "", ""}) {
    actionList.clear();
    typeList.clear();
    const QString script = qEnvironmentVariable("LAPLACIAN_LINES_DRIVER");
    if (script.isEmpty() || !qobject_cast<QApplication*>(QCoreApplication::instance())) return;
    try {
        driver::run_script(script, this);
    } catch (const driver::CommandError& e) {
        driver::end_with_error(e.what());
    }
}

MESHLAB_PLUGIN_NAME_EXPORTER(DriverPlugin)

#include "driver_plugin.moc"
