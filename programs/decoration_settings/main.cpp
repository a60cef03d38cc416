// SPDX-License-Identifier: GPL-3.0-or-later
// Checks parameters of the decoration and prints the driver's commands that set them:
//   decoration_settings NAME=VALUE...
// or, a line each, those of the pictures of a comparison: label, a tab, commands with " ; "
// between:
//   decoration_settings --kinds NAMES
#include <cstdio>
#include <exception>

#include "driver_commands.h"

namespace {

void print(const QString& text) {
    std::fputs(text.toLocal8Bit().constData(), stdout);
}

void print_pictures(const QString& names) {
    for (const ComparedPicture& picture : compared_pictures(names))
        print(picture.label + '\t' + picture.commands.join(" ; ") + '\n');
}

}  // namespace

int main(int argc, char** argv) try {
    QStringList words;
    for (int i = 1; i < argc; ++i)
        words << QString::fromLocal8Bit(argv[i]);
    if (words.value(0) == "--kinds") {
        print_pictures(words.value(1));
    } else {
        for (const QString& command : setting_commands(words))
            print(command + '\n');
    }
    if (std::fflush(stdout) == 0) return 0;
    std::perror("the commands for the driver cannot be written");
    return 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
