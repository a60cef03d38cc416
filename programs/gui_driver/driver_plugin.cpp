// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver_plugin.h"

#include <QApplication>

#include "command_table.h"
#include "process.h"
#include "runner.h"

DriverPlugin::DriverPlugin() : DecoratePluginBase({"LaplacianLinesDriver", "", ""}) {
    actionList.clear();
    typeList.clear();
    const QString script = qEnvironmentVariable("LAPLACIAN_LINES_DRIVER");
    if (script.isEmpty() || !qobject_cast<QApplication*>(QCoreApplication::instance())) return;
    try {
        new driver::Runner(driver::readScript(script), driver::allCommands(), this);
    } catch (const driver::CommandError& e) {
        driver::endWithError(e.what());
    }
}

MESHLAB_PLUGIN_NAME_EXPORTER(DriverPlugin)
