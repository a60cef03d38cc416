// SPDX-License-Identifier: GPL-3.0-or-later
// write_columns FILE.py: the core's table of columns as a Python module, a row for each attribute.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iomanip>

#include "laplacian_lines/field_columns.h"

namespace {

using laplacian_lines::FieldAttribute;
using laplacian_lines::FieldColumn;

void write_row(const FieldColumn& column, const FieldAttribute& attribute, std::ostream& out) {
    out << "    (" << std::quoted(attribute.name) << ", " << attribute.floats << ", "
        << std::quoted(column.help) << ", " << std::quoted(column.unit) << ", "
        << (column.optional ? "True" : "False") << "),\n";
}

void write_module(std::ostream& out) {
    out << "# SPDX-License-Identifier: GPL-3.0-or-later\n"
           "\"\"\"Made from the core's table of columns when the plugin was built.\"\"\"\n\n"
           "# name, numbers a vertex, what its column holds, unit, whether it may be absent\n"
           "ROWS = (\n";
    for (const FieldColumn& column : laplacian_lines::field_columns)
        for (const FieldAttribute& attribute : column.attributes)
            if (attribute.floats > 0) write_row(column, attribute, out);
    out << ")\n";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "write_columns FILE.py\n");
        return 2;
    }
    try {
        std::ofstream file;
        file.exceptions(std::ofstream::failbit | std::ofstream::badbit);
        file.open(argv[1]);
        write_module(file);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "write_columns: %s\n", error.what());
        return 1;
    }
}
