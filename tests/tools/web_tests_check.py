"""tests/web/native_alone.txt lists what cannot run in node and nothing else; tests with pinned hashes run there, too.

Usage: web_tests_check.py SOURCE
"""
import fnmatch
import pathlib
import re
import sys

ROOMS = ("base", "curve", "world", "sim", "exchange", "edit", "view", "query")
NATIVE = re.compile(r"rapidcheck|EXPECT_EXIT|EXPECT_DEATH|fork\(|std::j?thread")
PINNED = re.compile(r'hex16\(.*"[0-9a-f]{16}"|\{"\w+", (?:\{)?"[0-9a-f]{16}"')
CASE = re.compile(r"^TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)", re.M)
LEAST = 6  # files that pin hashes


def main():
    tests = pathlib.Path(sys.argv[1], "tests")
    lines = (tests / "web/native_alone.txt").read_text().splitlines()
    lines = [line for line in lines if line and not line.startswith("#")]
    listed = {line for line in lines if line.endswith("_test.cpp")}
    names = [line for line in lines if line not in listed]
    files = [file for room in ROOMS for file in (tests / room).rglob("*_test.cpp")]
    text = {str(file.relative_to(tests)): file.read_text() for file in files}
    native = {file for file in text if NATIVE.search(text[file])}
    wrong = [f"{file} cannot run in node: add it to tests/web/native_alone.txt" for file in native - listed]
    wrong += [f"{file} can run in node: remove it from tests/web/native_alone.txt" for file in listed - native]
    pinned = [file for file in text if PINNED.search(text[file])]
    wrong += [f"{file} pins hashes and must run in node" for file in pinned if file in listed]
    if len(pinned) < LEAST:
        wrong.append(f"{len(pinned)} files pin hashes, expected {LEAST} at least")
    cases = {file: [".".join(case) for case in CASE.findall(text[file])] for file in text}
    for name in names:
        found = [file for file in text for case in cases[file] if fnmatch.fnmatchcase(case, name)]
        wrong += [f"no test is named {name}"] if not found else []
        wrong += [f"{name} leaves out a test of {file}, which pins hashes" for file in found if file in pinned]
    print("\n".join(sorted(wrong)))
    raise SystemExit(bool(wrong))


main()
