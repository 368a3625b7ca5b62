#!/usr/bin/python3
"""Prints the plan of the house as a table: what each folder holds and how its parts include one another.

A part of a top folder is a sub-folder or a loose room, a part of a sub-folder a room: x.hpp with x.cpp. A part stands
one floor above the highest that it includes. An arrow is a pair of parts of which one includes the other; it runs up where it closes a circle.
Names of classes as arguments add the number of their data members.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

from check_order import ROOT, includes_inside, room, sources, sub_folder

TOP_FOLDERS = ["common", "coupling", "coarse", "fine", "app"]


def plan(parts, arrows):
    """Floors, arrows and arrows up of parts, where an arrow is a pair (what includes, what is included)."""
    below = defaultdict(set)
    for start, end in arrows:
        below[start].add(end)
    floors, path, up = {}, [], 0

    def floor_of(part):
        nonlocal up
        if part not in floors:
            path.append(part)
            floors[part] = 1
            for other in sorted(below[part]):
                if other in path:
                    up += 1
                else:
                    floors[part] = max(floors[part], 1 + floor_of(other))
            path.pop()
        return floors[part]

    return max(map(floor_of, sorted(parts))), len(arrows), up


def part_of(path, top):
    folder = sub_folder(path)
    return room(path) if folder == "." else f"{top}/{folder}"


def rows():
    """Name, parts, floors, arrows, arrows up, sources and lines of the longest source, of every folder."""
    for top in TOP_FOLDERS:
        files = [file.relative_to(ROOT).as_posix() for file in sources(top)]
        includes = list(includes_inside(top))
        yield row(f"{top}/", files, {(part_of(a, top), part_of(b, top)) for a, b in includes}, lambda f: part_of(f, top))
        for folder in sorted({sub_folder(file) for file in files} - {"."}):
            inside = [file for file in files if sub_folder(file) == folder]
            yield row(f"{top}/{folder}/", inside, {(room(a), room(b)) for a, b in includes if {a, b} <= {*inside}}, room)


def row(name, files, arrows, part):
    parts = {part(file) for file in files}
    longest = max(len((ROOT / file).read_text(encoding="utf-8").splitlines()) for file in files)
    return name, len(parts), *plan(parts, {(a, b) for a, b in arrows if a != b}), len(files), longest


def data_members(name):
    """The data members of a class, which end in an underscore."""
    for top in TOP_FOLDERS:
        for file in sources(top):
            text = re.sub(r"//.*", "", file.read_text(encoding="utf-8"))
            if found := re.search(rf"^(?:class|struct) {name}\b[^;{{]*\{{(.*?)^\}};", text, re.M | re.S):
                declared = found[1]
                while declared != (declared := re.sub(r"\{[^{}]*\}|\([^()]*\)", "", declared)):
                    pass
                return len(re.findall(r"\b\w+_(?= = |[,;])", declared))
    raise SystemExit(f"no class {name}")


if __name__ == "__main__":
    print("| folder | parts | floors | arrows | up | sources | longest, lines |\n|---|---|---|---|---|---|---|")
    for cells in rows():
        print("| " + " | ".join(map(str, cells)) + " |")
    for name in sys.argv[1:]:
        print(f"\n{name}: {data_members(name)} data members", end="")
    print()
