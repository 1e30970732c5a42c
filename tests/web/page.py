"""What a person does with the page, by mouse, keyboard and fingers alone. For the tests of the page."""
import base64
import json
import pathlib
import sys
import tempfile
import time
import unittest
import zlib

import browser

CTRL, SHIFT = 2, 8


def shared_in(link):
    """Returns what the first line of a link's text says: the document's hash and the view (docs/share.md)."""
    packed = link[link.index("#coaster=1.") + len("#coaster=1."):]
    text = zlib.decompress(base64.urlsafe_b64decode(packed + "=" * (-len(packed) % 4)), -15).decode()
    return json.loads(text.split("\n")[0])


def document_of(link):
    return shared_in(link)["hash"]


class Page(unittest.TestCase):
    """A test with a page of its own, of one size, in a browser that keeps nothing from others. A page of the same size has
    a quarter of the pixels, so that frames are fast without a graphics card."""
    width, height = 1024, 720

    def setUp(self):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.page = browser.open_browser(self.width, self.height, self.profile.name)
        self.page.set_script_timeout(240)
        self.small(self.width, self.height)
        folder = pathlib.Path(sys.argv[1])
        self.address = f"{browser.serve(folder.parent)}/{folder.name}"  # not at the root of its host
        self.page.execute_cdp_cmd("Browser.grantPermissions", {"permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"]})

    def tearDown(self):
        self.assertEqual(browser.complaints(self.page), self.expected())
        self.page.quit()
        self.profile.cleanup()

    def expected(self):
        return []

    def small(self, width, height, ratio=0.5):
        """Gives the page a size, and `ratio` pixels of the screen to a pixel of the page."""
        self.page.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": height, "deviceScaleFactor": ratio, "mobile": False})

    def before_load(self, script):
        self.page.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": script})

    def without_drawing(self):
        """Leaves the pictures out: a software renderer takes most of a frame's time, and a long ride needs none."""
        self.page.execute_script("const gl = canvas.getContext('webgl2'); for (const draw of ['drawElements', 'drawArrays', 'drawElementsInstanced',"
                                 "'drawArraysInstanced']) gl[draw] = () => {};")

    # What a hand does.
    def open(self, fragment=""):
        self.page.get("about:blank")
        self.page.get(self.address + "/index.html" + fragment)
        self.until(lambda: self.js("said.hidden"), "the program has started")
        self.frames(4)

    def js(self, text, *arguments):
        return self.page.execute_script("return " + text, *arguments)

    def until(self, holds, what, longest=240):
        """Waits for a condition. `what` may be a function: what is found instead."""
        end = time.monotonic() + longest
        while not holds():
            if time.monotonic() > end:
                self.fail(f"not in {longest} s: {what() if callable(what) else what}")
            time.sleep(0.05)

    def until_titled(self, title):
        self.until(lambda: self.title() == title, lambda: f"the title {title}; it is {self.title()}")

    def frames(self, count):
        for begun in range(0, count, 4):  # each call has a time limit
            self.page.execute_async_script(
                "const done = arguments[1]; let left = arguments[0]; const next = () => left-- > 0 ? requestAnimationFrame(next) : done(); next();",
                min(4, count - begun))

    def key(self, key, modifiers=0, code=None, text=None):
        virtual = {"Enter": 13, "Escape": 27, " ": 32}.get(key, ord(key.upper()) if len(key) == 1 else 0)
        event = {"key": key, "code": code or ("Key" + key.upper() if key.isalpha() and len(key) == 1 else "Space" if key == " " else key),
                 "modifiers": modifiers, "windowsVirtualKeyCode": virtual}
        text = text if text is not None else (key if len(key) == 1 and not modifiers & CTRL else "")
        commands = {"commands": ["paste"]} if key == "v" and modifiers & CTRL else {}
        self.page.execute_cdp_cmd("Input.dispatchKeyEvent", {"type": "keyDown", "text": text, **event, **commands})
        self.frames(2)
        self.page.execute_cdp_cmd("Input.dispatchKeyEvent", {"type": "keyUp", **event})
        self.frames(1)

    def mouse(self, kind, x, y, buttons=0):
        self.page.execute_cdp_cmd("Input.dispatchMouseEvent", {"type": kind, "x": x, "y": y, "button": "left" if kind != "mouseMoved" else "none",
                                                               "buttons": buttons, "clickCount": 0 if kind == "mouseMoved" else 1})
        self.frames(2)

    def click(self, x, y):
        self.mouse("mouseMoved", x, y)
        self.mouse("mousePressed", x, y, 1)
        self.mouse("mouseReleased", x, y)

    def command(self, line):
        """Types a line into the command palette."""
        self.key("p", CTRL)
        self.frames(2)
        for letter in line:
            for kind in ("keyDown", "keyUp"):
                self.page.execute_cdp_cmd("Input.dispatchKeyEvent", {"type": kind, "key": letter, "text": letter if kind == "keyDown" else ""})
        self.frames(2)
        self.key("Enter")
        self.frames(3)

    def press(self, widget):
        """Clicks a widget, named by its label path as in scripts."""
        self.click(*self.place_of(widget))

    # The browser moves and lifts the finger by itself: on a busy machine the tests would be too slow, and the press
    # long.
    def swipe(self, x, y, dx, dy):
        self.page.execute_cdp_cmd("Input.synthesizeScrollGesture", {"x": x, "y": y, "xDistance": dx, "yDistance": dy, "preventFling": True,
                                                                    "gestureSourceType": "touch"})
        self.frames(8)

    def tap(self, widget):
        """Taps a widget, named by its label path as in scripts."""
        x, y = self.place_of(widget)
        self.page.execute_cdp_cmd("Input.synthesizeTapGesture", {"x": round(x), "y": round(y), "duration": 50, "gestureSourceType": "touch"})
        self.frames(8)

    def touch(self, kind, *points):
        fingers = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]
        self.page.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": fingers})
        if kind == "touchEnd":
            self.frames(8)

    # What it finds.
    def value(self, question):
        """Returns the value of a query, or the place of "widget PATH" (app/script_host.h)."""
        return self.js("Module.ccall('coaster_answer', 'string', ['string'], [arguments[0]])", question)

    def place_of(self, widget):
        """Returns the middle of a widget once it can be used, in pixels of the page."""
        self.until(lambda: self.value("widget " + widget) != "", "the widget " + widget)
        ratio = self.js("devicePixelRatio")
        return [float(at) / ratio for at in self.value("widget " + widget).split()]

    def stored(self):
        """Returns the files that the browser stores for the next visit: names and texts."""
        return self.page.execute_async_script(
            "const done = arguments[0], asked = indexedDB.open('/home/coaster'); asked.onsuccess = () => {"
            "const all = {}, files = asked.result.transaction('FILE_DATA', 'readonly').objectStore('FILE_DATA').openCursor();"
            "files.onsuccess = () => { const file = files.result; if (!file) { asked.result.close(); return void done(all); }"
            "all[file.key] = file.value.contents ? new TextDecoder().decode(file.value.contents) : ''; file.continue(); }; };")

    def stores(self, document):
        """Whether the browser stores an autosave of this document."""
        return any(f'"{document}"' in text for name, text in self.stored().items() if name.endswith(".info.json"))

    def title(self):
        return self.page.title

    def link(self):
        """Shares the track and returns what is on the clipboard: it holds the document's hash."""
        self.key("l", CTRL | SHIFT)
        self.frames(4)
        return self.page.execute_async_script("const done = arguments[0]; navigator.clipboard.readText().then(done, (why) => done('' + why));")


def main():
    """Runs the tests of a file: PAGE_FOLDER SOURCE_FOLDER [CLASS.TEST...]."""
    unittest.main(argv=[sys.argv[0]] + sys.argv[3:], verbosity=2)


def source(name):
    """Returns the path of a file of the project."""
    return pathlib.Path(sys.argv[2], name)
