# SPDX-License-Identifier: GPL-3.0-or-later
# PyMeshLab as a host of the filter plugin.

# test_pymeshlab CHECKOUT REGEX...: its tests. Sets OBSTACLE when it cannot be set up.
test_pymeshlab() {
    obstacle "tests in PyMeshLab do not exist yet"
}
