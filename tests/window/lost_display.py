"""What a program does whose display is gone. Shared by display_test.py and wayland_test.py."""
import subprocess
import time

SCRIPT = """coaster-script 1
env size 320x180
append at 0 5 0
append at 20 5 0
shot "$OUT/ready.png"
frames 1000000
"""


def expect_saved(coaster, out, environment, end_display):
    """Starts the program, ends its display while there is unsaved work: it says so, and the work can be recovered."""
    (out / "lost.coaster").write_text(SCRIPT)
    lost = subprocess.Popen([coaster, "--script", out / "lost.coaster", "--out", out / "run", "--config", out / "home"],
                            env=environment, stderr=subprocess.PIPE, text=True)
    end = time.monotonic() + 60
    while not (out / "run" / "ready.png").exists() and lost.poll() is None and time.monotonic() < end:
        time.sleep(0.05)
    end_display()
    try:
        _, errors = lost.communicate(timeout=60)
    finally:
        lost.kill()
    wanted = "The display is gone. Unsaved changes are kept for the next start."
    if lost.returncode != 4 or wanted not in errors:
        raise SystemExit(f"lost display: expected exit code 4 and {wanted!r}, found {lost.returncode} and {errors!r}")
    if not list((out / "home" / "recovery").glob("*.info.json")):
        raise SystemExit("lost display: nothing can be recovered")
