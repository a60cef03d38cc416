# SPDX-License-Identifier: GPL-3.0-or-later
"""instructions.py PROGRAM: what ./bench --instructions prints of a small mesh."""
import contextlib
import io
import pathlib
import re
import shutil
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from measures.core_times import count_instructions
from product.models import bumpy_torus

if not shutil.which("valgrind"):
    print("skipped: valgrind is not installed")
    sys.exit(77)
with tempfile.TemporaryDirectory() as work, contextlib.redirect_stdout(io.StringIO()) as table:
    mesh = pathlib.Path(work, "torus.ply")
    mesh.write_text(bumpy_torus(60, 30))
    count_instructions(sys.argv[1], mesh)
print(table.getvalue())
for row in ("Laplacian lines and contours, [^|]*", "plain contours, not traced"):
    assert re.search(rf"^\| {row} \| [0-9.]+ \| [1-9][0-9]* \| [1-9][0-9]* \| 0\.[0-9]+ \| [1-9][0-9.]* \|$",
                     table.getvalue(), re.M), f"no instructions of: {row}"
