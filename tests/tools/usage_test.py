"""Every tool of tools/ prints its help for --help and refuses unknown arguments before it builds or installs anything.

Usage: usage_test.py TOOLS_FOLDER. The tools run with a PATH on which whatever builds, installs or fetches leaves a
mark.
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

DOERS = ("cmake", "ninja", "ctest", "apt-get", "dpkg-query", "sudo", "debootstrap", "unshare", "clang-format",
         "clang-tidy", "cpack")
# Arguments that come after those that a tool takes.
LATER = {"bench": (["--short", "--shrt"], ["--benchmark_filter=x", "--short"], ["--drift", "--benchmark_filter=x"]),
         "fuzz": (["60", "--short"], ["soon"]), "lint": (["--all", "--format"],), "test": (["--quick", "--lint"],),
         "web": (["--build", "--file"], ["--biuld"]), "package": (["--no-install", "again"],), "pictures": (["again"],),
         "play": (["a.json", "b.json"],), "chroot": (["trixie"], []), "install_dependencies": (["play", "tset"],),
         "check_layers": ([".", "."],), "plot_ride_truth": (["a", "b", "c"],), "count_tests": ([],)}


def main():
    folder = Path(sys.argv[1]).resolve()
    tools = [path for path in sorted(folder.iterdir()) if path.is_file() and os.access(path, os.X_OK)]
    wrong = [] if len(tools) > 10 else ["found hardly any tools"]
    with tempfile.TemporaryDirectory() as folder:
        mark = Path(folder) / "mark"
        for name in DOERS:
            doer = Path(folder) / name
            doer.write_text(f"#!/bin/sh\necho {name} >>{mark}\nexit 1\n")
            doer.chmod(0o755)
        environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}
        for tool in tools:
            cases = [(["--help"], 0), (["-h"], 0), (["--no-such-option"], 2), (["-x"], 2)]
            for words, code in cases + [(words, 2) for words in LATER.get(tool.name, ())]:
                done = subprocess.run([tool, *words], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                      capture_output=True, text=True, timeout=60)
                line = f"{tool.name} {' '.join(words)}"
                if done.returncode != code:
                    wrong.append(f"{line}: exit code {done.returncode}, expected {code}: {done.stderr.strip()[-200:]}")
                if "Traceback" in done.stdout + done.stderr:
                    wrong.append(f"{line}: a traceback")
                told, silent = (done.stdout, done.stderr) if code == 0 else (done.stderr, done.stdout)
                if silent or len(told.split()) < 5 or (code == 0 and tool.name != "lint" and len(told) < 60):
                    wrong.append(f"{line}: prints {told!r}, and {silent!r} where nothing belongs")
                if mark.exists():
                    wrong.append(f"{line}: runs {mark.read_text().split()}")
                    mark.unlink()
    print("\n".join(wrong) if wrong else f"{len(tools)} tools: clean")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
