"""How many source files a small addition recompiles (docs/architecture.md, What an addition costs).

Usage: recompiled_check.py SOURCE_FOLDER
Counts the .cpp files of src/ that include a header, directly or not, and compares the count with a limit.
"""
import re
import sys
from pathlib import Path

# Headers that get a row. Settings that derived data depend on (world/evaluation.h) reach further.
LIMITS = {"world/aids.h": 40, "world/camera_feel.h": 40, "world/look.h": 40, "world/panels.h": 40,
          "world/layers.h": 60, "world/lab_view.h": 60, "exchange/formats.h": 40, "edit/commands/commands_*.h": 40}
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)


def recompiled(includes, header):
    """The .cpp files among includes (file: the headers it names) that need the header."""
    found, waiting = {header}, [header]
    while waiting:
        named = waiting.pop()
        new = [file for file, headers in includes.items() if named in headers and file not in found]
        found.update(new)
        waiting += new
    return sorted(file for file in found if file.endswith(".cpp"))


if __name__ == "__main__":
    source = Path(sys.argv[1]) / "src"
    includes = {str(path.relative_to(source)): set(INCLUDE.findall(path.read_text()))
                for ending in ("*.h", "*.cpp") for path in source.rglob(ending)}
    wrong = 0
    for pattern, limit in LIMITS.items():
        headers = sorted(str(path.relative_to(source)) for path in source.glob(pattern))
        if not headers:
            print(f"src/{pattern}: no such file; correct the table in {Path(__file__).name}")
            wrong += 1
        for header in headers:
            files = recompiled(includes, header)
            print(f"src/{header}: {len(files)} of at most {limit}")
            if len(files) > limit:
                print("  " + ", ".join(files))
                wrong += 1
    sys.exit(1 if wrong else 0)
