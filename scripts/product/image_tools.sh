# SPDX-License-Identifier: GPL-3.0-or-later
# Edges in pictures, to compare lines with: scikit-image in a Python environment in the cache folder.

require environment/messages environment/python_environments

IMAGE_TOOLS=(scikit-image==0.25.2 numpy==2.2.6 scipy==1.15.3 pillow==11.3.0)

# ensure_image_tools: sets IMAGE_PYTHON
ensure_image_tools() {
    ensure_python_environment image_tools 1 "0.3 GB" "${IMAGE_TOOLS[@]}" ||
        fail "there are no edges of pictures (log, canny): $OBSTACLE"
    IMAGE_PYTHON=$ENVIRONMENT_PYTHON
}
