"""A list of points named on the command line is asked about in the window; Enter opens it as proposed.

Usage: import_test.py COASTER FOLDER. Exit status 77 (skipped) when Xvfb or xdotool is missing.
"""
import json
import pathlib
import sys
import time

from window import Window, need, wait_for

POINTS = "500000 4000000 30\n500200 4000000 35\n500200 4000100 30\n500000 4000100 30\n"  # UTM: z is up


def main():
    coaster, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    need("Xvfb", "xdotool")
    with Window(coaster, folder, folder / "utm.xyz", files={"utm.xyz": POINTS}) as window:
        track = folder / "recording-2.json"  # beside the recording: what was loaded after its start

        wait_for("the start", lambda: "camera target" in window.recorded())
        time.sleep(1)
        assert not track.exists(), f"opened before it was asked about:\n{window.recorded()}"

        def pressed():
            window.xdo("key", "Return")
            time.sleep(0.5)
            return track.exists()

        wait_for("the import", pressed)
        first = json.loads(track.read_text())["knots"][0]["position"]
        assert max(map(abs, first)) < 1000, f"expected the track at the origin, as proposed, found a knot at {first}"
    return 0


if __name__ == "__main__":
    sys.exit(main())
