"""A real window under Xvfb: a real mouse drags a knot and a real key undoes it. The recording replays headless to the
same hashes.

Usage: drag_test.py COASTER FOLDER. Exit status 77 (skipped) when Xvfb or xdotool is missing.
"""
import json
import math
import pathlib
import re
import signal
import subprocess
import sys

from window import Window, need, wait_for



def knot(name, x):
    return {"id": name, "position": [x, 10, 0], "tangent": [1, 0, 0], "up": [0, 1, 0], "in": 6, "out": 6,
            "joint": "smooth"}


TRACK = json.dumps({
    "format": "coaster-track", "version": 1, "name": "Line", "closed": False, "start_speed": 5, "datum": 0,
    "knots": [knot("k1", -20), knot("k2", 0), knot("k3", 20)],
    "segments": [{"id": "s1", "from": "k1", "to": "k2", "turns": 0},
                 {"id": "s2", "from": "k2", "to": "k3", "turns": 0}],
    "carts": [{"id": "c1", "segment": "s1", "fraction": 0}],
})


def documents(log):
    """The document's hash of each whole line of a log of ticks."""
    return [line.split()[3] for line in log.split("\n")[:-1] if line.startswith("tick")]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def pixel_of(point, recording):
    """Where the 1280x720 window shows a point, by the camera that the recording starts with; the panels are hidden."""
    camera = re.search(r"^camera target (\S+) (\S+) (\S+) yaw (\S+) pitch (\S+) distance (\S+)", recording, re.M)
    *target, yaw, pitch, distance = map(float, camera.groups())
    yaw, pitch = math.radians(yaw), math.radians(pitch)
    back = (math.sin(yaw) * math.cos(pitch), math.sin(pitch), math.cos(yaw) * math.cos(pitch))
    right = (math.cos(yaw), 0, -math.sin(yaw))
    up = cross(back, right)
    offset = [a - b for a, b in zip(point, target)]
    x, y, z = (sum(a * b for a, b in zip(offset, axis)) for axis in (right, up, back))
    left, top, width, height = 0, 0, 1280, 720
    scale = height / 2 / math.tan(math.radians(22.5)) / (distance - z)
    return round(left + width / 2 + x * scale), round(top + height / 2 - y * scale)


def drag_and_undo(window, log):
    """Drags the middle knot, starts the ride and undoes the drag."""
    recorded = window.recorded

    def xdo(*arguments):
        window.xdo(*arguments)
        # However slow the machine, some frames see it before the next thing happens: each writes its ticks to the log.
        for _ in range(3):
            size = log.stat().st_size
            wait_for("a frame", lambda: log.stat().st_size > size)

    wait_for("the window", lambda: window.xdo("search", "--name", "coaster").strip())
    wait_for("the first frames", lambda: "ticks" in recorded() or log.stat().st_size > 0)
    # Keys that come before go to no window.
    wait_for("the keyboard's focus", lambda: "coaster" in window.xdo("getwindowfocus", "getwindowname"))
    xdo("key", "Tab")
    wait_for("the panels to be hidden", lambda: "panels off" in recorded())
    wait_for("the camera", lambda: re.search(r"^camera .*\n", recorded(), re.M))
    xdo("mousemove", *pixel_of((0, 10, 0), recorded()))
    xdo("mousedown", 1)
    for _ in range(6):
        xdo("mousemove_relative", "--", 2, -9)
    xdo("mouseup", 1)
    drag = re.compile(r"^gesture\.begin[\s\S]*move @k2 to [\s\S]*gesture\.end", re.M)
    wait_for("the drag to be recorded", lambda: drag.search(recorded()))
    xdo("key", "space")
    wait_for("the ride to start", lambda: "ride.start" in recorded())
    xdo("key", "ctrl+z")
    wait_for("the undo to be recorded", lambda: re.search(r"^undo", recorded(), re.M))

    def is_back():
        found = documents(log.read_text())
        return len(found) > 3 and found[-1] == found[-3] == found[0]

    wait_for("the knot to be back", is_back)


def main():
    coaster, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    need("Xvfb", "xdotool")
    track = folder / "line.json"
    with Window(coaster, folder, track, "--hash-log", files={track.name: TRACK}) as window:
        log = window.log
        try:
            drag_and_undo(window, log)
            window.program.send_signal(signal.SIGTERM)
            window.program.wait(30)
        except SystemExit:
            ended = window.program.poll()
            print("the program", "runs" if ended is None else f"has ended with {ended}", log.read_text()[-300:])
            raise
    live = [line for line in log.read_text().splitlines() if line.startswith("tick")]
    replay = subprocess.run([coaster, "--headless", "--script", window.recording, "--out", folder / "replay",
                             "--hash-log"], capture_output=True, text=True)
    assert replay.returncode == 0, replay.stderr
    again = [line for line in replay.stdout.splitlines() if line.startswith("tick")]
    # The window was killed: the last lines of its log may be missing or cut.
    common = min(len(live) - 1, len(again))
    assert live[:common] == again[:common], "the replay's hashes differ"
    seen = documents("\n".join(again[:common]) + "\n")
    assert len(set(seen)) > 3 and seen[-1] == seen[0], "the drag moved the knot step by step, and undo put it back"
    print(f"{common} ticks replayed to the same hashes; {len(set(seen))} documents on the way")
    return 0


if __name__ == "__main__":
    sys.exit(main())
