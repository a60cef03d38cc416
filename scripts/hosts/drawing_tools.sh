# SPDX-License-Identifier: GPL-3.0-or-later
# Programs of others that drawings are held against: a Python environment in the cache folder. Functions that cannot do
# their work set OBSTACLE.

require environment/cache environment/messages environment/obstacles environment/packages

DRAWING_TOOLS=(ezdxf==1.4.5 vpype==1.15.0 svgpathtools==1.8.0 dask==2026.8.0 distributed==2026.8.0)

# install_drawing_tools FOLDER
install_drawing_tools() {
    python3 -m venv "$1" &&
        "$1/bin/python" -m pip --disable-pip-version-check --no-input --retries 1 install "${DRAWING_TOOLS[@]}"
}

# ensure_drawing_tools: sets DRAWING_PYTHON
ensure_drawing_tools() {
    local folder log
    python3 -c 'import ensurepip, venv' 2>/dev/null || (ensure_packages python3 python3-venv) ||
        obstacle "python3-venv could not be installed" || return 1
    folder=$(cache_folder)/drawing_tools/1-python$(python3 -c 'import platform; print(platform.python_version())')
    DRAWING_PYTHON=$folder/bin/python
    [[ -x $DRAWING_PYTHON ]] && return 0
    log=$folder.log
    say "installing ${DRAWING_TOOLS[*]} into $folder (0.4 GB)"
    quietly "$log" publish_into "$folder" install_drawing_tools ||
        obstacle "${DRAWING_TOOLS[*]} could not be installed; the log is $log"
}
