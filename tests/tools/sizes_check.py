"""The sizes that CONTRIBUTING.md names. Usage: sizes_check.py SOURCE_FOLDER

Files of src/ have at most 600 lines, functions 60. Lines have at most 120 columns; tool.format checks those of C++.
"""
import re
import sys
from pathlib import Path

FILE, FUNCTION, LINE = 600, 60, 120
# The folders whose lines are measured, besides the files at the top, and what is exempt there.
FOLDERS = ("bench", "cmake", "packaging", "shaders", "tests", "third_party", "tools")
EXEMPT = (
    ".cpp", ".h",  # tool.format
    ".coaster",  # a statement of a script takes one line
    ".json", ".csv", ".fvd", ".nltrack",  # data
    ".png", ".pyc",  # not text
)
CORPUS = Path("tests/fuzz/corpus")
# What opens a brace at the left margin without being a function, as clang-format leaves it: scopes, types and tables.
OTHER = re.compile(r"(namespace|struct|class|union|enum|extern|template)\b.*[^)]{$|.*= ?{$|.*(\w|\])\{$")


def long_functions(lines):
    start = None
    for number, line in enumerate(lines, 1):
        if start is None and re.match(r"\w.*{$", line) and not OTHER.match(line):
            start = number
        elif start is not None and line.startswith("}"):
            if number - start >= FUNCTION:
                yield start, number - start + 1
            start = None


def long_lines(root):
    files = [path for folder in FOLDERS for path in (root / folder).rglob("*")]
    for path in sorted([*files, *root.glob("*.md"), root / "CMakeLists.txt", root / ".clang-tidy"]):
        name = path.relative_to(root)
        if not path.is_file() or path.suffix in EXEMPT or CORPUS in name.parents:
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            is_row = path.suffix == ".md" and line.startswith("|")  # of a table
            if len(line) > LINE and not is_row:
                yield f"{name}:{number}: {len(line)} columns, at most {LINE}"


def wrong(source):
    for path in sorted(source.rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        name, lines = path.relative_to(source.parent), path.read_text().splitlines()
        if len(lines) > FILE:
            yield f"{name}: {len(lines)} lines, at most {FILE}"
        yield from (f"{name}:{start}: a function of {length} lines, at most {FUNCTION}"
                    for start, length in long_functions(lines))


if __name__ == "__main__":
    root = Path(sys.argv[1])
    found = [*wrong(root / "src"), *long_lines(root)]
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)
