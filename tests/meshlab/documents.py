# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of the documents work when they are pasted: those that draw are run, of the others ./run takes the
options. Without a mesh they draw the bumpy torus, as where the dragon cannot be fetched."""
import math
from unittest import mock

from harness import *
from product import command, drawing, meshlabserver, models


def jar(file):
    """Round about y, closed, with walls and half a handle."""
    profile = [(0, 0), (30, 0), (42, 40), (38, 70), (24, 90), (26, 100), (23, 100), (21, 90), (35, 70), (39, 40), (28, 3), (0, 3)]
    sides, rings = 64, len(profile) - 2
    points = [f"0 {profile[0][1]} 0", f"0 {profile[-1][1]} 0"]
    faces = []
    for i in range(sides):
        points += [f"{r * math.cos(math.tau * i / sides):.5f} {y} {-r * math.sin(math.tau * i / sides):.5f}"
                   for r, y in profile[1:-1]]
        first, second = 2 + i * rings, 2 + (i + 1) % sides * rings
        faces += [f"3 0 {second} {first}", f"3 1 {first + rings - 1} {second + rings - 1}"]
        faces += [f"4 {first + k} {second + k} {second + k + 1} {first + k + 1}" for k in range(rings - 1)]
    ply(file, points, faces)


def commands(text):
    """Lines of the blocks of code that have no language."""
    for language, block in re.findall(r"(?ms)^```(\w*)\n(.*?)^```$", text):
        yield from () if language else block.splitlines()


def call(words):
    """The exit code of a line of a document on a server; None if nothing of it is run here."""
    os.environ.pop("DISPLAY", None)
    folder = WORK / "temporary"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    if words[0] == "laplacian-lines" or words[:2] == ["./run", "--drawing"]:
        return drawing.run_drawing(words[1 if words[0] == "laplacian-lines" else 2:], folder)
    options = command.parse(words[1:])
    if options.picture:
        return command.run_command(words[1:], folder) or 0
    if options.server and (STAGE / "bin/meshlabserver").exists():
        return meshlabserver.run_server(STAGE, options.server, folder)
    return None


for name in ("scan.ply", "find.ply", "part.ply", "scans/first.ply", "scans/second.ply"):
    pathlib.Path(name).parent.mkdir(exist_ok=True)
    small_torus(name)
for number in range(3):
    box(f"fragment_{number + 1}.ply", (number, 0, 0), (.9, 1, 1))
jar("vessel.ply")
pathlib.Path("docs").symlink_to(CHECKOUT / "docs")
run_count = 0
with mock.patch.object(models, "stanford_dragon", lambda: None), mock.patch.object(drawing, "build_targets"), \
        mock.patch.object(command, "build_and_stage", lambda *_: STAGE):
    for page in [CHECKOUT / "README.md", *sorted((CHECKOUT / "docs").glob("*.md"))]:
        for line in commands(page.read_text()):
            if line.startswith(("./run", "laplacian-lines")):
                words = shlex.split(line, comments=True)
                written = [word for word in words if word.endswith((".png", ".pdf", ".svg", ".dxf"))][:1]
                for file in written:
                    pathlib.Path(file).unlink(missing_ok=True)
                code = call(words)
                expect(code in (None, 0), f"{page.name}: {line}\nends with {code}")
                expect(code is None or all(map(is_file, written)), f"{page.name}: {line}\nwrites no {written}")
                run_count += code == 0
expect(run_count >= 12, f"only {run_count} commands were found")
