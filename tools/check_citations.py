#!/usr/bin/python3
"""Checks what sources and documents cite: documents, their sections and entries, links, paths, classes. Also that lines
are short, and that the runs of a page go into folders of their own: a second one into one folder is refused."""

import functools
import re
import shlex
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
# A section of a linked document, by its title: a heading, or the beginning of a paragraph in bold letters.
SECTION = re.compile(r'\]\(([^)#\s]+\.md)\),\s+"([^"]+)"')
TITLE = re.compile(r"^#+ +([^\n]*)$|\*\*([^*]+)\*\*", re.MULTILINE)
# A path in backticks, as `coarse/zone/zone_selection.cpp:select_zone` or `coarse/zone/`.
PLACE = re.compile(r"`((?:%s)/[\w/.-]*)(?::~?\w+)?`" % "|".join(FOLDERS))
# A class in backticks, as `YieldGuard` or `NominalBody::K_of_faces`.
CLASS = re.compile(r"`([A-Z][a-z]+[A-Z]\w*)(?:::(\w+))?`")
NO_CLASS = {"VmRSS"}  # of Linux
COMMAND = re.compile(r"^    ((?:\./)?stria (?:run|study) (?:.*\\\n)*.*)$", re.MULTILINE)


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


@functools.cache
def words_of_sources():
    sources = [file.read_text(encoding="utf-8") for file in files() if file.suffix in {".cpp", ".hpp"}]
    return {word for text in sources for word in re.findall(r"\w+", text)}


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
        for names in [] if diary(file) else CLASS.findall(part):
            for name in filter(None, names):
                if name not in words_of_sources() | NO_CLASS:
                    yield line, f"there is no {name}"


def of_sections(file, text):
    for match in SECTION.finditer(text):
        name, wanted = match.group(1), " ".join(match.group(2).split()).lower()
        if (file.parent / name).is_file():
            titles = TITLE.findall((file.parent / name).read_text(encoding="utf-8"))
            if not any(wanted in " ".join((heading or bold).split()).lower() for heading, bold in titles):
                yield text.count("\n", 0, match.start()) + 1, f'{name} has no section "{match.group(2)}"'


def of_commands(text):
    """Where each run and each study of a page goes."""
    taken = set()
    for match in COMMAND.finditer(text):
        words = shlex.split(match.group(1).replace("\\\n", " "), comments=True)
        case = Path(words[2])
        folder = "runs/" + (case.parent.name if case.name == "case.toml" else case.stem) + "-study" * (words[1] == "study")
        if "-o" in words:
            folder = words[words.index("-o") + 1]
        if folder in taken and not {"--force", "--resume", "--print-commands"} & set(words):
            yield text.count("\n", 0, match.start()) + 1, f"{folder} has the results of a command before"
        taken.add(folder)


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
            complaints += [] if diary(file) else of_sections(file, text)
        if file.name == "README.md":
            complaints += of_commands(text)
        for line, problem in sorted(complaints):
            print(f"{file.relative_to(ROOT).as_posix()}:{line}: {problem}")
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
