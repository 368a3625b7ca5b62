#!/usr/bin/python3
"""Checks who includes whom: folders point downwards only, and each library comes in by one door."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# A folder may include itself and what stands here.
BELOW = {
    "common": set(),
    "coupling": {"common"},
    "coarse": {"coupling", "common"},
    "fine": {"coupling", "common"},
    "app": {"coarse", "fine", "coupling", "common"},
}

# Library, its headers, and the files or folders (ending in /) that may see them.
DOORS = [
    ("MPI", r"mpi\.h$", ["coupling/transport/mpi_transport.cpp", "coupling/transport/doorbell.cpp", "app/"]),
    ("CGAL", r"CGAL/", ["common/geometry/clipping.cpp"]),
    ("CHOLMOD and UMFPACK", r"(suitesparse/)?(cholmod|umfpack|amd|colamd|SuiteSparse_config)\w*\.h$", ["common/linear/", "common/substructure/sparse_leaf.cpp"]),
    ("HDF5", r"(hdf5|hdf5_hl|H5\w*)\.h$", ["common/io/hdf5.cpp"]),
    ("toml++", r"(toml\+\+/|toml\.hpp$)", ["common/case/schema/case_file.cpp"]),
    ("CLI11", r"CLI/", ["app/command_line.cpp"]),
    ("nlohmann-json", r"nlohmann/", ["common/io/json.hpp"]),
]

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def may_enter(path, doors):
    return any(path.startswith(door) if door.endswith("/") else path == door for door in doors)


def complaints(path, header):
    folder = path.split("/")[0]
    target = header.split("/")[0]
    if target in BELOW and target != folder and target not in BELOW[folder]:
        yield f"{folder}/ may not include {header}"
    for library, pattern, doors in DOORS:
        if re.match(pattern, header) and not may_enter(path, doors):
            yield f"{library} ({header}) comes in through {', '.join(doors)} only"


def main():
    found = 0
    for folder in BELOW:
        for file in sorted((ROOT / folder).rglob("*.[hc]pp")):
            path = file.relative_to(ROOT).as_posix()
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                include = INCLUDE.match(line)
                for complaint in complaints(path, include.group(1)) if include else ():
                    print(f"{path}:{number}: {complaint}")
                    found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
