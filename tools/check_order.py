#!/usr/bin/python3
"""Checks the order inside the top folders: rooms and folders include one another one way, and none grows too large.

A room is x.hpp with x.cpp. No circle of rooms, none of folders; a sub-folder includes only what stands before it in ORDER.
A folder inside a sub-folder stands above it or below it: it includes the sub-folder, or the sub-folder includes it.
"""

import re
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LINES = 300
FILES = 20

# Folders in which rooms include one another one way, and folders without a source or a sub-folder that is too large.
ROOMS_ONE_WAY = ["app", "coarse", "fine", "coupling", "common"]
SMALL = ["app", "coarse", "fine", "coupling", "common"]

# Sub-folders from the ground up: each includes only those left of it. "." holds the loose files.
ORDER = {
    "common": [
        ".", "geometry", "io", "schema", "case", "linear", "material", "fem", "crack", "enrichment", "integration", "fracture",
        "substructure",
    ],
    "coupling": [".", "transport", "ranks"],
    "coarse": [
        "load", "mesh_file", "specimen", "enrichment", "model", "elements", "structure", "fracture", "equilibrium", "zone", "advice", "cycle", "growth", "analysis", "fields", "results",
    ],
    "fine": ["material", "growth", "bulk", "contact", "zone"],
    "app": ["process", "results", "run", "charts", "report", "study", "material", "."],
}

# Folders whose sources all live in a sub-folder.
WITHOUT_LOOSE_FILES = ["coarse", "fine"]

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def sources(top):
    return sorted((ROOT / top).rglob("*.[hc]pp"))


def room(path):
    return path.removesuffix(".hpp").removesuffix(".cpp")


def sub_folder(path):
    parts = path.split("/")
    return parts[1] if len(parts) > 2 else "."


def includes_inside(top):
    """Pairs (file, file it includes), both inside the top folder."""
    for file in sources(top):
        for header in INCLUDE.findall(file.read_text(encoding="utf-8")):
            if header.startswith(top + "/"):
                yield file.relative_to(ROOT).as_posix(), header


def circles(arrows):
    """The strongly connected sets of more than one node, by Tarjan's method."""
    below = {}
    for start, end in arrows:
        below.setdefault(start, set()).add(end)
        below.setdefault(end, set())
    index, lowest, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = lowest[node] = len(index)
        stack.append(node)
        for other in sorted(below[node]):
            if other not in index:
                visit(other)
                lowest[node] = min(lowest[node], lowest[other])
            elif other in stack:
                lowest[node] = min(lowest[node], index[other])
        if lowest[node] == index[node]:
            members = stack[stack.index(node):]
            del stack[stack.index(node):]
            if len(members) > 1:
                found.append(sorted(members))

    for node in sorted(below):
        if node not in index:
            visit(node)
    return found


def room_complaints(top):
    arrows = {(room(file), room(header)) for file, header in includes_inside(top) if room(file) != room(header)}
    for circle in circles(arrows):
        yield f"{top}: circle of rooms {', '.join(circle)}"


def folder(path):
    return path.rsplit("/", 1)[0]


def folder_complaints(top):
    arrows = {(folder(file), folder(header)) for file, header in includes_inside(top) if folder(file) != folder(header)}
    for circle in circles(arrows):
        yield f"{top}: circle of folders {', '.join(circle)}"


def order_complaints(top):
    order = ORDER[top]
    for folder in sorted({sub_folder(file.relative_to(ROOT).as_posix()) for file in sources(top)} - set(order)):
        yield f"{top}/{folder}: has no place in ORDER"
    for file, header in includes_inside(top):
        start, end = sub_folder(file), sub_folder(header)
        if start != end and start in order and end in order and order.index(end) > order.index(start):
            yield f"{file}: may not include {header}; {end} stands above {start}"


def size_complaints(top):
    for file in sources(top):
        lines = len(file.read_text(encoding="utf-8").splitlines())
        if lines > LINES:
            yield f"{file.relative_to(ROOT)}: {lines} lines, more than {LINES}"
    for folder, files in sorted(Counter(file.parent for file in sources(top)).items()):
        if files > FILES:
            yield f"{folder.relative_to(ROOT)}: {files} files, more than {FILES}"


def loose_complaints(top):
    for file in sources(top):
        if file.parent == ROOT / top:
            yield f"{file.relative_to(ROOT)}: belongs into a sub-folder"


def complaints():
    for top in ROOMS_ONE_WAY:
        yield from room_complaints(top)
        yield from folder_complaints(top)
    for top in SMALL:
        yield from size_complaints(top)
    for top in ORDER:
        yield from order_complaints(top)
    for top in WITHOUT_LOOSE_FILES:
        yield from loose_complaints(top)


def main():
    found = list(complaints())
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
