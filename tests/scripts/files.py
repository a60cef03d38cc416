# SPDX-License-Identifier: GPL-3.0-or-later
"""A file that scripts write is there whole, or what was there before. What is kept in the cache and in the user's
folders; the links of a stage; sheets of pictures."""
import resource
from unittest import mock

from harness import *

from environment.files import publish_into, put_file
from product import extra_plugins, stage
from product.meshlab import loadable_mesh
from product.sheet import lay_out, escaped_label

ZEROS = bytes(100000)


def path(name, contents=b""):
    file = pathlib.Path(name)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(contents)
    return file


class AtomicFiles(ScriptTest):
    def test_files(self):
        new, target = path("new", ZEROS), pathlib.Path("place/s%d \\n.png")
        target.parent.mkdir()
        put_file(new, target)
        self.assertEqual(target.read_bytes(), ZEROS)
        self.assertEqual(target.stat().st_mode, new.stat().st_mode)
        target.write_text("old")
        most = resource.getrlimit(resource.RLIMIT_FSIZE)[1]
        self.addCleanup(resource.setrlimit, resource.RLIMIT_FSIZE, (most, most))
        resource.setrlimit(resource.RLIMIT_FSIZE, (97 << 10, most))  # whose end is only found when the file is written
        self.refused(re.escape(f"cannot write {target}: File too large; what was there is unchanged"), put_file, new, target)
        self.assertEqual((target.read_text(), os.listdir("place")), ("old", [target.name]))
        self.refused("it is a folder", put_file, new, "place")
        self.refused("no such folder", put_file, new, "nowhere/a.png")
        pathlib.Path("link").symlink_to("/dev/null")
        put_file(new, "link")
        self.assertTrue(pathlib.Path("/dev/null").is_char_device() and os.path.islink("link"))

    def test_folders(self):
        thing = self.work / "cache/thing"
        self.assertTrue(publish_into(thing, lambda folder: (folder / "file").write_bytes(ZEROS)))
        self.assertFalse(publish_into(thing, lambda folder: (folder / "other").touch()))
        self.assertEqual((os.listdir(thing), os.listdir("cache")), (["file"], ["thing"]))
        path("new")
        said = self.said_by(lambda: self.assertFalse(publish_into(self.work / "new/thing", self.fail)))
        self.assertIn("cannot write", said)

    def test_names(self):
        self.assertEqual(escaped_label("@a%w\\n"), "\\@a%%w\\\\n")
        self.assertEqual(escaped_label("a\ngrab ü"), "a?grab ü")
        os.mkdir("folder")
        path("mesh\ngrab b.ply", ZEROS)
        kept = []
        self.said_by(lambda: kept.append(loadable_mesh("mesh\ngrab b.ply", pathlib.Path("folder"))))
        self.assertNotIn("\n", str(kept[0]))
        self.assertEqual(kept[0].read_bytes(), ZEROS)


class Places(ScriptTest):
    def test_stage(self):
        installed, ours = ([path(self.work / folder / f"{name}.so") for name in names]
                           for folder, names in (("installed", "ab"), ("ours", "bc")))
        links = self.work / "links"
        stage.link_all(links, installed + ours)
        self.assertEqual([os.readlink(links / f"{name}.so") for name in "abc"], [str(installed[0]), *map(str, ours)])
        before = os.lstat(links / "a.so").st_ino
        stage.link_all(links, installed)
        self.assertEqual(os.lstat(links / "a.so").st_ino, before, "a link that was right was made anew")
        self.assertEqual(os.readlink(links / "b.so"), str(installed[1]), "a link still leads to our plugin")
        self.assertEqual(sorted(os.listdir(links)), ["a.so", "b.so"])

    def install(self, version):
        plugins = [path(self.work / f"plugins/lib{name}_laplacian_lines.so", os.urandom(50000)) for name in ("decorate", "filter")]
        with (mock.patch("environment.packages.meshlab_version", return_value=version),
              mock.patch.object(extra_plugins, "refuse_installed_plugins")):
            self.said_by(extra_plugins.install_plugins, plugins)
            return extra_plugins.extra_plugins_folder(), [plugin.read_bytes() for plugin in plugins]

    def test_extra_plugins(self):
        os.environ["XDG_DATA_HOME"] = str(self.work / "data")
        path("data/of_others")
        for _ in range(2):
            folder, plugins = self.install("2022.02+x")
            self.assertEqual([file.read_bytes() for file in sorted(folder.iterdir())], plugins)
        self.install("2025.07+x")
        self.assertFalse(folder.exists(), "plugins of another version are left")
        self.said_by(extra_plugins.uninstall_plugins)
        self.assertEqual(os.listdir("data"), ["of_others"])
        self.refused("has installed nothing in", extra_plugins.uninstall_plugins)

    def test_sheets(self):
        for columns, cell, size, count, together in (
                (3, (1200, 900), (1200, 900), 36, 18),  # all kinds of lines of two meshes
                (2, (1200, 900), (1200, 900), 8, 4),  # rows of four would be too wide, rows of three and one uneven
                (3, (500, 400), (500, 400), 7, 7), (1, (5000, 400), (5000, 400), 3, 3),
                (6, (614, 460), (1200, 900), 100, 1)):  # a hundred meshes
            self.assertEqual(lay_out(size, count, together), (columns, cell))


unittest.main()
