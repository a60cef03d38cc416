# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab 2025.07 compiled in a root of the oldest release of Debian here, of the source that a newer one packages: a host
of the portable plugins that was built as its authors build theirs, on an old system."""

from environment import packages
from environment.build import processors
from environment.headers import unpack_source
from environment.releases import SUITES
from hosts.roots import ensure_root, run_with_network
from product import portable, pymeshlab


def install(root, kept):
    """As a package, since that is where all else here looks for MeshLab; with asserts, as Debian's. Of its fifty plugins
    those that open meshes, draw, and change meshes in the tests."""
    parts = ";".join(f"meshlabplugins/{name}" for name in ("io_base", "decorate_base", "render_gdp", "filter_meshing",
                                                            "filter_layer"))
    needed = [name for name in (*packages.BUILD, *packages.DISPLAY, *packages.TEST) if name != "meshlab"]
    source = root / "usr/src/meshlab"
    source.mkdir()
    return (unpack_source("meshlab", source, portable.SUITE, ["*"]) and
            run_with_network(root, kept, ["sh", "-exc", f"""
apt-get -qq update
DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install {' '.join(needed)}
cmake -S /usr/src/meshlab -B /tmp/build -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O1 \\
  -DMESHLAB_ALLOW_OPTIONAL_EXTERNAL_LIBRARIES=OFF '-DMESHLAB_PLUGINS={parts}'
cmake --build /tmp/build --parallel {processors()}
DESTDIR=/tmp/package cmake --install /tmp/build
mkdir /tmp/package/DEBIAN
cat >/tmp/package/DEBIAN/control <<END
Package: meshlab
Version: {pymeshlab.MESHLAB}
Architecture: $(dpkg --print-architecture)
Maintainer: Laplacian Lines
Description: MeshLab with few of its plugins
END
dpkg-deb --build /tmp/package /tmp/meshlab.deb
dpkg --install /tmp/meshlab.deb
rm -r /usr/src/meshlab
"""]))


def ensure_built_meshlab():
    return ensure_root(SUITES["2020"], "-meshlab", install)
