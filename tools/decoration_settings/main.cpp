// SPDX-License-Identifier: GPL-3.0-or-later
// Checks parameters of the decoration and prints the driver's commands that set them:
//   decoration_settings NAME=VALUE...
#include <cstdio>
#include <exception>

#include "decoration_settings.h"

int main(int argc, char** argv) try {
    QString commands;
    for (int i = 1; i < argc; ++i) {
        const DecorationSetting setting = readDecorationSetting(QString::fromLocal8Bit(argv[i]));
        commands += QString("setdeco %1 = %2\n").arg(setting.label, setting.value);
    }
    std::fputs(commands.toLocal8Bit().constData(), stdout);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
