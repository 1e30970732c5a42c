"""A window that crashes a second after its last change, idle or not: the next start offers the change.

Usage: crash_test.py COASTER FOLDER. Exit status 77 (skipped) when Xvfb or xdotool is missing.
"""
import pathlib
import signal
import subprocess
import sys
import time

from window import Window, need, wait_for

RECOVERED = """coaster-script 1
expect recoverable == 1
ui.click "Recovery/Recover"
frames 1
expect dirty == on
expect knots == {}
"""
DELETED = "remove @k1\n"  # what the keys add to the recording


def main():
    coaster, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    source = pathlib.Path(__file__).resolve().parents[2]
    need("Xvfb", "xdotool")
    for wait in (1, 3):  # s: drawing still, and idle
        with Window(coaster, folder, source / "tracks" / "gentle.json") as window:
            wait_for("the start", lambda: "camera target" in window.recorded())

            def deleted():
                window.xdo("key", "ctrl+a")
                window.xdo("key", "Delete")
                time.sleep(0.3)
                return DELETED in window.recorded()

            wait_for("the change", deleted)
            time.sleep(wait)
            window.program.send_signal(signal.SIGSEGV)
            code = window.program.wait(20)
            assert code == -signal.SIGSEGV, f"ended by {code}"
            log = window.log.read_text()
            assert "Unsaved changes were kept" in log, log
        script = folder / "recovered.coaster"
        script.write_text(RECOVERED.format(0))
        done = subprocess.run([coaster, "--headless", "--script", script, "--config", folder / "config", "--out",
                               folder / "out"], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
    return 0


if __name__ == "__main__":
    sys.exit(main())
