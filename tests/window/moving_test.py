"""While a train rides, the picture moves: keys choose cameras, and the mouse rests or moves now and then.

Usage: moving_test.py COASTER FOLDER [MINUTES]. Exit status 77 (skipped) when Xvfb or xdotool is missing. The longest
time without a new picture is at most 5 s; it is printed.
"""
import pathlib
import random
import sys
import time
import zlib

from window import Window, need, wait_for

LONGEST = 5  # s
CAMERAS = "123"  # orbit, ride and chase


def main():
    coaster, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    minutes = float(sys.argv[3]) if len(sys.argv) > 3 else 0.12
    track = pathlib.Path(__file__).resolve().parents[2] / "tracks" / "gentle.json"
    need("Xvfb", "xdotool")
    draw = random.Random(7)
    with Window(coaster, folder, track, size="480x270") as window:
        wait_for("the start", lambda: "camera target" in window.recorded())
        window.xdo("key", "space")
        wait_for("the ride", lambda: "ride.start" in window.recorded())
        worst, keys, end = 0, 0, time.monotonic() + 60 * minutes
        last, since, next_key = None, time.monotonic(), 0
        while time.monotonic() < end:
            time.sleep(0.1)
            shown, now = zlib.crc32(window.screen.read_bytes()), time.monotonic()
            worst = max(worst, now - since)
            if shown != last:
                last, since = shown, now
            if worst > LONGEST:
                raise SystemExit(f"the picture has been still for {worst:.1f} s after key {key}")
            if now > next_key:
                key = draw.choice(CAMERAS)
                if draw.random() < 0.5:
                    window.xdo("mousemove", draw.randrange(480), draw.randrange(270))
                window.xdo("key", key)
                keys, next_key = keys + 1, now + draw.uniform(1, 3) * max(1, minutes ** 0.5)
        print(f"longest time without a new picture: {worst:.2f} s, {keys} keys")
    return 0


if __name__ == "__main__":
    sys.exit(main())
