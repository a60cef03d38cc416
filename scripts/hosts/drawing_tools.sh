# SPDX-License-Identifier: GPL-3.0-or-later
# Programs of others that drawings are held against: a Python environment in the cache folder. Functions that cannot do
# their work set OBSTACLE.

require environment/python_environments

DRAWING_TOOLS=(ezdxf==1.4.5 vpype==1.15.0 svgpathtools==1.8.0 dask==2026.8.0 distributed==2026.8.0)

# ensure_drawing_tools: sets DRAWING_PYTHON
ensure_drawing_tools() {
    ensure_python_environment drawing_tools 1 "0.4 GB" "${DRAWING_TOOLS[@]}" || return 1
    DRAWING_PYTHON=$ENVIRONMENT_PYTHON
}
