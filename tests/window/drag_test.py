"""A real window under Xvfb: a real mouse drags a knot, a real key undoes it; what was recorded replays headless to the same hashes.

Usage: drag_test.py COASTER FOLDER. Exit status 77 (skipped) when Xvfb or xdotool is missing.
"""
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

KNOT = '{"id": "k%d", "position": [%g, 10, 0], "tangent": [1, 0, 0], "up": [0, 1, 0], "in": 6, "out": 6, "joint": "smooth"}'
TRACK = """{"format": "coaster-track", "version": 1, "name": "Line", "closed": false, "start_speed": 5, "datum": 0,
"knots": [%s],
"segments": [{"id": "s1", "from": "k1", "to": "k2", "turns": 0}, {"id": "s2", "from": "k2", "to": "k3", "turns": 0}],
"carts": [{"id": "c1", "segment": "s1", "fraction": 0}]}
""" % ", ".join(KNOT % (i + 1, x) for i, x in enumerate((-20, 0, 20)))


def wait_for(what, condition, seconds=60):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.05)
    raise SystemExit(f"waited {seconds} s in vain for {what}")


def documents(log):
    """The document's hash of each whole line of a log of ticks."""
    return [line.split()[3] for line in log.split("\n")[:-1] if line.startswith("tick")]


def start_display():
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x720x24", "-nolisten", "tcp"],
                              pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    number = os.read(read, 16).decode().strip()
    if not number:
        raise SystemExit("Xvfb did not start")
    return server, ":" + number


def pixel_of(point, recording):
    """Where the 1280x720 window shows a point, by the camera that the recording starts with; the panels are hidden."""
    camera = re.search(r"^camera target (\S+) (\S+) (\S+) yaw (\S+) pitch (\S+) distance (\S+)", recording, re.M)
    *target, yaw, pitch, distance = map(float, camera.groups())
    yaw, pitch = math.radians(yaw), math.radians(pitch)
    back = (math.sin(yaw) * math.cos(pitch), math.sin(pitch), math.cos(yaw) * math.cos(pitch))
    right = (math.cos(yaw), 0, -math.sin(yaw))
    up = (back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2], back[0] * right[1] - back[1] * right[0])
    offset = [a - b for a, b in zip(point, target)]
    x, y, z = (sum(a * b for a, b in zip(offset, axis)) for axis in (right, up, back))
    left, top, width, height = 0, 0, 1280, 720
    scale = height / 2 / math.tan(math.radians(22.5)) / (distance - z)
    return round(left + width / 2 + x * scale), round(top + height / 2 - y * scale)


def main():
    coaster, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    for tool in ("Xvfb", "xdotool"):
        if not shutil.which(tool):
            print(f"skipped: {tool} is not installed")
            return 77
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    track, recording = folder / "line.json", folder / "recording.coaster"
    track.write_text(TRACK)
    server, display = start_display()
    environment = {**os.environ, "DISPLAY": display}
    environment.pop("WAYLAND_DISPLAY", None)
    environment.pop("GALLIVM_PERF", None)  # large pictures, and many: shaders are better compiled well
    log = open(folder / "log.txt", "w")
    program = subprocess.Popen([coaster, str(track), "--record", str(recording), "--hash-log", "--size", "1280x720",
                                "--config", str(folder / "config")],
                               env=environment, stdout=log, stderr=subprocess.STDOUT)

    def xdo(*arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=environment, check=True)
        # However slow the machine, some frames see it before the next thing happens: each writes its ticks to the log.
        for _ in range(3):
            size = (folder / "log.txt").stat().st_size
            wait_for("a frame", lambda: (folder / "log.txt").stat().st_size > size)

    def recorded():
        return recording.read_text() if recording.exists() else ""

    try:
        wait_for("the window", lambda: subprocess.run(["xdotool", "search", "--name", "coaster"], env=environment,
                                                      capture_output=True, text=True).stdout.strip())
        wait_for("the first frames", lambda: "ticks" in recorded() or (folder / "log.txt").stat().st_size > 0)
        # Keys that come before go to no window.
        wait_for("the keyboard's focus", lambda: "coaster" in subprocess.run(
            ["xdotool", "getwindowfocus", "getwindowname"], env=environment, capture_output=True, text=True).stdout)
        xdo("key", "Tab")
        wait_for("the panels to be hidden", lambda: "panels off" in recorded())
        xdo("mousemove", *pixel_of((0, 10, 0), wait_for("the camera", lambda: re.search(r"^camera .*\n", recorded(), re.M) and recorded())))
        xdo("mousedown", 1)
        for _ in range(6):
            xdo("mousemove_relative", "--", 2, -9)
        xdo("mouseup", 1)
        wait_for("the drag to be recorded", lambda: re.search(r"^gesture\.begin[\s\S]*move @k2 to [\s\S]*gesture\.end", recorded(), re.M))
        xdo("key", "space")
        wait_for("the ride to start", lambda: "ride.start" in recorded())
        xdo("key", "ctrl+z")
        wait_for("the undo to be recorded", lambda: re.search(r"^undo", recorded(), re.M))
        wait_for("the knot to be back", lambda: (d := documents((folder / "log.txt").read_text())) and len(d) > 3 and d[-1] == d[-3] == d[0])
        program.send_signal(signal.SIGTERM)
        program.wait(30)
    except SystemExit:
        print("the program", "runs" if program.poll() is None else f"has ended with {program.returncode}", (folder / "log.txt").read_text()[-300:])
        raise
    finally:
        program.kill()
        server.terminate()
    log.close()
    live = [line for line in (folder / "log.txt").read_text().splitlines() if line.startswith("tick")]
    replay = subprocess.run([coaster, "--headless", "--script", str(recording), "--out", str(folder / "replay"), "--hash-log"],
                            capture_output=True, text=True)
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
