# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters in PyMeshLab, of the version that the plugin was built for."""

from __future__ import annotations

import os
import pathlib


def load(plugin: str | os.PathLike[str] | None = None) -> None:
    """Loads the filters into PyMeshLab, also as methods of MeshSet; loading twice does nothing.

    The plugin is beside this package, or where the environment variable LAPLACIAN_LINES_PLUGIN says. Parameters have the
    names of filter scripts. Raises ImportError if there is no plugin, pymeshlab.PyMeshLabException if PyMeshLab refuses it.
    """
    import pymeshlab

    beside = pathlib.Path(__file__).resolve().parents[1] / "libfilter_laplacian_lines.so"
    file = pathlib.Path(plugin or os.environ.get("LAPLACIAN_LINES_PLUGIN") or beside)
    if not file.exists():
        raise ImportError(f"There is no plugin {file}: ./run --python builds it for the PyMeshLab that it installs.")
    before = set(pymeshlab.filter_list())
    if "compute_laplacian_lines_per_vertex" not in before:
        pymeshlab.load_plugin(str(file))
    # PyMeshLab itself does this only for the plugins that it has at its import.
    for name in set(pymeshlab.filter_list()) - before:
        setattr(pymeshlab.MeshSet, name, pymeshlab.bind_function(name))
