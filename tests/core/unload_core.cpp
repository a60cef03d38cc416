// SPDX-License-Identifier: GPL-3.0-or-later
// unload_core LIBRARY: a plugin's threads end before its code goes.
#include <dlfcn.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <iterator>

namespace {

long thread_count() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

/// Within a second: /proc lists a joined thread for a moment more.
bool comes_to(long count) {
    for (int waits = 0; waits < 1000 && thread_count() != count; ++waits)
        usleep(1000);
    return thread_count() == count;
}

bool expect(bool holds, const char* what) {
    if (!holds) std::printf("not so: %s\n", what);
    return holds;
}

bool load_and_unload(const char* file) {
    const long before = thread_count();
    void* const library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    if (!expect(library, "the library can be loaded")) return false;
    const auto count = reinterpret_cast<int (*)(int)>(dlsym(library, "count_on_threads"));
    return expect(count && count(1000) == 1000, "it counts") &&
           expect(thread_count() > before, "it has threads") &&
           expect(dlclose(library) == 0 && !dlopen(file, RTLD_NOLOAD | RTLD_LAZY), "it goes") &&
           expect(comes_to(before), "its threads are gone");
}

}  // namespace

int main(int count, char** arguments) {
    for (int round = 0; round < 10; ++round)
        if (count != 2 || !load_and_unload(arguments[1])) return 1;
}
