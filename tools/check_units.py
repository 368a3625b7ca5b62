#!/usr/bin/python3
"""The sources of a folder are compiled together (cmake/UnitsByFolder.cmake): what two of them declare in their unnamed
namespaces must differ in its name, or as functions in their parameters. A build by single sources does not notice."""
import re
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TARGETS = ["common", "coupling", "coarse", "fine", "app", "tests"]


def without_comments_and_texts(source):
    source = re.sub(r"//.*|^\s*#.*", "", source, flags=re.M)
    return re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])\'', '""', source)


def heads(source):
    """What stands before the body or the semicolon of each declaration directly in an unnamed namespace."""
    for start in re.finditer(r"namespace\s*\{", source):
        depth, head = 0, ""
        for character in source[start.end():]:
            if character == "}" and depth == 0:
                break
            if depth == 0 and character in "{;":
                yield head.strip()
            if depth == 0:
                head = "" if character in "{;" else head + character
            depth += {"{": 1, "}": -1}.get(character, 0)


def name_of(head):
    """The name, with the types of the parameters where it is a function's; None where nothing is declared."""
    head = re.sub(r"^template ?<.*?> (?=\w)", "", " ".join(head.split()))
    if kind := re.match(r"(?:struct|class|enum class|enum) (\w+)|using (\w+) =", head):
        return kind[1] or kind[2]
    if head.startswith(("using ", "TEST", "INSTANTIATE_TEST_SUITE")):
        return None
    left = head.split("=")[0].strip()
    if function := re.search(r"(\w+)\((.*)", left):
        return function[1] + "(" + re.sub(r" ?\w+(?=[,)])", "", function[2])
    variable = re.search(r"(\w+)(\[\w*\])*$", left)
    return variable[1] if variable else None


def clashes():
    for target in TARGETS:
        places = defaultdict(set)
        for path in sorted((ROOT / target).rglob("*.cpp")):
            for head in heads(without_comments_and_texts(path.read_text())):
                if name := name_of(head):
                    places[path.parent, name].add(path.name)
        for (folder, name), files in places.items():
            if len(files) > 1:
                yield f"{folder.relative_to(ROOT)}: {name} in {', '.join(sorted(files))}"


if __name__ == "__main__":
    found = list(clashes())
    print("\n".join(found))
    sys.exit(1 if found else 0)
