"""How far a change of a header reaches: what is compiled again.

Usage: recompiled_check.py SOURCE_FOLDER [--table]
Counts the .cpp files that include a header, directly or not, and compares the counts with limits. --table prints the
rows of docs/architecture.md, What an addition costs; without it they are compared with those of the document.
"""
import re
import sys
from pathlib import Path

# Additions: the files that they change besides the new thing's own, and how many of src/ are compiled again, at most.
ADDITIONS = [
    ("setting", ["world/aid_settings.h", "world/appearance_settings.h", "world/camera_feel.h",
                 "world/panel_settings.h"], 40),
    ("layer", ["world/layers.h"], 60),
    ("command", ["edit/commands/commands_*.h"], 40),
    ("panel", ["ui/panels/panels.cpp"], 1),
    ("page of the laboratory", ["world/laboratory.h"], 80),
    ("name, parameter or limit of an element", ["world/element_rows.h"], 90),
    ("element of the palette", ["world/element_rows.h", "sim/plan/element_shapes.cpp"], 90),
    ("importer", ["exchange/formats.cpp"], 1),
    ("number of a frame", ["query/frame_stats.h", "app/frame.cpp"], 80),
    ("field of a component", ["world/components.h"], 250),
    ("finding", ["edit/session/findings.h", "edit/session/findings_memory.h", "edit/session/findings.cpp"], 110),
]
# Headers that nobody changes for an addition, but that should not reach far: of src/ and tests/.
FIREWALL = {"edit/session/session.h": 220, "edit/session/findings_memory.h": 8, "exchange/formats.h": 60,
            "sim/plan/force_path.h": 60, "sim/solids/conflicts.h": 40, "sim/solids/supports.h": 40,
            "sim/study/complete_circuit.h": 35, "world/laboratory_settings.h": 60}
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)


def included(root):
    """Returns {file: the headers it names}, of src/ by their names there, of tests/ with tests/ before them."""
    source, tests = root / "src", root / "tests"
    files = {}
    for folder, prefix in ((source, ""), (tests, "tests/")):
        for path in (p for ending in ("*.h", "*.cpp") for p in folder.rglob(ending)):
            names = INCLUDE.findall(path.read_text(encoding="utf-8"))
            files[prefix + path.relative_to(folder).as_posix()] = {
                name if (source / name).exists() else "tests/" + name for name in names}
    return files


def recompiled(includes, changed):
    """The .cpp files among includes that need one of the changed files."""
    found, waiting = set(changed), list(changed)
    while waiting:
        named = waiting.pop()
        new = [file for file, headers in includes.items() if named in headers and file not in found]
        found.update(new)
        waiting += new
    return sorted(file for file in found if file.endswith(".cpp"))


def matching(includes, pattern):
    found = [file for file in includes if Path(file).match(pattern) and not file.startswith("tests/")]
    if not found:
        sys.exit(f"src/{pattern}: no such file; correct the tables in {Path(__file__).name}")
    return found


def row(name, files, limit):
    shown = ", ".join(f"`{file}`" for file in files)
    return f"| {name} | {'one of ' if name == 'setting' else ''}{shown} | {limit} |"


def main():
    root = Path(sys.argv[1])
    if "--table" in sys.argv:
        print("\n".join(row(*addition) for addition in ADDITIONS))
        return 0
    includes, wrong = included(root), 0
    of_src = {file: headers for file, headers in includes.items() if not file.startswith("tests/")}

    def compare(what, count, limit):
        nonlocal wrong
        print(f"{what}: {count} of at most {limit}")
        wrong += count > limit

    for name, files, limit in ADDITIONS:
        changed = [found for file in files for found in matching(of_src, file)]
        alone = name in ("setting", "command")  # one of the files is changed
        for group in [[file] for file in changed] if alone else [changed]:
            compare(f"{name} ({', '.join(group)})", len(recompiled(of_src, group)), limit)
    for header, limit in FIREWALL.items():
        compare(f"src/{header}", len(recompiled(includes, matching(includes, header))), limit)
    text = (root / "docs" / "architecture.md").read_text(encoding="utf-8")
    for addition in ADDITIONS:
        if row(*addition) not in text:
            print(f"docs/architecture.md lacks this row of {Path(__file__).name} --table:\n  {row(*addition)}")
            wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
