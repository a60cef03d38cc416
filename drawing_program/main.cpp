// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <QGuiApplication>
#include <QLocale>
#include <clocale>
#include <cstdio>
#include <exception>
#include <new>

#include "command_line.h"
#include "laplacian_lines/precompute.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/sheet_file.h"
#include "mesh_reading.h"

namespace {

void say(FILE* stream, const QString& line) {
    std::fprintf(stream, "%s\n", line.toLocal8Bit().constData());
}

QString inMillimetres(const laplacian_lines::TriangleMesh& mesh, double unit) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh.positions)
        if (p.allFinite()) box.extend(p);
    const Eigen::Vector3d size = unit * box.sizes();
    return QString("%1 x %2 x %3 mm").arg(size.x()).arg(size.y()).arg(size.z());
}

void run(const CommandLine& commands) {
    line_drawing::checkSheetFile(commands.drawing);
    const laplacian_lines::TriangleMesh mesh = readMesh(commands.mesh);
    const line_drawing::SheetOptions& options = commands.options;
    say(stdout, QString("the object is %1 large, with %2 mm to the unit of the mesh; --unit says "
                        "otherwise")
                    .arg(inMillimetres(mesh, options.mm_per_unit))
                    .arg(options.mm_per_unit));
    const laplacian_lines::Field field = laplacian_lines::precompute(mesh);
    line_drawing::writeSheet(line_drawing::makeSheet(mesh, field, options), commands.drawing);
    say(stdout, "the drawing is " + commands.drawing);
}

int runCatchingAll(const QStringList& arguments) {
    try {
        const CommandLine commands = parseCommandLine(arguments);
        if (commands.help)
            std::fputs(usage(), stdout);
        else
            run(commands);
        return 0;
    } catch (const std::bad_alloc&) {
        say(stderr, "laplacian_lines_drawing: not enough memory");
    } catch (const std::exception& error) {
        say(stderr, QString("laplacian_lines_drawing: ") + QString::fromUtf8(error.what()));
    }
    return 1;
}

/// Qt misses folders that only programs with windows need.
void passOn(QtMsgType, const QMessageLogContext&, const QString& message) {
    if (!message.startsWith("QStandardPaths:")) say(stderr, message);
}

}  // namespace

int main(int argc, char** argv) {
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    qputenv("QT_QPA_PLATFORM", "offscreen");  // for fonts; nothing is shown
    int no_arguments = 1;                     // Qt would take some of ours for its own
    qInstallMessageHandler(passOn);
    const QGuiApplication application(no_arguments, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt has set the user's, and readers of meshes expect points
    QLocale::setDefault(QLocale::C);
    return runCatchingAll(arguments);
}
