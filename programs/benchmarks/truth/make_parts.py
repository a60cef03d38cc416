# SPDX-License-Identifier: GPL-3.0-or-later
"""make_parts.py [--small] [--jobs N] FOLDER [PART...]: writes FOLDER/PART.part with the meshes and the exact visible lines
of each part, see part_file.py; what lies there already stays. --small: coarse meshes and few directions, as the repository
has them. Directions from which OpenCASCADE fails or takes longer than a minute are left out with a line in
FOLDER/failures.txt."""

import argparse
import concurrent.futures
import multiprocessing
import os
import pathlib
import sys

import cad_parts
import directions
import hidden_lines
import part_file

SECONDS_FOR_A_DIRECTION = 60
SECONDS_FOR_A_PART = 900  # to build it, and for each of its meshes
SMALL_DEFLECTIONS = hidden_lines.DEFLECTIONS[0:1] + hidden_lines.DEFLECTIONS[2:3]
SMALL_DIRECTIONS = ["0-0", "00+ by 1e-6", "+-0 by 1 degree", "--+", "23,31"]


def work(name, deflections, views, pipe):
    """In a process of its own, since OpenCASCADE cannot be stopped: sends a packed piece for each request."""
    made = cad_parts.PARTS[name]()
    shape = union = hidden_lines.shape_of(made[0] if isinstance(made, tuple) else made)
    if isinstance(made, tuple):
        union = hidden_lines.shape_of(made[1])
    pipe.send(None)
    while True:
        kind, number = pipe.recv()
        try:
            if kind == "mesh":
                deflection = deflections[number]
                pipe.send(part_file.packed_mesh(*deflection, *hidden_lines.tessellation(shape, *deflection)))
            else:
                view = views[number]
                demanded, allowed = hidden_lines.visible_lines(union, view[2])
                if union is not shape:
                    allowed += hidden_lines.visible_lines(shape, view[2])[0]
                pipe.send(part_file.packed_view(*view, demanded, allowed))
        except Exception as error:
            pipe.send(str(error) or type(error).__name__)


class Worker:
    def __init__(self, *arguments):
        self.arguments = arguments
        self.start()

    def start(self):
        self.pipe, other = multiprocessing.Pipe()
        self.process = multiprocessing.Process(target=work, args=(*self.arguments, other), daemon=True)
        self.process.start()
        other.close()
        self.answer(SECONDS_FOR_A_PART)

    def answer(self, seconds):
        if not self.pipe.poll(seconds):
            raise TimeoutError(f"took longer than {seconds} s")
        answer = self.pipe.recv()
        if isinstance(answer, str):
            raise RuntimeError(answer)
        return answer

    def mesh(self, number):
        self.pipe.send(("mesh", number))
        return self.answer(SECONDS_FOR_A_PART)

    def view(self, number):
        """After a failure of the process there is a new one."""
        self.pipe.send(("view", number))
        try:
            return self.answer(SECONDS_FOR_A_DIRECTION)
        except (TimeoutError, EOFError):
            self.stop()
            self.start()
            raise

    def stop(self):
        self.process.kill()
        self.process.join()


def make_part(name, deflections, views, folder):
    """Returns lines about what has failed."""
    worker = Worker(name, deflections, views)
    meshes = [worker.mesh(i) for i in range(len(deflections))]
    packed, failures = [], []
    for i, view in enumerate(views):
        try:
            packed.append(worker.view(i))
        except Exception as error:
            failures.append(f"{name}\t{view[0]}\t{error or type(error).__name__}")
    worker.stop()
    file = folder / f"{name}.part"
    scratch = folder / f"{name}.part.{os.getpid()}"
    scratch.write_bytes(part_file.packed_part(meshes, packed))
    scratch.rename(file)
    print(f"{name}: {len(packed)} of {len(views)} directions, {file.stat().st_size // 1024} kB", flush=True)
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--small", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("parts", nargs="*")
    arguments = parser.parse_args()
    for name in arguments.parts:
        if name not in cad_parts.PARTS:
            sys.exit(f"There is no part {name}. Parts are {', '.join(cad_parts.PARTS)}.")
    arguments.folder.mkdir(parents=True, exist_ok=True)
    names = [n for n in arguments.parts or cad_parts.PARTS if not (arguments.folder / f"{n}.part").exists()]
    views = directions.all_directions()
    deflections = hidden_lines.DEFLECTIONS
    if arguments.small:
        views = [view for view in views if view[0] in SMALL_DIRECTIONS]
        deflections = SMALL_DEFLECTIONS
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        made = [pool.submit(make_part, name, deflections, views, arguments.folder) for name in names]
        failures = [line for part in made for line in part.result()]
    if failures:
        with open(arguments.folder / "failures.txt", "a") as file:
            file.writelines(line + "\n" for line in failures)
        print(*failures, sep="\n", file=sys.stderr)


if __name__ == "__main__":
    multiprocessing.set_start_method("spawn")
    main()
