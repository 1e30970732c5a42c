"""The rule for test files (head of tests/CMakeLists.txt), checked. Usage: test_files_check.py SOURCE_FOLDER

1. tests/FOLDER/NAME_test.cpp tests src/FOLDER/NAME.h or NAME.cpp, or its first line is a comment that says what it
   tests.
2. A header with functions or classes that another room includes is included by a test of its own room.
"""
import re
import sys
from pathlib import Path

INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)
FUNCTION = r"^(?!COASTER_)(?:\[\[nodiscard\]\] )?[a-zA-Z][^;{}=#]*\([^;{}]*\)(?: const)?;"
CLASS = r"^(?:template .*\n)?class \w+ (?:final )?\{"
DECLARES = re.compile(f"{FUNCTION}|{CLASS}", re.M)


def unnamed_tests(source):
    for test in sorted((source / "tests").rglob("*_test.cpp")):
        name = str(test.relative_to(source / "tests")).removesuffix("_test.cpp")
        named = any((source / "src" / f"{name}{ending}").is_file() for ending in (".h", ".cpp"))
        if not named and not test.read_text().startswith("//"):
            yield f"tests/{name}_test.cpp: no src/{name}.h or .cpp; expected a first line that says what it tests"


def untested_headers(source):
    def includes(top):
        for path in (source / top).rglob("*"):
            if path.suffix in (".cpp", ".h"):
                yield path.relative_to(source / top).parts[0], INCLUDE.findall(path.read_text())
    shared = {header for room, headers in includes("src") for header in headers if header.split("/")[0] != room}
    tested = {header for room, headers in includes("tests") for header in headers if header.split("/")[0] == room}
    for header in sorted(shared - tested):
        path = source / "src" / header
        if path.is_file() and DECLARES.search(path.read_text()):
            yield f"src/{header}: other rooms include it; expected a test in tests/{header.split('/')[0]} that does"


if __name__ == "__main__":
    source = Path(sys.argv[1])
    wrong = [*unnamed_tests(source), *untested_headers(source)]
    print("\n".join(wrong), end="\n" if wrong else "")
    sys.exit(1 if wrong else 0)
