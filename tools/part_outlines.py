"""Random parts, about 10 mm wide, and their meshes by Gmsh, which is no package of this project (random_parts.py)."""

import math
import shutil
import subprocess
from dataclasses import dataclass, field

GMSH = shutil.which("gmsh")
ABSENT = "random_parts.py: Gmsh meshes its parts, and there is no program gmsh here: apt-get install gmsh"


@dataclass
class Part:
    """Vertices of the outline in turn, anticlockwise: x, y, the radius of the fillet there. Side k begins at vertex k, and
    the sides that are named are boundaries. Holes and an insert of another metal: x, y, radius. A chord from the middle of
    a side to that of another parts the body in two groups of elements."""

    vertices: list
    ends: tuple  # the two sides that a part of this kind is held and pulled at
    holes: list = field(default_factory=list)
    insert: tuple = None
    chord: tuple = None
    names: dict = field(default_factory=dict)  # of sides; "fillets" and "hole<k>" besides


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def filleted(before, at, behind, radius):
    """Where the arc begins, its middle, and where it ends."""
    u, v = ([x / math.dist(to, at) for x in minus(to, at)] for to in (before, behind))
    half = math.acos(max(-1.0, min(1.0, u[0] * v[0] + u[1] * v[1]))) / 2.0
    way, middle = radius / math.tan(half), radius / math.sin(half)
    both = [x + y for x, y in zip(u, v)]
    along = lambda direction, length: [x + length * d for x, d in zip(at, direction)]
    return along(u, way), along([x / math.hypot(*both) for x in both], middle), along(v, way)


def circle(x, y, radius, parts=32):
    return [[x + radius * math.cos(2 * math.pi * k / parts), y + radius * math.sin(2 * math.pi * k / parts)] for k in range(parts)]


def curves_of(part):
    """The outline as lines (a, b) and arcs (a, middle, b), each with the side that it is of, "fillets", or "chord" for the
    place where the chord begins or ends."""
    count, curves = len(part.vertices), []
    begins, ends = {}, {}
    for k, (x, y, radius) in enumerate(part.vertices):
        before, behind = part.vertices[k - 1][:2], part.vertices[(k + 1) % count][:2]
        arc = filleted(before, (x, y), behind, radius) if radius > 0.0 else ([x, y], None, [x, y])
        ends[(k - 1) % count], begins[k] = arc[0], arc[2]
        curves.append((arc, "fillets") if radius > 0.0 else None)
    outline = []
    for k in range(count):
        outline += [curves[k]] if curves[k] else []
        a, b = begins[k], ends[k]
        if part.chord and k in part.chord:
            middle = [(x + y) / 2.0 for x, y in zip(a, b)]
            outline += [((a, None, middle), k), (None, "chord"), ((middle, None, b), k)]
        else:
            outline.append(((a, None, b), k))
    return outline


def polygon_of(part):
    """The outline without its names, arcs as chords."""
    points = []
    for arc, name in curves_of(part):
        if name == "chord":
            continue
        a, middle, b = arc
        if middle is None:
            points.append(a)
            continue
        radius, first = math.dist(a, middle), math.atan2(*minus(a, middle)[::-1])
        turn = (math.atan2(*minus(b, middle)[::-1]) - first + math.pi) % (2 * math.pi) - math.pi
        points += [[middle[0] + radius * math.cos(first + turn * k / 8), middle[1] + radius * math.sin(first + turn * k / 8)] for k in range(8)]
    return points


def holds(polygon, at):
    inside = False
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
        if (y0 > at[1]) != (y1 > at[1]) and at[0] < x0 + (at[1] - y0) * (x1 - x0) / (y1 - y0):
            inside = not inside
    return inside


def distance_to(a, b, at):
    along, to = minus(b, a), minus(at, a)
    way = max(0.0, min(1.0, (along[0] * to[0] + along[1] * to[1]) / (along[0] ** 2 + along[1] ** 2)))
    return math.dist(at, [x + way * d for x, d in zip(a, along)])


def depth(part, at):
    """How far a place is from the outline and from holes; negative outside of the metal."""
    polygon = polygon_of(part)
    least = min(distance_to(a, b, at) for a, b in zip(polygon, polygon[1:] + polygon[:1]))
    least = least if holds(polygon, at) else -least
    return min([least] + [math.dist(at, hole[:2]) - hole[2] for hole in part.holes])


def halves_of(part):
    """The two polygons on either side of the chord, which are the groups "half0" and "half1"."""
    sides, now = [[], []], 0
    for arc, name in curves_of(part):
        if name == "chord":
            now = 1 - now
        else:
            sides[now].append(arc[0])
    return sides


def mouth_of(part, side, way, depth_outside=0.3):
    """A place on a side, one outside of it, and the direction into the metal."""
    arc = next(arc for arc, name in curves_of(part) if name == side)
    if part.chord and side in part.chord:
        way *= 0.8
    a, b = arc[0], arc[2]
    along = [x / math.dist(a, b) for x in minus(b, a)]
    inward = [-along[1], along[0]]
    at = [x + way * d for x, d in zip(a, minus(b, a))]
    return at, [x - depth_outside * d for x, d in zip(at, inward)], inward


def turned_part(part, angle):
    c, s = math.cos(angle), math.sin(angle)
    turn = lambda at: (c * at[0] - s * at[1], s * at[0] + c * at[1], *at[2:])
    part.vertices, part.holes = [turn(v) for v in part.vertices], [turn(hole) for hole in part.holes]
    part.insert = part.insert and turn(part.insert)
    return part


def geometry(part, size, at_crack, cracks, recombination):
    """The .geo text: small elements about the points of cracks."""
    lines, points, curves = [], {}, []

    def point(at):
        key = tuple(round(x, 12) for x in at)
        if key not in points:
            points[key] = len(points) + 1
            lines.append(f"Point({points[key]}) = {{{at[0]!r}, {at[1]!r}, 0}};")
        return points[key]

    def curve(a, middle, b, name):
        curves.append(name)
        ends = [point(a), point(middle), point(b)] if middle else [point(a), point(b)]
        lines.append(f"{'Circle' if middle else 'Line'}({len(curves)}) = {{{', '.join(map(str, ends))}}};")
        return len(curves)

    def round_loop(x, y, radius, name):
        corners = [[x + radius * c, y + radius * s] for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1))]
        return [curve(corners[k], [x, y], corners[(k + 1) % 4], name) for k in range(4)]

    loops, now, starts = [[], []], 0, []
    for arc, name in curves_of(part):
        if name == "chord":
            starts.append(len(loops[now]))
            now = 1 - now
        else:
            loops[now].append(curve(*arc, part.names.get(name)))
    if part.chord:
        middles = [arc[2] for (arc, _), (_, then) in zip(curves_of(part), curves_of(part)[1:]) if then == "chord"]
        chord = curve(middles[0], None, middles[1], None)
        loops = [loops[0][:starts[0]] + [chord] + loops[0][starts[0]:], loops[1] + [-chord]]
    inner = [(hole, round_loop(*hole, part.names.get(f"hole{k}"))) for k, hole in enumerate(part.holes)]
    inner += [(part.insert, round_loop(*part.insert, None))] if part.insert else []
    groups, halves = [], halves_of(part) if part.chord else [polygon_of(part)]
    for k, half in enumerate(halves):
        lines.append(f"Curve Loop({10 + k}) = {{{', '.join(map(str, loops[k]))}}};")
        within = [loop for hole, loop in inner if holds(half, hole[:2])]
        for j, loop in enumerate(within):
            lines.append(f"Curve Loop({100 * (k + 1) + j}) = {{{', '.join(map(str, loop))}}};")
        lines.append(f"Plane Surface({k + 1}) = {{{', '.join(map(str, [10 + k] + [100 * (k + 1) + j for j in range(len(within))]))}}};")
        groups.append((f"half{k}" if part.chord else "body", k + 1))
    if part.insert:
        lines += [f"Curve Loop(900) = {{{', '.join(map(str, inner[-1][1]))}}};", "Plane Surface(9) = {900};"]
        groups.append(("insert", 9))
    near = [point(at) for crack in cracks for at in crack]
    lines += ["Field[1] = Distance;", f"Field[1].PointsList = {{{', '.join(map(str, near))}}};", "Field[2] = MathEval;",
              f'Field[2].F = "{at_crack} + 0.2*F1";', "Field[3] = MathEval;", f'Field[3].F = "{size}";', "Field[4] = Min;",
              "Field[4].FieldsList = {2, 3};", "Background Field = 4;"]
    for name in sorted({name for name in curves if name}):
        lines.append(f'Physical Curve("{name}") = {{{", ".join(str(k + 1) for k, of in enumerate(curves) if of == name)}}};')
    lines += [f'Physical Surface("{name}") = {{{surface}}};' for name, surface in groups]
    lines += ["Mesh.MeshSizeExtendFromBoundary = 0;", "Mesh.MeshSizeFromPoints = 0;", "Mesh.Algorithm = 6;", "Mesh.RecombineAll = 1;",
              f"Mesh.RecombinationAlgorithm = {recombination};", "Mesh.MshFileVersion = 2.2;", ""]
    return "\n".join(lines)


def read(path):
    """Nodes, cells, edges (name, a, b) and the group of each cell, of a file in format 2.2."""
    sections, lines = {}, iter(path.read_text(encoding="utf-8").splitlines())
    for line in lines:
        if line.startswith("$") and not line.startswith("$End"):
            sections[line[1:]] = now = []
        elif not line.startswith("$"):
            now.append(line.split())
    names = {int(row[1]): " ".join(row[2:]).strip('"') for row in sections["PhysicalNames"][1:]}
    numbers = {row[0]: k for k, row in enumerate(sections["Nodes"][1:])}
    nodes = [(float(row[1]), float(row[2])) for row in sections["Nodes"][1:]]
    cells, edges, groups = [], [], []
    for row in sections["Elements"][1:]:
        of = [numbers[node] for node in row[3 + int(row[2]):]]
        if row[1] == "1":
            edges.append((names[int(row[3])], *of))
        elif row[1] in ("2", "3"):
            cells.append(of)
            groups.append(names[int(row[3])])
    return nodes, cells, edges, groups


def meshed(part, folder, **wishes):
    """The mesh, without nodes of no element; None where Gmsh makes none."""
    (folder / "part.geo").write_text(geometry(part, **wishes), encoding="utf-8")
    command = [GMSH, "-2", str(folder / "part.geo"), "-o", str(folder / "part.msh"), "-v", "1"]
    result = subprocess.run(command, capture_output=True, text=True, timeout=120)
    if result.returncode != 0 or not (folder / "part.msh").exists():
        return None
    nodes, cells, edges, groups = read(folder / "part.msh")
    used = sorted({node for cell in cells for node in cell})
    number = {old: new for new, old in enumerate(used)}
    if not all({*ends} <= number.keys() for _, *ends in edges):
        return None  # a curve that bounds no element
    new = lambda old: [number[node] for node in old]
    return [nodes[k] for k in used], [new(cell) for cell in cells], [(name, *new(ends)) for name, *ends in edges], groups


def halved(mesh):
    """Each triangle as three and each quadrilateral as four, split at its centre and the middles of its edges."""
    nodes, cells, edges, groups = mesh
    nodes, middles = list(nodes), {}

    def between(*ends):
        key = frozenset(ends)
        if key not in middles:
            middles[key] = len(nodes)
            nodes.append(tuple(sum(nodes[k][axis] for k in ends) / len(ends) for axis in (0, 1)))
        return middles[key]

    smaller, of = [], []
    for cell, group in zip(cells, groups):
        centre = between(*cell)
        for k, corner in enumerate(cell):
            smaller.append([corner, between(corner, cell[(k + 1) % len(cell)]), centre, between(cell[k - 1], corner)])
            of.append(group)
    return nodes, smaller, [half for name, a, b in edges for half in ((name, a, between(a, b)), (name, between(a, b), b))], of
