// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QLocale>
#include <csignal>
#include <exception>
#include <new>

#include "drawings.h"
#include "file_names.h"
#include "laplacian_lines/version.h"

namespace {

int runCatchingAll(const QStringList& arguments) {
    try {
        const CommandLine commands = parseCommandLine(arguments);
        if (commands.help)
            std::fputs(usage().toUtf8().constData(), stdout);
        else if (commands.version)
            std::printf("laplacian-lines %s\n", laplacian_lines::version());
        else if (commands.is_collection)
            return drawCollection(commands) ? 0 : 1;
        else
            drawOne(commands);
        return 0;
    } catch (const std::bad_alloc&) {
        say(stderr, "laplacian-lines: not enough memory");
    } catch (const std::exception& error) {
        say(stderr, QString("laplacian-lines: ") + QString::fromUtf8(error.what()));
    }
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    keepFileNames();
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    int no_arguments = 1;                        // Qt would take some of ours for its own
    for (const int signal : {SIGXFSZ, SIGPIPE})  // where a quota or a pipe ends, writing says so
        std::signal(signal, SIG_IGN);
    const QCoreApplication application(no_arguments, argv);
    QLocale::setDefault(QLocale::C);
    return runCatchingAll(arguments);
}
