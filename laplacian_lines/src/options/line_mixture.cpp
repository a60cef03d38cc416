// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/line_mixture.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

namespace laplacian_lines {
namespace {

const char* const kUsual = "usual";

/// A name without case, blanks and underscores.
std::string normalized_name(const std::string& name) {
    std::string result;
    for (const char c : name)
        if (c != ' ' && c != '_') result += char(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

template <class Table>
auto* row_named(const Table& table, const std::string& name) {
    const std::string wanted = normalized_name(name);
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& row) {
        return normalized_name(row.key) == wanted || normalized_name(row.label) == wanted;
    });
    return found == table.end() ? nullptr : &*found;
}

std::optional<LineKindSet> kinds_of(const std::string& name) {
    if (normalized_name(name) == kUsual) return LineKindSet::defaults();
    if (const LineMixture* mixture = mixture_named(name)) return mixture->kinds;
    if (const LineKindDescription* kind = row_named(kLineKinds, name))
        return outlines_and({kind->kind});
    return std::nullopt;
}

}  // namespace

const LineMixture* mixture_named(const std::string& name) {
    return row_named(kLineMixtures, name);
}

std::optional<LineKindSet> kinds_named(const std::string& names) {
    if (const auto kinds = kinds_of(names)) return kinds;  // a label may have a comma
    std::string text = names;
    std::replace(text.begin(), text.end(), '+', ',');
    if (text.empty() || text.back() == ',') return std::nullopt;
    std::istringstream parts(text);
    LineKindSet result;
    for (std::string name; std::getline(parts, name, ',');) {
        const std::optional<LineKindSet> kinds = kinds_of(name);
        if (!kinds) return std::nullopt;
        result = result | *kinds;
    }
    return result;
}

std::string names_of_kinds() {
    std::set<std::string> listed;
    std::string result = kUsual;
    const auto list = [&](const auto& table) {
        for (const auto& row : table)
            if (listed.insert(row.key).second) result += std::string(", ") + row.key;
    };
    list(kLineMixtures);
    list(kLineKinds);
    return result;
}

}  // namespace laplacian_lines
