# SPDX-License-Identifier: GPL-3.0-or-later
# Python environments in the cache folder. Functions that cannot do their work set OBSTACLE.

require environment/cache environment/messages environment/obstacles environment/packages

# install_python_packages PACKAGE... FOLDER
install_python_packages() {
    local folder=${*: -1}
    python3 -m venv "$folder" &&
        "$folder/bin/python" -m pip --disable-pip-version-check --no-input install "${@:1:$#-1}"
}

# ensure_python_environment NAME VERSION SIZE PACKAGE...: one for this Python, of about that size; sets
# ENVIRONMENT_PYTHON. Other packages need another VERSION.
ensure_python_environment() {
    local folder log
    python3 -c 'import ensurepip, venv' 2>/dev/null || (ensure_packages python3 python3-venv) ||
        obstacle "python3-venv could not be installed" || return 1
    folder=$(cache_folder)/$1/$2-python$(python3 -c 'import platform; print(platform.python_version())')
    ENVIRONMENT_PYTHON=$folder/bin/python
    [[ -x $ENVIRONMENT_PYTHON ]] && return 0
    log=$folder.log
    say "installing ${*:4} into $folder ($3)"
    quietly "$log" publish_into "$folder" install_python_packages "${@:4}" ||
        obstacle "${*:4} could not be installed for $(python3 --version); the log is $log"
}
