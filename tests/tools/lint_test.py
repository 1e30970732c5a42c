"""lint --format names a file that is formatted wrongly and no other file. Exit status 77 without that clang-format."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

source = pathlib.Path(sys.argv[1])
for text, expected in [("int a = 1;\n", 0), ("int  a=1;\n", 1)]:
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        for folder in ("tools", "src", "tests", "bench", "shaders"):
            (root / folder).mkdir()
        shutil.copy(source / ".clang-format", root)
        for tool in ("lint", "usage.sh"):
            shutil.copy(source / "tools" / tool, root / "tools")
        (root / "src/a.cpp").write_text(text)
        done = subprocess.run([root / "tools/lint", "--format"], capture_output=True, text=True)
        if done.returncode == 77:
            sys.exit(77)
        assert done.returncode == expected and ("src/a.cpp:1:" in done.stderr) == (expected == 1), (text, done)
