"""The files that docs and comments name exist. Usage: paths_check.py SOURCE_FOLDER

1. Docs: `room/file`, with or without an ending, where room is a folder of src/.
2. Comments of src/ and first lines of tests: room/file.h and room/file.cpp, in src/ file.h and file.cpp alone, too.
"""
import re
import sys
from pathlib import Path

# Examples, and files of other programs.
OTHERS = {"edit/commands/commands_x.h", "ui/projectwidget.cpp", "html5.h"}
NAMED = re.compile(r"\b(?:\w+/)*\w+\.(?:h|cpp)\b")


def exists(source, name):
    return name in OTHERS or any((source / top / (name + ending)).exists()
                                 for top in ("", "src", "tests") for ending in ("", ".h", ".cpp"))


def in_docs(source, rooms):
    quoted = re.compile(rf"`((?:src/)?(?:{'|'.join(rooms)})/[\w./]*\w)`")
    for doc in sorted([*source.glob("*.md"), *(source / "docs").rglob("*.md")]):
        for number, line in enumerate(doc.read_text(encoding="utf-8").splitlines(), 1):
            for name in quoted.findall(line):
                if not name.endswith("_") and not exists(source, name):
                    yield f"{doc.relative_to(source)}:{number}: no file {name}"


def in_comments(source, rooms):
    def files(top):
        return sorted(p for p in (source / top).rglob("*") if p.suffix in (".h", ".cpp"))
    known = {path.name for top in ("src", "tests", "bench") for path in files(top)}
    for path in [*files("src"), *files("tests")]:
        lines = path.read_text(encoding="utf-8").splitlines()
        ours = path.is_relative_to(source / "src")
        for number, line in enumerate(lines if ours else lines[:1], 1):
            comment = line.partition("//")[2]
            for name in NAMED.findall(comment):
                whole = name.split("/")[0] in rooms
                if (whole and not exists(source, name)) or (ours and "/" not in name and name not in known | OTHERS):
                    yield f"{path.relative_to(source)}:{number}: no file {name}"


if __name__ == "__main__":
    source = Path(sys.argv[1])
    rooms = sorted(path.name for path in (source / "src").iterdir() if path.is_dir())
    wrong = [*in_docs(source, rooms), *in_comments(source, rooms)]
    print("\n".join(wrong), end="\n" if wrong else "")
    sys.exit(1 if wrong or not rooms else 0)
