"""A Wayland compositor that is killed while there is unsaved work.

Usage: wayland_test.py COASTER FOLDER. Exit status 77 (skipped) when weston is missing or GLFW has no Wayland.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from lost_display import expect_saved


def start_compositor(environment):
    """weston without a screen, and the environment of its clients."""
    socket = pathlib.Path(environment["XDG_RUNTIME_DIR"]) / "coaster"
    command = ["weston", "--backend=headless-backend.so", "--no-config", "--idle-time=0", "--socket=" + socket.name]
    weston = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end = time.monotonic() + 60
    while not socket.exists():
        if weston.poll() is not None or time.monotonic() > end:
            weston.kill()
            raise SystemExit("weston did not start")
        time.sleep(0.05)
    return weston, {**environment, "WAYLAND_DISPLAY": socket.name}


def main():
    coaster, out = sys.argv[1], pathlib.Path(sys.argv[2])
    if shutil.which("weston") is None:
        print("skipped: weston is missing")
        raise SystemExit(77)
    shutil.rmtree(out, ignore_errors=True)
    (out / "home").mkdir(parents=True)
    with tempfile.TemporaryDirectory() as runtime:  # the path of a socket has at most 107 bytes
        bare = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        weston, environment = start_compositor({**bare, "XDG_RUNTIME_DIR": runtime})
        try:
            tried = subprocess.run([coaster, "--frames", "2", "--config", out / "home"], env=environment,
                                   capture_output=True, text=True, timeout=120)
            if "X11: The DISPLAY environment variable is missing" in tried.stderr:
                print("skipped: GLFW has no Wayland")
                raise SystemExit(77)
            if tried.returncode != 0:
                raise SystemExit(f"under weston: {tried.returncode}, {tried.stderr!r}")
            expect_saved(coaster, out, environment, weston.kill)
        finally:
            weston.kill()
            weston.wait()


main()
