"""Kinds of random parts, about 10 mm wide, with holes, an insert or a chord, and cracks in them (random_parts.py)."""

import math

from part_outlines import Part, depth, holds, mouth_of, polygon_of, turned_part

ROOM = 1.1  # mm that cracks leave about themselves


def plate(rng):
    high = rng.uniform(10.0, 22.0)
    return Part([(0, 0, 0), (10, 0, 0), (10, high, 0), (0, high, 0)], (0, 2))


def sheared(rng):
    """A quadrilateral without a right angle, two of its corners round."""
    shift = lambda: rng.uniform(-1.5, 1.5)
    corners = [(shift(), shift()), (10 + shift(), shift()), (10 + shift(), 13 + shift()), (shift(), 13 + shift())]
    return Part([(*at, rng.choice([0, rng.uniform(0.8, 2.0)])) for at in corners], (0, 2))


def angle(rng):
    arm, fillet = rng.uniform(3.6, 5.0), rng.choice([0, rng.uniform(0.8, 2.0)])
    return Part([(0, 0, 0), (10, 0, 0), (10, arm, 0), (arm, arm, fillet), (arm, 11, 0), (0, 11, 0)], (1, 4))


def tee(rng):
    half, foot, fillet = rng.uniform(1.8, 2.6), rng.uniform(3.2, 4.5), rng.choice([0, rng.uniform(0.6, 1.5)])
    return Part([(0, 0, 0), (12, 0, 0), (12, foot, 0), (6 + half, foot, fillet), (6 + half, 12, 0), (6 - half, 12, 0),
                 (6 - half, foot, fillet), (0, foot, 0)], (rng.choice([0, 1, 7]), 4))


def dog_bone(rng):
    waist, fillet = rng.uniform(1.5, 2.5), rng.uniform(1.0, 2.5)
    return Part([(0, 0, 0), (10, 0, 0), (10, 4, 0), (10 - waist, 7, fillet), (10 - waist, 13, fillet), (10, 16, 0), (10, 20, 0),
                 (0, 20, 0), (0, 16, 0), (waist, 13, fillet), (waist, 7, fillet), (0, 4, 0)], (0, 6))


def notched(rng):
    """A V, its root round or sharp, or with a flat bottom."""
    y, deep, wide = rng.uniform(6.0, 9.0), rng.uniform(1.5, 3.0), rng.uniform(0.5, 1.5)
    root = rng.choice([[(deep, y, rng.choice([0, 0.3]))], [(deep, y + wide / 2, 0.2), (deep, y - wide / 2, 0.2)]])
    return Part([(0, 0, 0), (10, 0, 0), (10, 15, 0), (0, 15, 0), (0, y + wide, 0), *root, (0, y - wide, 0)], (0, 2))


def lug(rng):
    length, hole = rng.uniform(12.0, 17.0), rng.uniform(1.8, 2.8)
    return Part([(0, 0, 0), (10, 0, 0), (10, length, 4.99), (0, length, 4.99)], (0, 1), [(5, length - 5, hole)])


def ring(rng):
    corner, hole = rng.uniform(4.0, 5.4), rng.uniform(1.5, 2.8)
    return Part([(0, 0, corner), (11, 0, corner), (11, 11, corner), (0, 11, corner)], (0, 2), [(5.5, 5.5, hole)])


def polygon(rng):
    count = rng.randint(5, 8)
    angles = [2 * math.pi * (k + rng.uniform(-0.25, 0.25)) / count for k in range(count)]
    far = [rng.uniform(5.0, 8.0) for _ in angles]
    return Part([(r * math.cos(t), r * math.sin(t), rng.choice([0, 0, rng.uniform(0.3, 0.8)])) for t, r in zip(angles, far)], (0, count // 2))


KINDS = [plate, plate, sheared, angle, tee, dog_bone, notched, lug, ring, polygon]


def with_holes(part, rng):
    polygon = polygon_of(part)
    for _ in range(60 if len(part.holes) == 0 and rng.random() < 0.6 else 0):
        at = tuple(rng.uniform(min(p[axis] for p in polygon), max(p[axis] for p in polygon)) for axis in (0, 1))
        radius = rng.uniform(0.7, 1.8)
        if len(part.holes) < 4 and depth(part, at) > radius + 1.3 and rng.random() < 0.5:
            part.holes.append((*at, radius))
    if part.holes and len(part.vertices) < 9 and rng.random() < 0.3:
        part.insert = part.holes.pop()
    return part


def clear(part, a, b, gap=0.15):
    """Whether a way from a to b stays in the metal."""
    ways = [k / 20.0 for k in range(21)]
    return all(depth(part, [x + w * (y - x) for x, y in zip(a, b)]) > gap for w in ways)


def with_chord(part, rng):
    """The chord begins at the lower of its sides, where the outline begins its first group."""
    sides = range(len(part.vertices))
    pairs = [(i, j) for i in sides for j in sides if i + 1 < j and (i, j) != (0, len(sides) - 1)]
    i, j = rng.choice(pairs)
    middles = [mouth_of(part, side, 0.5)[0] for side in (i, j)]
    inner = [[x + w * (y - x) for x, y in zip(*middles)] for w in (0.1, 0.9)]
    hits = part.insert and any(math.dist(part.insert[:2], [x + k / 20 * (y - x) for x, y in zip(*middles)]) < part.insert[2] + 0.4 for k in range(21))
    if clear(part, *inner) and not hits:
        part.chord = (i, j)
    return part


def part_of(rng):
    part = with_holes(rng.choice(KINDS)(rng), rng)
    if rng.random() < 0.3 and not part.insert:
        part = with_chord(part, rng)
    part = turned_part(part, rng.choice([0.0, rng.uniform(-3.0, 3.0)]))
    part.names = {side: f"side{side}" for side in range(len(part.vertices)) if side in part.ends or rng.random() < 0.7}
    part.names.update({f"hole{k}": f"hole{k}" for k in range(len(part.holes))})
    if any(v[2] > 0.0 for v in part.vertices) and rng.random() < 0.5:
        part.names["fillets"] = "fillets"
    return part


def step(at, direction, turn, length):
    c, s = math.cos(turn), math.sin(turn)
    return [at[0] + length * (c * direction[0] - s * direction[1]), at[1] + length * (s * direction[0] + c * direction[1])]


def crack_of(part, rng):
    """Its points, or None where there is no room."""
    kind = rng.choice(["side", "side", "inner", "corner"] + ["hole"] * (2 if part.holes else 0))
    turn = rng.uniform(-0.5, 0.5)
    if kind == "side":
        side = rng.randrange(len(part.vertices))
        start, outside, inward = mouth_of(part, side, rng.uniform(0.2, 0.8), rng.choice([0.0, 0.3]))
    elif kind == "corner":  # a fillet, or the root of a notch
        *at, radius = rng.choice(part.vertices)
        inward = min(([math.cos(t), math.sin(t)] for t in (0.1 * k for k in range(63))), key=lambda d: -depth(part, step(at, d, 0.0, 2.0)))
        start, outside, turn = at, step(at, inward, 0.0, -0.3), 0.2 * turn
    elif kind == "hole":
        x, y, radius = rng.choice(part.holes)
        way = rng.uniform(-3.1, 3.1)
        inward = [math.cos(way), math.sin(way)]
        start, outside = step([x, y], inward, 0.0, radius), step([x, y], inward, 0.0, 0.7 * radius)
    else:
        polygon = polygon_of(part)
        start = [rng.uniform(min(p[axis] for p in polygon), max(p[axis] for p in polygon)) for axis in (0, 1)]
        outside, inward = start, [1.0, 0.0]
        turn = rng.uniform(-3.0, 3.0)
    length = rng.uniform(2.2, 3.6) if kind == "inner" else rng.uniform(1.0, 3.5)
    points = [list(outside), step(start, inward, turn, length)]
    if rng.random() < 0.25:
        points.append(step(points[-1], inward, turn + rng.uniform(-0.5, 0.5), rng.uniform(0.8, 1.5)))
    ahead = [step(start, inward, turn, 0.3)] + points[1:]
    inside = all(clear(part, a, b, 0.05) for a, b in zip(ahead, ahead[1:]))
    tips = [points[-1]] + ([points[0]] if kind == "inner" else [])
    inside = inside and (kind == "inner" or depth(part, outside) < 0.0 or outside == start)
    return points if inside and all(depth(part, tip) > ROOM for tip in tips) else None


def apart(one, other):
    along = lambda points: [[x + k / 10 * (y - x) for x, y in zip(a, b)] for a, b in zip(points, points[1:]) for k in range(11)]
    return min(math.dist(p, q) for p in along(one) for q in along(other))


def cracks_of(part, rng):
    wanted, cracks = rng.choice([1, 1, 2, 2, 3]), []
    for _ in range(200):
        points = crack_of(part, rng) if len(cracks) < wanted else None
        if points and all(apart(points, other) > 1.6 for other in cracks):
            cracks.append(points)
    return cracks


def group_at(part, at, halves):
    """The name of the group of elements there, up to a chord or circle of edges."""
    if part.insert and math.dist(at, part.insert[:2]) < part.insert[2]:
        return "insert"
    return ("half0" if holds(halves[0], at) else "half1") if part.chord else "body"
