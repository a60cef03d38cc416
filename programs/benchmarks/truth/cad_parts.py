# SPDX-License-Identifier: GPL-3.0-or-later
"""CAD parts of some 100 mm, of our own design, for which exact hidden lines are to be had. A part is a function that gives
a shape; one of several bodies gives two: what is tessellated, and their union, which has the same surface and the edges
where they meet. Where bodies are flush, the union has none, and a drawing may have a line or not."""

import math

import cadquery as cq

PARTS = {}


def part(function):
    PARTS[function.__name__] = function
    return function


def around(count, radius):
    """Places on a circle."""
    return [
        (radius * math.cos(2 * math.pi * i / count), radius * math.sin(2 * math.pi * i / count))
        for i in range(count)
    ]


def turned(profile):
    """Of (radius, height), around z."""
    return cq.Workplane("XZ").polyline(profile).close().revolve(360, (0, 0), (0, 1))


def compound(*solids):
    return cq.Compound.makeCompound([shape for solid in solids for shape in solid.vals()])


# Plates and blocks


@part
def drilled_plate():
    plate = cq.Workplane().box(100, 70, 8)
    for diameter, places in {
        2: [(-42, 28), (-36, 28), (-30, 28)],
        4: [(-40, 14), (-28, 14)],
        8: [(-38, -4), (-20, -4)],
        16: [(-32, -24), (8, 22)],
        30: [(26, -8)],
    }.items():
        plate = plate.faces(">Z").workplane(origin=(0, 0, 4)).pushPoints(places).hole(diameter)
    return plate


@part
def blind_holes():
    block = cq.Workplane().box(80, 60, 24)
    for x, diameter, depth in [(-30, 4, 10), (-18, 7, 4), (0, 14, 16), (24, 20, 6)]:
        block = block.faces(">Z").workplane(origin=(x, 8, 12)).hole(diameter, depth)
    block = block.faces(">Z").workplane(origin=(-12, -16, 12)).cskHole(6, 12, 90, 14)
    return block.faces(">Z").workplane(origin=(18, -18, 12)).cboreHole(6, 12, 5)


@part
def pockets():
    block = cq.Workplane().box(90, 60, 20)
    block = block.faces(">Z").workplane(origin=(-22, 0, 10)).rect(34, 44).cutBlind(-14)
    deep = cq.Workplane(origin=(24, 12, -2)).box(30, 24, 12, (True, True, False)).edges("|Z").fillet(6)
    block = block.cut(deep)
    slot = cq.Workplane(origin=(24, -16, 5)).slot2D(34, 10).extrude(10)
    return block.cut(slot)


@part
def bosses():
    plate = cq.Workplane().box(90, 64, 6)
    top = plate.faces(">Z").workplane(origin=(0, 0, 3))
    plate = top.pushPoints([(-30, 18), (30, 18), (-30, -18)]).circle(9).extrude(14)
    plate = plate.faces("<Z").workplane(origin=(0, 0, 17)).pushPoints([(-30, 18), (30, 18)]).hole(6)
    plate = plate.union(cq.Workplane(origin=(30, -18, 3)).polygon(6, 20).extrude(10))
    return plate.union(cq.Workplane(origin=(0, 0, 3)).rect(12, 40).extrude(20, taper=6))


@part
def stepped_block():
    profile = [(0, 0), (80, 0), (80, 12), (60, 12), (60, 26), (36, 26), (36, 44), (10, 54), (0, 54)]
    block = cq.Workplane("XZ").polyline(profile).close().extrude(50)
    block = block.cut(cq.Workplane(origin=(48, -25, 0)).circle(7).extrude(60))
    return block.cut(cq.Workplane("XZ", origin=(18, 0, 20)).rect(16, 10).extrude(50))


@part
def countersunk_plate():
    plate = cq.Workplane().box(90, 60, 7).edges("|Z").fillet(9)
    corners = plate.faces(">Z").workplane(origin=(0, 0, 3.5)).rect(66, 36, forConstruction=True).vertices()
    plate = corners.cskHole(5, 10, 90)
    plate = plate.faces(">Z").workplane(origin=(0, 0, 3.5)).hole(26)
    plate = plate.edges(cq.selectors.RadiusNthSelector(-1)).edges(">Z").chamfer(0.6)
    return plate.faces("<Z").edges("%CIRCLE").edges(cq.selectors.RadiusNthSelector(-1)).chamfer(0.4)


# Shells


@part
def shell_with_windows():
    box = cq.Workplane().box(80, 60, 50).edges("|Z").fillet(8).faces(">Z").shell(-2.5)
    box = box.cut(cq.Workplane("XZ", origin=(0, 50, 0)).rarray(18, 18, 3, 2).rect(10, 12).extrude(100))
    return box.cut(cq.Workplane("YZ", origin=(-60, 0, 2)).circle(12).extrude(60))


@part
def lid():
    lid = cq.Workplane().box(80, 60, 16).edges("|Z").fillet(10).faces(">Z").edges().fillet(3)
    lid = lid.faces("<Z").shell(-2)
    slots = cq.Workplane(origin=(0, 0, -10)).rarray(9, 1, 6, 1).slot2D(30, 4, 90).extrude(40)
    return lid.cut(slots)


@part
def round_box():
    box = turned([(0, 0), (34, 0), (38, 40), (35, 40), (31.5, 3), (0, 3)])
    holes = cq.Workplane("XZ", origin=(0, 60, 22)).circle(6).extrude(120)
    return box.cut(holes)


@part
def snap_box():
    box = cq.Workplane().box(70, 46, 24).edges("|Z").fillet(4).faces(">Z").shell(-1.2)
    for x in (-20, 20):
        profile = [(23, 3), (23, 11), (23.4, 11), (24.6, 6), (23.4, 5)]
        hook = cq.Workplane("YZ", origin=(x - 4, 0, 0)).polyline(profile).close().extrude(8)
        box = box.union(hook).union(hook.mirror("XZ"))
    slots = cq.Workplane("XZ", origin=(0, 30, -4)).rarray(40, 1, 2, 1).rect(10, 5).extrude(60)
    return box.cut(slots)


# Fine and periodic


@part
def knob():
    knob = cq.Workplane().circle(30).extrude(28).faces(">Z").edges().chamfer(4)
    knob = knob.cut(cq.Workplane(origin=(0, 0, -1)).pushPoints(around(48, 30.6)).circle(1.2).extrude(40))
    knob = knob.faces(">Z").workplane(origin=(0, 0, 28)).hole(16, 6)
    return knob.faces("<Z").workplane(origin=(0, 0, 0)).hole(8, 12)


def toothed(teeth, outer, root, tip):
    """An outline, with half of a tip's width in teeth."""
    outline = []
    for tooth in range(teeth):
        for share, radius in [(-0.3, root), (-tip, outer), (tip, outer), (0.3, root)]:
            angle = (tooth + share) * (2 * math.pi / teeth)
            outline.append((radius * math.cos(angle), radius * math.sin(angle)))
    return cq.Workplane().polyline(outline).close()


@part
def gear():
    gear = toothed(24, 40, 33, 0.13).extrude(12)
    gear = gear.faces(">Z").workplane(origin=(0, 0, 12)).hole(16)
    gear = gear.cut(cq.Workplane(origin=(8, 0, 0)).rect(4, 5).extrude(12))
    return gear.faces(">Z").workplane(origin=(0, 0, 12)).pushPoints(around(5, 21)).hole(10)


@part
def helical_gear():
    gear = toothed(17, 36, 29, 0.12).twistExtrude(18, 20)
    return gear.cut(cq.Workplane(origin=(0, 0, -1)).circle(9).extrude(30))


@part
def spring():
    helix = cq.Wire.makeHelix(14, 28, 20)
    return cq.Workplane("XZ").center(20, 0).circle(4).sweep(cq.Workplane(helix), isFrenet=True)


@part
def ringed_bolt():
    """Rings in place of a thread, under a hexagon head."""
    profile = [(0, 0), (9, 0), (10, 1)]
    for ring in range(14):
        z = 1 + 3 * ring
        profile += [(10, z + 0.4), (8.4, z + 1.5), (8.4, z + 1.9), (10, z + 3)]
    profile += [(10, 60), (0, 60)]
    head = cq.Workplane(origin=(0, 0, 60)).polygon(6, 34).extrude(12)
    cap = turned([(0, 60), (19, 60), (19, 67), (13, 72), (0, 72)])
    return turned(profile).union(head.intersect(cap))


@part
def heat_sink():
    base = cq.Workplane().box(80, 60, 8)
    fins = cq.Workplane(origin=(0, 0, 4)).rarray(6, 1, 13, 1).rect(1.2, 60).extrude(30)
    return base.union(fins)


# Slanted


@part
def wedges():
    """Roofs whose sides rise by 5 to 30 degrees."""
    block = cq.Workplane().box(90, 60, 10)
    for i, angle in enumerate([5, 10, 15, 20, 25, 30]):
        height = 7 * math.tan(math.radians(angle))
        x = -37.5 + 15 * i
        roof = [(x - 7, 5), (x, 5 + height), (x + 7, 5)]
        block = block.union(cq.Workplane("XZ", origin=(0, 25, 0)).polyline(roof).close().extrude(50))
    return block


@part
def low_pyramid():
    base = cq.Workplane().rect(90, 60).extrude(8)
    top = cq.Workplane(origin=(0, 0, 8)).rect(90, 60).workplane(offset=7).rect(50, 20).loft()
    return base.union(top)


@part
def chamfers():
    block = cq.Workplane().box(80, 60, 30).edges("|Z").chamfer(10)
    block = block.faces(">Z").edges().chamfer(2, 5)
    block = block.faces(">Z").workplane(origin=(-15, 0, 15)).hole(24)
    block = block.faces(">Z").workplane(origin=(24, 0, 15)).hole(12, 12)
    return block.edges(cq.selectors.RadiusNthSelector(-1)).edges(">Z").chamfer(3)


@part
def fillets():
    block = cq.Workplane().box(80, 60, 20).edges("|Z").fillet(12)
    block = block.union(cq.Workplane(origin=(0, 0, 10)).rect(40, 26).extrude(22))
    block = block.edges(cq.selectors.BoxSelector((-21, -14, 9.9), (21, 14, 10.1))).fillet(5)
    return block.faces(">Z").edges().fillet(3)


# Turned


@part
def grooved_shaft():
    profile = [(0, 0), (8, 0), (9, 1), (9, 18), (7.5, 18), (7.5, 20), (9, 20), (14, 20), (14, 45), (12.8, 45)]
    profile += [(12.8, 46.2), (14, 46.2), (14, 60), (20, 60), (20, 66), (19, 66), (19, 67), (20, 67), (20, 74)]
    profile += [(11, 74), (11, 98), (9, 100), (0, 100)]
    return turned(profile).cut(cq.Workplane("XZ", origin=(0, -8, 86)).slot2D(16, 5, 90).extrude(10))


@part
def stepped_shaft():
    """With grooves for rings, a keyway and small chamfers."""
    profile = [(0, 0), (5.5, 0), (6, 0.5), (6, 9), (5.5, 9), (5.5, 10.1), (6, 10.1), (6, 16), (8, 16), (8.3, 16.3)]
    profile += [(8.3, 38), (12, 38), (12.5, 38.5), (12.5, 43.5), (12, 44), (10, 44), (10, 70), (9.4, 70)]
    profile += [(9.4, 71.3), (10, 71.3), (10, 79.4), (9.4, 80), (0, 80)]
    shaft = turned(profile)
    shaft = shaft.cut(cq.Workplane("XZ", origin=(0, -6.5, 57)).slot2D(20, 6, 90).extrude(10))
    return shaft.cut(cq.Workplane("XY", origin=(0, 7, 27)).box(4, 6, 16))


@part
def pulley():
    profile = [(8, 0), (40, 0), (40, 3), (32, 9), (32, 11), (40, 17), (40, 20), (34, 20), (30, 14), (16, 14), (16, 26), (8, 26)]
    return turned(profile).cut(cq.Workplane().pushPoints(around(6, 23)).circle(5).extrude(30))


@part
def bottle():
    s = 7 * math.sqrt(0.5)
    path = cq.Workplane("XZ").moveTo(0, 0).lineTo(22, 0).threePointArc((22 + s, 7 - s), (29, 7))
    path = path.spline([(27, 40), (14, 66), (10, 78)], tangents=[(0, 1), (0, 1)], includeCurrent=True)
    path = path.lineTo(10, 90).lineTo(13, 90).lineTo(13, 96).lineTo(0, 96).close()
    return path.revolve(360, (0, 0), (0, 1))


# Blends


@part
def duct():
    """From a square to a circle."""
    duct = cq.Workplane().rect(50, 50).workplane(offset=50).circle(18).loft()
    base = cq.Workplane(origin=(0, 0, -6)).rect(70, 70).extrude(6)
    neck = cq.Workplane(origin=(0, 0, 50)).circle(18).extrude(14)
    return duct.union(base).union(neck).faces(">Z").workplane(origin=(0, 0, 64)).hole(28, 20)


@part
def lofted_wheel():
    rim = turned([(40, -7), (46, -9), (46, 9), (40, 7)])
    hub = turned([(6, -12), (12, -12), (12, 12), (6, 12)])
    wheel = rim.union(hub)
    spoke = (
        cq.Workplane("YZ", origin=(9, 0, 0)).ellipse(4, 9).workplane(offset=33.5).ellipse(2.4, 5).loft()
    )
    for i in range(5):
        wheel = wheel.union(spoke.rotate((0, 0, 0), (0, 0, 1), 72 * i))
    return wheel


@part
def elbow():
    bend = cq.Workplane(origin=(0, 0, 0)).circle(12).revolve(90, (30, 1), (30, 0))
    start = cq.Workplane(origin=(0, 0, 0)).circle(12).extrude(20)
    flange = cq.Workplane(origin=(0, 0, 20)).circle(24).extrude(3)
    flange = flange.cut(cq.Workplane(origin=(0, 0, 19)).pushPoints(around(6, 18)).circle(2.5).extrude(6))
    pipe = bend.union(start).union(flange)
    return pipe.cut(cq.Workplane().circle(9).extrude(30))


# Thin


@part
def thin_blades():
    fan = turned([(0, 0), (14, 0), (14, 16), (10, 20), (0, 20)])
    blade = cq.Workplane("YZ", origin=(12, 0, 10)).transformed((0, 0, 35)).rect(0.8, 22).extrude(34)
    for i in range(7):
        fan = fan.union(blade.rotate((0, 0, 0), (0, 0, 1), 360 / 7 * i))
    return fan


@part
def thin_flange():
    flange = cq.Workplane().circle(45).extrude(1.5)
    flange = flange.union(cq.Workplane().circle(18).extrude(30))
    flange = flange.cut(cq.Workplane().circle(15).extrude(30))
    flange = flange.cut(cq.Workplane().pushPoints(around(8, 36)).circle(4).extrude(5))
    return flange.cut(cq.Workplane().pushPoints(around(16, 26)).circle(1).extrude(5))


@part
def bracket():
    profile = [(0, 0), (60, 0), (60, 5), (5, 5), (5, 50), (0, 50)]
    angle = cq.Workplane("XZ").polyline(profile).close().extrude(50)
    for y in (-12, -38):
        rib = cq.Workplane("XZ", origin=(0, y + 1.5, 0)).polyline([(5, 5), (45, 5), (5, 40)]).close()
        angle = angle.union(rib.extrude(3))
    angle = angle.cut(cq.Workplane(origin=(40, -25, 0)).circle(6).extrude(10))
    return angle.cut(cq.Workplane("YZ", origin=(0, -25, 32)).rarray(26, 1, 1, 1).circle(7).extrude(10))


# Assemblies


@part
def stacked_boxes():
    """Bodies that touch: flush, on top, and a pin in its hole."""
    base = cq.Workplane().box(60, 40, 12)
    base = base.cut(cq.Workplane(origin=(18, 0, -6)).circle(6).extrude(12))
    flush = cq.Workplane(origin=(42.5, 0, 0)).box(25, 40, 12)
    above = cq.Workplane(origin=(-12, 0, 14)).box(24, 40, 16)
    pin = cq.Workplane(origin=(18, 0, -6)).circle(6).extrude(30)
    return compound(base, flush, above, pin), base.union(flush).union(above).union(pin)


@part
def crossing_bodies():
    """Bodies that run through each other."""
    bar = cq.Workplane().box(90, 18, 14)
    rod = cq.Workplane("XZ", origin=(-18, 35, 2)).circle(11).extrude(70)
    post = cq.Workplane(origin=(22, 3, -30)).polygon(6, 22).extrude(64)
    cone = cq.Workplane().add(cq.Solid.makeCone(16, 4, 44, cq.Vector(0, 0, -12), cq.Vector(0.3, 0, 1)))
    return compound(bar, rod, post, cone), bar.union(rod).union(post).union(cone)


@part
def ball_on_plate():
    """A ball, a ring and a slab that cut into each other."""
    slab = cq.Workplane().box(80, 60, 6)
    ball = cq.Workplane(origin=(-14, 0, 12)).sphere(17)
    ring = cq.Workplane().add(cq.Solid.makeTorus(16, 5, cq.Vector(18, 0, 5), cq.Vector(0.4, 0, 1)))
    return compound(slab, ball, ring), slab.union(ball).union(ring)
