"""Keys of a real keyboard in seven layouts, one after the other while the program runs: letters go by what is printed
on the key, digits by the row of digits, and AltGr makes text.

Usage: keys_test.py COASTER FOLDER. Exit status 77 (skipped) when Xvfb, xdotool or setxkbmap is missing.
"""
import ctypes
import pathlib
import re
import subprocess
import sys

from drag_test import TRACK
from window import Window, need, wait_for

ONE, ENTER, KEYPAD_ENTER, CTRL, SHIFT, ALT_GR, MENU = 10, 36, 104, 37, 50, 108, 135  # X's codes of the keys' places
US = {"a": 38, "e": 26, "g": 42, "m": 58, "n": 57, "p": 33, "y": 29, "z": 52, " ": 65}
# Where each layout has its letters, and how it types what the field gets.
LAYOUTS = {
    "us": (US, "@", (SHIFT, 11)),
    "de": ({**US, "y": 52, "z": 29}, "@", (ALT_GR, 24)),
    "fr": ({**US, "a": 24, "z": 25}, "@", (ALT_GR, 19)),
    "es": (US, "@", (ALT_GR, 11)),
    "ru": (US, "ы", (39,)),
    "gr": (US, "@", (SHIFT, 11)),
    "dvorak": ({"a": 38, "g": 30, "y": 28, "z": 61, "p": 27}, "@", (SHIFT, 11)),
}


class Keyboard:
    """Keys by their codes: xdotool would switch to the first layout for each."""

    def __init__(self, window):
        self.window = window
        try:
            x11, self.test = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        except OSError as error:
            print(f"skipped: {error}")
            raise SystemExit(77) from error
        x11.XOpenDisplay.restype = ctypes.c_void_p
        self.display = ctypes.c_void_p(x11.XOpenDisplay(window.environment["DISPLAY"].encode()))
        self.flush = x11.XFlush

    def layouts(self, name):
        """Gives the keyboard the US layout and another one. The key Menu switches between them: for keys that come
        before it the program sees the layout that they were pressed in, even if it sees them later."""
        layout, variant = ("us", "dvorak") if name == "dvorak" else (name, "")
        subprocess.run(["setxkbmap", "us," + layout, "-variant", "," + variant, "-option", "", "-option",
                        "grp:menu_toggle"], check=True, env=self.window.environment, stderr=subprocess.DEVNULL)

    def press(self, *chords):
        """Presses keys one after the other; of a chord all but the last are held."""
        for chord in chords:
            keys = chord if isinstance(chord, tuple) else (chord,)
            for down in (1, 0):
                for key in keys if down else reversed(keys):
                    self.test.XTestFakeKeyEvent(self.display, key, down, 0)
        self.flush(self.display)

    def until(self, what, pattern, *chords):
        """Presses keys and waits until the rest of the recording has a line; returns all lines since."""
        before = len(self.window.recorded())
        self.press(*chords)

        def found():
            return re.search(pattern, self.window.recorded()[before:], re.M)

        try:
            wait_for(what, found, 20)
        except SystemExit as error:
            raise SystemExit(f"{error}:\n{self.window.recorded()[before:]}") from error
        return self.window.recorded()[before:]


def check(keyboard, name):
    letters, text, typed = LAYOUTS[name]
    keyboard.layouts(name)
    keyboard.until(f"{name}: Ctrl+A", r"^select_knots all", MENU, (CTRL, letters["a"]))
    moved = keyboard.until(f"{name}: G Y 1", r"^gesture\.end", letters["g"], letters["y"],
                           (SHIFT, ONE) if name == "fr" else ONE, KEYPAD_ENTER)
    assert re.search(r"^translate \S+ by 0 1 0 ", moved, re.M), f"{name}: moved elsewhere:\n{moved}"
    keyboard.until(f"{name}: Ctrl+Z", r"^undo$", (CTRL, letters["z"]))
    for number, camera in ((4, "fly"), (1, "orbit")):
        keyboard.until(f"{name}: digit {number}", rf"camera\S* {camera}|^camera\.mode {camera}", ONE + number - 1)
    # A field of text that opens in the US layout, typed into in this one.
    in_us = [MENU, (CTRL, US["p"]), *(US[c] for c in "name ")]
    named = keyboard.until(f"{name}: a name", r"^name .*$", *in_us, MENU, typed, ENTER, MENU)
    assert re.search(rf'^name "?{text}"?$', named, re.M), f"{name}: expected {text}:\n{named}"


def main():
    coaster, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    need("Xvfb", "xdotool", "setxkbmap")
    track = folder / "line.json"
    with Window(coaster, folder, track, files={track.name: TRACK}) as window:
        keyboard = Keyboard(window)
        wait_for("the keyboard's focus", lambda: "coaster" in window.xdo("getwindowfocus", "getwindowname"))
        wait_for("the start", lambda: "append_mode" in window.recorded())
        for name in LAYOUTS:
            check(keyboard, name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
