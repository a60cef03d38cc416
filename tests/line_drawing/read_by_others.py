# SPDX-License-Identifier: GPL-3.0-or-later
"""What programs of others make of drawings: read_by_others.py FOLDER. There lie drawings of a cube of 100 mm from the
front, the left and the top, plain and without furniture, cube_SCALE.svg and .dxf; cut.dxf, a plate of it with a
section; torus.svg, one with many lines; perhaps scan.svg, another. Ends with an error at the first thing that is not as
it should be."""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree

import ezdxf
import ezdxf.bbox
import numpy
import scipy.spatial
import svgpathtools
import vpype

STEP = 0.05  # mm between the places of lines that are looked at
SVG = "{http://www.w3.org/2000/svg}"


def check(holds, *words):
    if not holds:
        sys.exit("FAILED: " + " ".join(map(str, words)))


def near(value, expected, tolerance):
    return abs(value - expected) <= tolerance


def paths_of_views(file):
    """By the ids of views, then of layers: lists of svgpathtools' paths, mm."""
    root = ElementTree.parse(file).getroot()
    check(root.get("width") == root.get("viewBox").split()[2] + "mm", file, "is not in millimetres")
    return {
        view.get("id"): {
            layer.get("id"): [svgpathtools.parse_path(p.get("d")) for p in layer.iter(SVG + "path")]
            for layer in view.findall(SVG + "g")
        }
        for view in root.findall(SVG + "g")
    }


def box_of(layers):
    boxes = numpy.array([p.bbox() for paths in layers.values() for p in paths])
    return boxes[:, 0].min(), boxes[:, 1].max(), boxes[:, 2].min(), boxes[:, 3].max()


def check_svg_of_cube(file, size):
    boxes = {view: box_of(layers) for view, layers in paths_of_views(file).items()}
    check(sorted(boxes) == ["front", "left", "top"], file, "has views", *boxes)
    for view, (left, right, top, bottom) in boxes.items():
        check(near(right - left, size, 0.1), view, "is", right - left, "wide, not", size)
        check(near(bottom - top, size, 0.1), view, "is", bottom - top, "high, not", size)
    check(near(boxes["left"][2], boxes["front"][2], 0.05), "the left view is not at the height of the front view")
    check(near(boxes["top"][0], boxes["front"][0], 0.05), "the top view is not below the front view")


def check_layers(file, size):
    """As plotters get them."""
    millimetre = vpype.convert_length("1mm")
    drawing = vpype.read_multilayer_svg(str(file), 0.01 * millimetre)
    names = {layer.metadata.get("vp_name") for layer in drawing.layers.values()}
    check(names == {"Front", "Left", "Top"}, "vpype finds the layers", names)
    for layer in drawing.layers.values():
        length = layer.length() / millimetre
        check(near(length, 4 * size, 0.5), "vpype finds lines of", length, "mm, not", 4 * size)


def check_dxf_of_cube(file, size):
    document = ezdxf.readfile(file)
    auditor = document.audit()
    check(not auditor.errors, file, *(error.message for error in auditor.errors))
    check(document.header.get("$INSUNITS") == 4, file, "is not in millimetres")
    for view in ("FRONT", "LEFT", "TOP"):
        outlines = list(document.modelspace().query(f'POLYLINE[layer=="{view}_OUTLINE"]'))
        check(len(outlines) == 1, file, "has", len(outlines), "outlines of", view)
        extents = ezdxf.bbox.extents(outlines)
        check(near(extents.size.x, size, 0.1) and near(extents.size.y, size, 0.1), "an outline measures", extents.size)
    extents = ezdxf.bbox.extents(document.modelspace())
    paper = document.header["$EXTMAX"]
    check(extents.extmin.x > 0 and extents.extmin.y > 0, "lines begin beside the paper")
    check(extents.extmax.x < paper[0] and extents.extmax.y < paper[1], "lines end beside the paper")


def check_layers_of_dxf(file):
    """Those of views are called after them, and a class has the same color in all, but no other's."""
    document = ezdxf.readfile(file)
    used = {entity.dxf.layer for entity in document.modelspace()}
    expected = {"FRONT_OUTLINE", "TOP_OUTLINE", "FRONT_MARKS", "VIEW-3_SECTION", "VIEW-3_FINE", "NAMES", "SCALE",
                "TITLE"}
    check(expected <= used, file, "has the layers", *sorted(used))
    colors = {}
    for name in used:
        colors.setdefault(name.split("_")[-1], set()).add(document.layers.get(name).color)
    check(all(len(found) == 1 for found in colors.values()), file, "has a class in several colors:", colors)
    check(len(set.union(*colors.values())) == len(colors), file, "has classes of equal colors:", colors)


def places_along(path):
    """Places every STEP along a path, and the way there."""
    places = []
    for segment in path:
        count = max(1, int(numpy.ceil(segment.length(error=1e-3) / STEP)))
        places += [segment.point(t) for t in numpy.arange(count) / count]
    places.append(path.point(1))
    places = numpy.array(places)
    return places, numpy.gradient(places)


def longest_overlap(paths):
    """The length that two paths have in common, within a hundredth of a millimetre and two degrees."""
    places, ways, owners = [], [], []
    for number, path in enumerate(paths):
        along, way = places_along(path)
        places.append(along)
        ways.append(way / numpy.maximum(abs(way), 1e-12))
        owners.append(numpy.full(len(along), number))
    places, ways, owners = map(numpy.concatenate, (places, ways, owners))
    tree = scipy.spatial.cKDTree(numpy.column_stack([places.real, places.imag]))
    first, second = tree.query_pairs(0.01 + STEP / 2, output_type="ndarray").T
    between = places[second] - places[first]
    across = abs((between * ways[first].conj()).imag)
    along = abs((ways[first] * ways[second].conj()).real)
    shared = (owners[first] != owners[second]) & (across < 0.01) & (along > 0.9994)
    pairs = {}
    for a, b, place in zip(owners[first][shared], owners[second][shared], first[shared]):
        pairs.setdefault((a, b), set()).add(place)
    return max((STEP * (len(common) - 1) for common in pairs.values()), default=0)


def check_measures():
    """That what is measured here is found where it is."""
    line, along, across = map(svgpathtools.parse_path, ("M0 0L10 0", "M9 .005C9.5 .005 19 .005 20 .005", "M5 -3L5 0"))
    check(near(longest_overlap([line, along, across]), 1, 0.1), "an overlap of 1 mm is not found")
    check(longest_overlap([line, across]) == 0, "a crossing is an overlap")
    check(loose_ends([line, across]) == 3, "loose ends are not counted")


def loose_ends(paths):
    """Ends that are not within .1 mm of another path, or of another end."""
    places = [places_along(path)[0] for path in paths]
    count = 0
    for number, path in enumerate(paths):
        if path.point(0) == path.point(1):
            continue
        for end in (path.point(0), path.point(1)):
            count += not any(
                abs(other - end).min() < 0.1 for k, other in enumerate(places) if k != number
            )
    return count


def check_lines(file):
    for view, layers in paths_of_views(file).items():
        paths = [p for layer in layers.values() for p in layer]
        overlap = longest_overlap(paths)
        outlines = layers[view + "-outline"]
        print(
            f"{view}: {len(paths)} paths, the longest overlap {overlap:.2f} mm, "
            f"loose ends {loose_ends(paths)}, of outlines {loose_ends(outlines)} of {2 * len(outlines)}"
        )
        check(overlap <= 0.1, "two paths overlap by", overlap, "mm")


def main():
    folder = pathlib.Path(sys.argv[1])
    check_measures()
    for scale, size in (("1:1", 100), ("1:2", 50)):
        check_svg_of_cube(folder / f"cube_{scale}.svg", size)
        check_layers(folder / f"cube_{scale}.svg", size)
        check_dxf_of_cube(folder / f"cube_{scale}.dxf", size)
    check_layers_of_dxf(folder / "cut.dxf")
    check_lines(folder / "torus.svg")
    if (folder / "scan.svg").exists():
        check_lines(folder / "scan.svg")


main()
