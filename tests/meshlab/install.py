# SPDX-License-Identifier: GPL-3.0-or-later
"""./run --install and --uninstall: the MeshLab that the user starts has the plugins in between, and only then."""
import harness
from harness import *
from product.extra_plugins import extra_plugins_folder, has_extra_plugins, install_plugins, uninstall_plugins
from product.stage import built_plugins

if not has_extra_plugins():
    with open("log", "wb") as log:
        code = subprocess.run([CHECKOUT / "run", "--install"], stderr=log,
                              env={**os.environ, "LAPLACIAN_LINES_BUILD": str(WORK / "build")}).returncode
    expect(code == 1, f"installing ended with {code}")
    # package.py does what it says
    expect_text("log", "MeshLab 2020.* loads no plugins from a user's folder; .* run ./run --package and, as root, apt install "
                rf"{WORK}/build/packages/\*.deb$")
    expect(not os.path.exists("build"), "it was built before it was refused")
    sys.exit()

plugins = built_plugins(BUILD, "plugins")
harness.STAGE = WORK / "unchanged"  # MeshLab itself, with the driver as the user's only plugin
(harness.STAGE / "bin").mkdir(parents=True)
(harness.STAGE / "bin/meshlab").symlink_to("/usr/bin/meshlab")
folder = extra_plugins_folder()
folder.mkdir(parents=True)
for driver in built_plugins(BUILD, "driver"):
    shutil.copy(driver, folder)
before = sorted(os.listdir(folder))

small_torus()
ACTIONS = """wait
load torus.ply
expect-action Compute Laplacian Lines
expect-action Laplacian Lines unchecked
check Laplacian Lines on
size 300x200
grab lines.png
"""
drive_to_failure("no action 'Compute Laplacian Lines'", ACTIONS)
install_plugins(plugins)
drive(ACTIONS)
install_plugins(plugins)  # in place of the first ones
uninstall_plugins()
drive_to_failure("no action 'Compute Laplacian Lines'", ACTIONS)
expect(sorted(os.listdir(folder)) == before, "there are other files than before")
expect(said_by(uninstall_plugins) == 1, "what was not installed was removed")
expect_text("log", "--install has installed nothing in")
