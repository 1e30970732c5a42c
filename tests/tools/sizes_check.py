"""The sizes that CONTRIBUTING.md names. Usage: sizes_check.py SOURCE_FOLDER

Files of src/ have at most 300 lines, functions 60, folders 30 .cpp files. tool.format checks the width of lines.
"""
import re
import sys
from pathlib import Path

FILE, FUNCTION, FOLDER = 300, 60, 30
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


def wrong(source):
    folders = {}
    for path in sorted(source.rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        name, lines = path.relative_to(source.parent), path.read_text().splitlines()
        if len(lines) > FILE:
            yield f"{name}: {len(lines)} lines, at most {FILE}"
        yield from (f"{name}:{start}: a function of {length} lines, at most {FUNCTION}"
                    for start, length in long_functions(lines))
        if path.suffix == ".cpp":
            folders[name.parent] = folders.get(name.parent, 0) + 1
    yield from (f"{folder}: {count} .cpp files, at most {FOLDER}" for folder, count in folders.items() if count > FOLDER)


if __name__ == "__main__":
    found = list(wrong(Path(sys.argv[1]) / "src"))
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)
