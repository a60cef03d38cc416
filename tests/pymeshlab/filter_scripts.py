# SPDX-License-Identifier: GPL-3.0-or-later
"""The example script does in PyMeshLab what it does elsewhere."""

import laplacian_lines
from harness import EXAMPLES, expect_error, expect_no_field, expect_same_field
from harness import meshes, reference, work_folder

SCRIPT = EXAMPLES / "laplacian_lines.mlx"


def run(script):
    ms = meshes()
    ms.load_filter_script(str(script))
    ms.apply_filter_script()
    return ms.current_mesh()


def changed(name, old, new):
    text = SCRIPT.read_text()
    assert old in text
    path = work_folder("scripts") / f"{name}.mlx"
    path.write_text(text.replace(old, new))
    return path


computed, _ = reference()
expect_same_field(laplacian_lines.field(run(SCRIPT)), computed, 0)

# the script's values count, not the defaults
ms = meshes()
ms.compute_laplacian_lines_per_vertex(laplace_operator="Cotangent", gradient_radius=5)
expected = laplacian_lines.field(ms.current_mesh())
script = changed("cotangent", 'name="laplace_operator" type="RichEnum" value="0"',
                 'name="laplace_operator" type="RichEnum" value="1"')
script.write_text(script.read_text().replace('name="gradient_radius" type="RichFloat" value="3"',
                                             'name="gradient_radius" type="RichFloat" value="5"'))
expect_same_field(laplacian_lines.field(run(script)), expected, 0)

# what is missing has its default
default = changed("default", '  <Param name="accuracy" type="RichFloat" value="0.001"/>\n', "")
expect_same_field(laplacian_lines.field(run(default)), computed, 0)

bad = meshes()
bad.load_filter_script(str(changed("bad", 'type="RichFloat" value="0.001"', 'type="RichFloat" value="5"')))
expect_error('"Accuracy" is 5. It has to be between 1e-06 and 0.1', bad.apply_filter_script)
expect_no_field(bad.current_mesh())

# a script that PyMeshLab writes, read again
saved = work_folder("scripts") / "saved.mlx"
ms.save_filter_script(str(saved))
expect_same_field(laplacian_lines.field(run(saved)), expected, 1e-5)  # MeshLab writes six digits
