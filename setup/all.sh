# SPDX-License-Identifier: GPL-3.0-or-later
# All that the scripts share; each part says what it is for.

for part in messages cache packages apt_sources headers build package extra_plugins server stage display private_home models picture roots pymeshlab hosts bench checks sanitized threads; do
    # shellcheck source=/dev/null
    source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/$part.sh"
done
unset part
