# SPDX-License-Identifier: GPL-3.0-or-later
# MeshLab by the year in its version, and the release of Debian that packages it.

require environment/packages

HOSTS=(2020 2022 2025)
declare -gA HOST_SUITE=([2020]=bookworm [2022]=trixie [2025]=forky)

# host_is_here HOST: whether it is the MeshLab that is installed on this machine
host_is_here() {
    [[ $(meshlab_version 2>/dev/null) == "$1".* ]]
}
