"""A real mouse that rests on "Show me" clicks through the first lessons: each click goes to the button, although the
lesson's own clicks move the program's pointer.

Usage: lesson_test.py COASTER FOLDER. Exit status 77 (skipped) when Xvfb or xdotool is missing.
"""
import pathlib
import re
import sys

from window import Window, need, wait_for

TUTORIAL, SHOW_ME = (183, 310), (848, 61)  # px, in a window of 1280x720: on the start screen, on the card
# What a lesson adds to the recording.
PLACED = r"^element straight .*equipment station"
LESSONS = [r"^camera ", r"^element\.choose straight .*equipment station", PLACED]


def main():
    coaster, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    need("Xvfb", "xdotool")
    with Window(coaster, folder) as window:
        xdo, recorded = window.xdo, window.recorded

        def click(place):
            xdo("mousemove", *place)
            xdo("click", 1)

        def until(what, condition, act, seconds):
            """Acts until the condition holds; returns its value. Clicks before the card shows have no effect."""
            for _ in range(40):
                act()
                try:
                    return wait_for(what, condition, seconds)
                except SystemExit:
                    pass
            raise SystemExit(f"no {what}:\n{recorded()}")

        wait_for("the first frames", lambda: "ticks" in recorded())
        until("the first lesson", lambda: "yaw 35 pitch 18 distance 80\n" in recorded(), lambda: click(TUTORIAL), 5)
        xdo("mousemove", *SHOW_ME)
        at = len(recorded())
        for number, line in enumerate(LESSONS, 1):
            done = until(f"lesson {number}", lambda: re.compile(line, re.M).search(recorded(), at),
                         lambda: xdo("click", 1), 1.5)
            at = done.end()
        before = recorded()[:re.search(PLACED, recorded(), re.M).start()]
        chosen = len(re.findall(r"^element\.choose straight ", before, re.M))
        assert chosen == 1, f"lessons that nobody left chose {chosen} elements instead of 1:\n{recorded()}"
        for word in ("append", "move", "select"):
            assert not re.search(rf"^{word} ", recorded(), re.M), f"a click went through the card:\n{recorded()}"
    return 0


if __name__ == "__main__":
    sys.exit(main())
