// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <csignal>
#include <new>

#include "drawings.h"
#include "laplacian_lines/version.h"

#ifdef _WIN32
#include <windows.h>

#include <filesystem>
#endif

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

/// The exit code.
int run_catching_all(const Words& arguments) {
    try {
        return run(arguments);
    } catch (const std::bad_alloc&) {
        say(stderr, "laplacian-lines: not enough memory");
    } catch (const std::exception& error) {
        say(stderr, std::string("laplacian-lines: ") + error.what());
    }
    return 1;
}

}  // namespace

#ifdef _WIN32
int wmain(int argc, wchar_t** argv) {
    SetConsoleOutputCP(CP_UTF8);
    Words arguments;
    for (int i = 1; i < argc; ++i)
        arguments.push_back(std::filesystem::path(argv[i]).u8string());
    return run_catching_all(arguments);
}
#else
int main(int argc, char** argv) {
    for (const int signal : {SIGXFSZ, SIGPIPE})  // write() then fails instead
        std::signal(signal, SIG_IGN);
    return run_catching_all({argv + std::min(argc, 1), argv + argc});
}
#endif
