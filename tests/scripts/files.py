# SPDX-License-Identifier: GPL-3.0-or-later
"""A file that scripts write is there whole, or what was there before; devices and pipes are written into. What is kept
in the cache and in the user's folders; the links of a stage."""
import threading
from unittest import mock

from harness import *

from environment import headers
from environment.files import publish_into, put_file, umask
from product import extra_plugins, stage
from product.meshlab import drivable_mesh
from product.models import kept_bumpy_torus
from product.sheet import plain_label

ZEROS = bytes(100000)


def path(name, contents=b""):
    file = pathlib.Path(name)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(contents)
    return file


class WholeFiles(ScriptTest):
    def test_files(self):
        new, target = path("new", ZEROS), path("place/s%d \\n.png")
        target.unlink()
        put_file(new, target)
        self.assertEqual(target.read_bytes(), ZEROS)
        self.assertEqual(target.stat().st_mode & 0o777, 0o666 & ~umask())
        target.write_text("old")
        for kilobytes in (1, 50, 97):
            self.within(kilobytes, re.escape(f"cannot write {target}: File too large; what was there is unchanged"),
                        put_file, new, target)
            self.assertEqual((target.read_text(), os.listdir("place")), ("old", [target.name]))
        os.mkdir("folder")
        self.refused("it is a folder", put_file, new, "folder")
        self.refused("no such folder", put_file, new, "nowhere/a.png")

    def test_links_devices_and_pipes(self):
        new, link = path("new", ZEROS), pathlib.Path("link")
        link.symlink_to(path("place/file"))
        put_file(new, link)
        self.assertTrue(link.is_symlink() and pathlib.Path("place/file").read_bytes() == ZEROS)
        link.unlink()
        link.symlink_to("/dev/null")
        put_file(new, link)
        self.assertTrue(pathlib.Path("/dev/null").is_char_device() and link.is_symlink())
        os.mkfifo("pipe")
        read = []
        reader = threading.Thread(target=lambda: read.append(pathlib.Path("pipe").read_bytes()))
        reader.start()
        put_file(new, "pipe")
        reader.join()
        self.assertTrue(pathlib.Path("pipe").is_fifo() and read == [ZEROS])

    def test_names(self):
        self.assertEqual(plain_label("@a%w\\n"), "\\@a%%w\\\\n")
        self.assertEqual(plain_label("a\ngrab b"), "a?grab b")
        self.assertEqual((plain_label(os.fsdecode(b"caf\xe9 \xc3\xbc")), plain_label("ü")), ("caf? ??", "ü"))
        os.mkdir("folder")
        path("mesh\ngrab b.ply", ZEROS)
        kept = []
        self.said_by(lambda: kept.append(drivable_mesh("mesh\ngrab b.ply", pathlib.Path("folder"))))
        self.assertNotIn("\n", str(kept[0]))
        self.assertEqual(kept[0].read_bytes(), ZEROS)

    def test_outputs(self):
        for name, time in (("older", 978307200), ("begun", 978393600), ("new", 978480000)):
            os.utime(path(name), (time, time))
        begun = pathlib.Path("begun")
        self.assertTrue(stage.outputs_are_there(begun, ["-i", "older", "-o", "new"]))
        said = self.said_by(lambda: self.assertFalse(stage.outputs_are_there(begun,
                                                                             "-o new -o older -o nowhere/a.ply".split())))
        self.assertEqual(said, "laplacian-lines: older was not written\nlaplacian-lines: nowhere/a.ply was not written\n")


class Cache(ScriptTest):
    def setUp(self):
        super().setUp()
        os.environ["LAPLACIAN_LINES_CACHE"] = str(self.work / "cache")

    def test_models(self):
        mesh = kept_bumpy_torus()
        before = mesh.read_bytes()
        self.within(100, re.escape(f"cannot write {mesh}: File too large"), kept_bumpy_torus)
        self.assertEqual(mesh.read_bytes(), before)

    def test_folders(self):
        def fill(folder):
            return (folder / "file").write_bytes(ZEROS)

        thing = self.work / "cache/thing"
        self.assertTrue(publish_into(thing, fill))
        most = resource.getrlimit(resource.RLIMIT_FSIZE)[1]
        resource.setrlimit(resource.RLIMIT_FSIZE, (50 << 10, most))
        said = self.said_by(lambda: self.assertFalse(publish_into(thing, fill)))
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
        self.assertIn("File too large", said)
        self.assertEqual(((thing / "file").stat().st_size, os.listdir("cache")), (len(ZEROS), ["thing"]))
        path("new")
        called = []
        self.said_by(lambda: self.assertFalse(publish_into(self.work / "new/thing", called.append)))
        self.assertFalse(called, "a folder was filled that cannot be made")

    def test_half_a_configuration(self):
        os.mkdir("full")
        os.symlink("/dev/full", "full/apt.conf")
        with mock.patch.object(headers.subprocess, "run") as run, self.assertRaises(OSError):
            headers.source_apt_get(self.work / "full", "update")
        run.assert_not_called()


class Stage(ScriptTest):
    def test_programs(self):
        stage.write_program("old", "program")
        self.within(0, "cannot write program", stage.write_program, "new", "program")
        self.assertTrue(os.access("program", os.X_OK))
        self.assertEqual(pathlib.Path("program").read_text(), "#!/bin/sh\nold\n")

    def test_links(self):
        installed, ours = ([path(self.work / folder / f"{name}.so") for name in names] for folder,
                           names in (("installed", "ab"), ("ours", "bc")))
        links = self.work / "links"
        stage.link_all(links, installed + ours)
        path(links / "file")
        self.assertEqual([os.readlink(links / f"{name}.so") for name in "abc"], [str(installed[0]), *map(str, ours)])
        before = os.lstat(links / "a.so")
        stage.link_all(links, installed)
        after = os.lstat(links / "a.so")
        self.assertEqual((after.st_ino, after.st_ctime_ns), (before.st_ino, before.st_ctime_ns),
                         "a link that was right was made anew")
        self.assertEqual(os.readlink(links / "b.so"), str(installed[1]), "a link still leads to our plugin")
        self.assertEqual(sorted(os.listdir(links)), ["a.so", "b.so", "file"])


class ExtraPlugins(ScriptTest):
    """Of a MeshLab that loads users' plugins."""

    def make_plugins(self):
        return [path(self.work / "plugins" / name, os.urandom(size)) for name,
                size in (("liba.so", 50000), ("libb.so", 90000))]

    def install(self, version):
        with mock.patch("environment.packages.meshlab_version", return_value=version), mock.patch.object(extra_plugins,
                                                                                                         "refuse_installed_plugins"):
            self.said_by(extra_plugins.install_plugins, sorted((self.work / "plugins").iterdir()))
            return extra_plugins.extra_plugins_folder()

    def test_install(self):
        data = self.work / "data"
        os.environ["XDG_DATA_HOME"] = str(data)
        old = [file.read_bytes() for file in self.make_plugins()]
        folder = self.install("2022.02+x")
        self.assertEqual([file.read_bytes() for file in sorted(folder.iterdir())], old)
        new = [file.read_bytes() for file in self.make_plugins()]
        for kilobytes in (60, 0):  # enough for the first, and for none
            self.within(kilobytes, "cannot write .*: File too large", self.install, "2022.02+x")
            self.assertEqual([file.read_bytes() for file in sorted(folder.iterdir())], [new[0], old[1]])
        self.install("2022.02+x")
        self.assertEqual([file.read_bytes() for file in sorted(folder.iterdir())], new)
        self.install("2025.07+x")
        self.assertFalse((folder / "liba.so").exists(), "plugins of another version are left")
        self.said_by(extra_plugins.uninstall_plugins)
        self.assertFalse(list(data.iterdir()), "something is left")


unittest.main()
