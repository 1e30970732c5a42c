"""lint --format names a file that is formatted wrongly and no other file; lint names the subject of a commit that is
too long. Exit status 77 without that clang-format."""
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

for subject, expected in [("Say it in few words", 0), ("Say it " + 66 * "x", 1), ("Say it.", 1), ("say it", 1)]:
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        shutil.copytree(source / "tools", root / "tools")

        def git(*words):
            subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b.c", *words], cwd=root, check=True,
                           capture_output=True)
        git("init", "-b", "main")
        git("commit", "--allow-empty", "-m", "Begin")
        git("switch", "-c", "work")
        git("commit", "--allow-empty", "-m", subject)
        done = subprocess.run([root / "tools/lint"], capture_output=True, text=True)
        assert done.returncode == expected and (subject in done.stderr) == (expected == 1), (subject, done)
