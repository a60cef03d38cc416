// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <csignal>
#include <new>

#include "drawings.h"
#include "laplacian_lines/version.h"

namespace {

int run(const Words& arguments) {
    const CommandLine commands = parse_command_line(arguments);
    if (commands.help)
        std::fputs(usage().c_str(), stdout);
    else if (commands.version)
        std::printf("laplacian-lines %s\n", laplacian_lines::version());
    else if (commands.is_collection)
        return draw_collection(commands) ? 0 : 1;
    else
        draw_one(commands);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    for (const int signal : {SIGXFSZ, SIGPIPE})  // write() then fails instead
        std::signal(signal, SIG_IGN);
    try {
        return run({argv + std::min(argc, 1), argv + argc});
    } catch (const std::bad_alloc&) {
        say(stderr, "laplacian-lines: not enough memory");
    } catch (const std::exception& error) {
        say(stderr, std::string("laplacian-lines: ") + error.what());
    }
    return 1;
}
