# SPDX-License-Identifier: GPL-3.0-or-later
# Edges in pictures, to compare lines with: scikit-image in a Python environment in the cache folder.

require environment/cache environment/messages environment/packages

IMAGE_TOOLS=(scikit-image==0.25.2 numpy==2.2.6 scipy==1.15.3 pillow==11.3.0)

# install_image_tools FOLDER
install_image_tools() {
    python3 -m venv "$1" &&
        "$1/bin/python" -m pip --disable-pip-version-check --no-input --retries 1 install "${IMAGE_TOOLS[@]}"
}

# ensure_image_tools: sets IMAGE_PYTHON
ensure_image_tools() {
    local folder log
    python3 -c 'import ensurepip, venv' 2>/dev/null || ensure_packages python3 python3-venv
    folder=$(cache_folder)/image_tools/1-python$(python3 -c 'import platform; print(platform.python_version())')
    IMAGE_PYTHON=$folder/bin/python
    [[ -x $IMAGE_PYTHON ]] && return 0
    log=$folder.log
    say "installing ${IMAGE_TOOLS[*]} into $folder (0.3 GB)"
    quietly "$log" publish_into "$folder" install_image_tools ||
        fail "${IMAGE_TOOLS[*]} could not be installed, without which there are no edges of pictures (log, canny); the log is $log"
}
