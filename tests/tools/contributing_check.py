"""The example of CONTRIBUTING.md, Your first feature, fits the sources. Usage: contributing_check.py SOURCE_FOLDER

Tries to apply its diff, without changing anything. If it fails, make the change by hand, and put `git diff -U1` there.
"""
import re
import subprocess
import sys
from pathlib import Path


def main():
    root = Path(sys.argv[1])
    blocks = re.findall(r"^```diff\n(.*?)^```$", (root / "CONTRIBUTING.md").read_text(encoding="utf-8"), re.M | re.S)
    if len(blocks) != 1:
        sys.exit(f"CONTRIBUTING.md: {len(blocks)} diffs, expected one")
    tried = subprocess.run(["git", "apply", "--check", "-"], input=blocks[0], cwd=root, text=True, capture_output=True)
    print(tried.stderr, end="")
    return tried.returncode


if __name__ == "__main__":
    sys.exit(main())
