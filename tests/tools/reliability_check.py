"""Every row of the scenarios in docs/reliability.md names a test that exists.

Usage: reliability_check.py SOURCE
"""
import pathlib
import re
import sys


CASE = re.compile(r"^(?:TEST|TEST_F|RC_GTEST_PROP)\(\s*(\w+),\s*(\w+)", re.M)


def tests_of(source):
    names = set()
    for file in (source / "tests").rglob("*_test.cpp"):
        names |= {f"{suite}.{case}" for suite, case in CASE.findall(file.read_text())}
    names |= {"script." + file.stem for file in (source / "tests/scripts").glob("*.coaster")}
    names |= {"script." + file.stem for file in (source / "tests/app").glob("*_check.sh")}
    names |= {"window." + file.stem.removesuffix("_test") for file in (source / "tests/window").glob("*_test.py")}
    names |= {"tool." + file.stem.removesuffix("_check") for file in (source / "tests/tools").glob("*_check.py")}
    names |= {"fuzz." + folder.name for folder in (source / "tests/fuzz/corpus").iterdir()}
    return names


def main():
    source = pathlib.Path(sys.argv[1])
    known, rows, wrong = tests_of(source), 0, []
    for line in (source / "docs/reliability.md").read_text().split("## Memory")[0].splitlines():
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        if len(cells) != 3 or cells[2] == "test" or set(cells[2]) == {"-"}:
            continue
        rows += 1
        named = re.findall(r"`([^`]+)`", cells[2])
        wrong += [f"{cells[0]}: no test is named"] if not named else []
        for name in named:
            if name not in known and name.split(".", 1)[1] not in known:
                wrong.append(f"{cells[0]}: there is no test {name}")
    if rows < 40:
        wrong.append(f"only {rows} rows were found")
    print("\n".join(wrong))
    raise SystemExit(bool(wrong))


main()
