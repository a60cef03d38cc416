// SPDX-License-Identifier: GPL-3.0-or-later
#include "places.h"

#include <cstdlib>

namespace fs = std::filesystem;

namespace {

fs::path folder_in(const char* variable) {
    const char* value = std::getenv(variable);
    return value ? value : "";
}

/// As in the scripts.
fs::path cache_folder() {
    if (const fs::path own = folder_in("LAPLACIAN_LINES_CACHE"); !own.empty()) return own;
    const fs::path users = folder_in("XDG_CACHE_HOME");
    return (users.empty() ? folder_in("HOME") / ".cache" : users) / "laplacian-lines";
}

}  // namespace

fs::path places::repository() {
    return REPOSITORY;
}

fs::path places::scanned_model(const std::string& name) {
    for (const fs::path& folder :
         {repository().parent_path() / "shared/models", cache_folder() / "models/dragon"})
        for (const char* type : {".obj.gz", ".ply.gz", ".ply"})
            if (const fs::path file = folder / (name + type); fs::exists(file)) return file;
    return {};
}
