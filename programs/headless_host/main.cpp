// SPDX-License-Identifier: GPL-3.0-or-later
// meshlabserver for MeshLab 2022 and later: see usage() in command_line.cpp.
#include <GL/glew.h>

#include <common/ml_document/mesh_document.h>
#include <common/mlexception.h>

#include <QApplication>
#include <QLocale>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "command_line.h"
#include "filter_plugins.h"
#include "mesh_files.h"
#include "report.h"

namespace server {

namespace {

void openAll(const std::vector<Input>& inputs, MeshDocument& document, Report& report) {
    for (const Input& input : inputs) {
        open(input, document);
        report.sayNewLines(document.Log);
        report.say(QString("opened %1: %2 vertices, %3 faces")
                       .arg(input.file, QString::number(document.mm()->cm.vn),
                            QString::number(document.mm()->cm.fn)));
    }
}

template <class Output>
void saveAll(const std::vector<Output>& outputs, MeshDocument& document, Report& report) {
    for (const Output& output : outputs) {
        save(output, document);
        report.sayNewLines(document.Log);
        report.say("saved " + output.file);
    }
}

void run(const CommandLine& commands, Report& report) {
    if (!commands.log.isEmpty()) report.openLog(commands.log);
    loadPlugins(commands.plugins, report);
    if (!commands.dump.isEmpty()) dumpFilters(commands.dump);
    MeshDocument document;
    try {
        openAll(commands.inputs, document, report);
        for (const QString& script : commands.scripts)
            runScript(script, document, report);
        saveAll(commands.projects, document, report);
        saveAll(commands.meshes, document, report);
    } catch (...) {
        report.sayNewLines(document.Log);  // what came before the error may explain it
        throw;
    }
}

int runCatchingAll(const QStringList& arguments) {
    Report report;
    try {
        const CommandLine commands = parseCommandLine(arguments);
        if (commands.help || arguments.isEmpty())
            std::fputs(usage(), stdout);
        else
            run(commands, report);
        return 0;
    } catch (const UsageError& error) {
        report.error(QString("%1; see --help").arg(error.what()));
        return 2;
    } catch (const std::bad_alloc&) {
        report.error("not enough memory");
    } catch (const std::exception& error) {
        report.error(QString::fromUtf8(error.what()));
    } catch (...) {
        report.error("an unknown error occurred");
    }
    return 1;
}

}  // namespace

}  // namespace server

namespace {

/// Of Qt's and MeshLab's messages only warnings are of use on a command line.
void passWarnings(QtMsgType type, const QMessageLogContext&, const QString& message) {
    const bool is_talk = type == QtDebugMsg || type == QtInfoMsg;
    if (is_talk || message.startsWith("QStandardPaths: XDG_RUNTIME_DIR")) return;
    std::fprintf(stderr, "%s\n", message.toLocal8Bit().constData());
}

}  // namespace

int main(int argc, char** argv) {
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    int no_arguments = 1;  // Qt would take some of ours for its own
    qInstallMessageHandler(passWarnings);
    qputenv("QT_QPA_PLATFORM", "offscreen");  // filters may ask for fonts and pictures, not windows
    QApplication application(no_arguments, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt has set the user's, and scripts have decimal points
    QLocale::setDefault(QLocale::C);
    const int code = server::runCatchingAll(arguments);
    std::fflush(stdout);
    std::_Exit(code);  // MeshLab's plugins are not made to be unloaded in any order
}
