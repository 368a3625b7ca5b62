#!/usr/bin/python3
"""Checks what sources and documents cite: documents, their sections and entries, links, paths. Also that lines are short."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("app", "bench", "cases", "coarse", "common", "coupling", "docs", "examples", "fine", "tests", "tools")
KINDS = {".cpp", ".hpp", ".md", ".py", ".toml"}
LONGEST = 120  # characters of a line of markdown, tables and code aside

# "docs/method.md, sections 1 and 3" and "docs/references.md 2.1 to 2.3": a document, and numbers of its headings.
NUMBER = r"\d+(?:\.\d+)*"
GAP = r"\s+(?:(?://+|#)\s*)?"  # a space, or the next line of a comment
DOCUMENT = re.compile(rf"(?<![\w/.-])((?:\.\./)*(?:[\w-]+/)*[\w-]+\.md)\b(?:,?(?:{GAP}sections?)?{GAP}({NUMBER}(?:(?:, and|,|{GAP}and|{GAP}to){GAP}{NUMBER})*))?")
# A document named by a word in capitals: "MANUAL 2.1", "MANUAL section 2". Formats, journals and signals are none.
KNOWN = "VTKHDF|CMAME|IJNME|SIGTERM"
CAPITALS = re.compile(rf"\b(?!(?:{KNOWN})\b)([A-Z]{{5,}})(?:,?{GAP}sections?)?,?{GAP}\d")
HEADING = re.compile(r"^#+ +(\d+(?:\.\d+)*)\b", re.MULTILINE)
LINK = re.compile(r"\]\(([^)\s]+)\)")
# A path in backticks, as `coarse/zone/zone_selection.cpp:select_zone` or `coarse/zone/`.
PLACE = re.compile(r"`((?:%s)/[\w/.-]*)(?::~?\w+)?`" % "|".join(FOLDERS))


def files():
    found = [file for file in ROOT.iterdir() if file.is_file()]
    for folder in FOLDERS:
        found += (ROOT / folder).rglob("*")
    return sorted(file for file in found if file.suffix in KINDS and file != Path(__file__).resolve())


def diary(file):
    """What the log tells stays as it was written, so the paths in it may be gone."""
    return ROOT / "docs/log" in file.parents


def document(file, name):
    """A document is named from the top of the repository, or from the folder of who names it."""
    return next((path for path in (ROOT / name, file.parent / name) if path.is_file()), None)


def slug(heading):
    return re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")


def of_citations(file, text):
    """Documents and the numbers of their headings; a citation may go on in the next line."""
    for match in DOCUMENT.finditer(text):
        name, numbers = match.groups()
        line = text.count("\n", 0, match.start()) + 1
        target = document(file, name)
        if not target:
            yield line, f"there is no document {name}"
        elif numbers:
            headings = HEADING.findall(target.read_text(encoding="utf-8"))
            yield from ((line, f"{name} has no {number}") for number in re.findall(NUMBER, numbers) if number not in headings)
    for match in CAPITALS.finditer(text):
        yield text.count("\n", 0, match.start()) + 1, f"there is no document {match.group(1)}"


def of_markdown(file, text):
    inside_code = False
    for line, part in enumerate(text.splitlines(), 1):
        if part.startswith("```"):
            inside_code = not inside_code
        if inside_code:
            continue
        if len(part) > LONGEST and not part.startswith(("|", "    ")):
            yield line, f"{len(part)} characters, no more than {LONGEST}"
        for target in LINK.findall(part):
            if not re.match(r"\w+:", target):
                yield from ((line, problem) for problem in of_link(file, target))
        for place in [] if diary(file) else PLACE.findall(part):
            if not (ROOT / place).exists():
                yield line, f"there is no {place}"


def of_link(file, target):
    path, _, anchor = target.partition("#")
    there = file.parent / path if path else file
    if not there.exists():
        yield f"link to {target}: there is no {path}"
    elif anchor:
        headings = re.findall(r"^#+ +(.*)$", there.read_text(encoding="utf-8"), re.MULTILINE)
        if anchor not in map(slug, headings):
            yield f"link to {target}: no such heading"


def main():
    found = 0
    for file in files():
        text = file.read_text(encoding="utf-8")
        complaints = list(of_citations(file, text))
        if file.suffix == ".md":
            complaints += of_markdown(file, text)
        for line, problem in sorted(complaints):
            print(f"{file.relative_to(ROOT).as_posix()}:{line}: {problem}")
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
