"""The window's display: without OpenGL, with an old one, with one that crashes, and gone while there is unsaved work.

Usage: display_test.py COASTER FOLDER. Exit status 77 (skipped) when Xvfb is missing.
"""
import pathlib
import shutil
import subprocess
import sys

from lost_display import expect_saved
from window import environment, need, start_display


def expect(what, found, *wanted):
    for text in wanted:
        if text not in found:
            raise SystemExit(f"{what}: expected {text!r}, found {found!r}")


def expect_no_graphics(coaster, out, display, *wanted, **more):
    """The program ends with exit code 4 and one line."""
    done = subprocess.run([coaster, "--frames", "2", "--config", out / "home"], env=environment(display, **more),
                          capture_output=True, text=True, timeout=120)
    lines = [line for line in done.stderr.splitlines() if not line.startswith(("libGL", "MESA"))]
    if done.returncode != 4 or len(lines) != 1:
        raise SystemExit(f"{more}: expected exit code 4 and a line, found {done.returncode} and {done.stderr!r}")
    expect(more, lines[0], *wanted)


def main():
    coaster, out = sys.argv[1], pathlib.Path(sys.argv[2])
    need("Xvfb")
    shutil.rmtree(out, ignore_errors=True)
    (out / "home").mkdir(parents=True)

    server, display = start_display("-extension", "GLX", size="640x480")
    try:
        expect_no_graphics(coaster, out, display, "a window needs OpenGL 3.3 core, the driver has none", "--headless")
    finally:
        server.kill()
        server.wait()

    server, display = start_display(size="640x480")
    try:
        expect_no_graphics(coaster, out, display, "a window needs OpenGL 3.3 core, the driver has 2.1",
                           MESA_GL_VERSION_OVERRIDE="2.1")
        expect_no_graphics(coaster, out, display, "a window needs OpenGL 3.3 core", "GLX",
                           MESA_GLSL_VERSION_OVERRIDE="130")
        expect_no_graphics(coaster, out, display, "The OpenGL driver crashed at its start", "LP_NATIVE_VECTOR_WIDTH=0",
                           LP_NATIVE_VECTOR_WIDTH="0")
        expect_saved(coaster, out, environment(display), server.kill)
    finally:
        server.kill()
        server.wait()


main()
