# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured drawings of many meshes on several machines, by Dask (pip install dask distributed).

draw_with_dask.py [--scheduler ADDRESS] [--program FILE] FOLDER MESH... [-- OPTION VALUE...]

Each mesh is a task: a worker draws it into FOLDER, as `./run --drawing FOLDER/ OPTION VALUE... MESH` does. Then the
contact sheet of all is written here. All machines have to see the meshes and FOLDER by the same names, and the program,
which the first `./run --drawing` builds. Without a scheduler, two workers on this machine do the work.
"""

import argparse
import pathlib
import subprocess
import sys

try:
    from dask.distributed import Client, LocalCluster, as_completed
except ImportError as error:
    sys.exit(f"draw_with_dask.py needs Dask ({error}). Install it: {sys.executable} -m pip install dask distributed")

PROGRAM = pathlib.Path(__file__).resolve().parent.parent / "build/bin/laplacian-lines"


def draw(program, folder, options, meshes):
    """What the program says, and whether it could draw all of these meshes."""
    done = subprocess.run([program, f"{folder}/", *options, *meshes], capture_output=True, text=True)
    return done.returncode == 0, done.stdout + done.stderr


def read_arguments(arguments):
    options = []
    if "--" in arguments:
        options = arguments[arguments.index("--") + 1 :]
        arguments = arguments[: arguments.index("--")]
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0], epilog="OPTIONs, after --: of ./run --drawing")
    parser.add_argument("--scheduler", help="such as tcp://host:8786; none: two workers on this machine")
    parser.add_argument("--program", default=str(PROGRAM))
    parser.add_argument("folder")
    parser.add_argument("mesh", nargs="+")
    return parser.parse_args(arguments), options


def main():
    chosen, options = read_arguments(sys.argv[1:])
    cluster = chosen.scheduler or LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    succeeded = True
    with Client(cluster) as client:
        # a mesh that cannot be drawn is no reason to try again elsewhere
        tasks = [client.submit(draw, chosen.program, chosen.folder, options, [m], retries=0) for m in chosen.mesh]
        for _, (was_drawn, said) in as_completed(tasks, with_results=True):
            succeeded &= was_drawn
            print(*(line for line in said.splitlines() if line.endswith(": drawn") or ": not drawn: " in line), sep="\n")
    drawn_all, said = draw(chosen.program, chosen.folder, options, chosen.mesh)
    print(said.splitlines()[-1] if said else "")
    sys.exit(0 if succeeded and drawn_all else 1)


if __name__ == "__main__":
    main()
