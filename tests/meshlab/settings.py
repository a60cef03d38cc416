# SPDX-License-Identifier: GPL-3.0-or-later
"""./run --set in a window: the lines follow, and the next window has the user's settings again."""
from harness import *
from product.meshlab import open_window, settings_commands

torus()
REDS = ("Line Color=red", "contour_color=#f00")


def kept_after(commands, *settings):
    """What MeshLab has kept of the decoration's parameters, with the window closed at the end."""
    shutil.rmtree("window", ignore_errors=True)
    os.mkdir("window")
    open_window(STAGE, WORK / "window", ["torus.ply"], [
        *settings_commands(BUILD, settings), "check Show Info Panel off", "check Show Trackball off",
        "check Laplacian Lines Probe on",
        *commands, "leave"])
    kept = sorted(line for line in text_of("home/.config/VCG/MeshLab_64bit_fp.conf").splitlines()
                  if "LaplacianLines" in line)
    expect(kept, "MeshLab keeps no parameters of the decoration")
    return kept


before = kept_after([])
expect(kept_after(["expect-lines detail=70 ridges=0"], "Detail=70", "ridges=no", *REDS) == before,
       "what was set for one window is kept")
expect(kept_after(["expect-lines"], *REDS) == before, "what was set for one window is kept")

expect(said_by(settings_commands, BUILD, ["Detail=70", "Detail=abc"]) == 1, "abc is taken")
expect_text("log", '^laplacian-lines: "Detail" is abc. It has to be between 0 and 100.$')
expect(said_by(settings_commands, BUILD, ["Valley Angle=20"]) == 1, "what went is taken")
expect_text("log", '"Valley Angle" can no longer be set, it is always that of ridges. Set Ridge Angle.$')
done = subprocess.run([BUILD / "bin/decoration_settings", "Detail=70"], stdout=open("/dev/full", "w"),
                      stderr=subprocess.PIPE, text=True)
expect(done.returncode and "cannot be written: No space left on device" in done.stderr,
       "half of the settings were taken")
