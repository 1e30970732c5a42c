"""What a person does with the page, only by mouse, keyboard and fingers. For the tests of the page."""
import base64
import json
import pathlib
import sys
import tempfile
import time
import unittest
import zlib

import browser

CTRL, COMMAND, SHIFT = 2, 4, 8
LINK_START = "#coaster=1."

# Every frame lasts `step` ms of the page's time, however slow the machine. A quarter of a second is the longest that a
# frame makes up for.
FIXED_STEPS = """
window.step = 250;
let time = performance.now();
performance.now = () => time;
const next = () => {
  time += step;
  requestAnimationFrame(next);
};
next();
"""
# Lists downloads instead of starting them: name and address.
CATCH_DOWNLOADS = """
window.downloads = [];
HTMLAnchorElement.prototype.click = function () { downloads.push([this.download, this.href]); };
"""
# Resolves to the drawing context of a canvas that shows the picture at an address.
DRAWN = """
const drawn = async (address) => {
  const image = new Image();
  image.src = address;
  await image.decode();
  const brush = new OffscreenCanvas(image.width, image.height).getContext('2d');
  brush.drawImage(image, 0, 0);
  return brush;
};
"""
WITHOUT_DRAWING = """
const gl = canvas.getContext('webgl2');
for (const draw of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']) gl[draw] = () => {};
"""
NEXT_FRAMES = """
let [left, done] = arguments;
const next = () => left-- > 0 ? requestAnimationFrame(next) : done();
next();
"""
STORED = """
const [done] = arguments;
const opening = indexedDB.open('/home/coaster');
opening.onsuccess = () => {
  const files = {};
  const cursor = opening.result.transaction('FILE_DATA', 'readonly').objectStore('FILE_DATA').openCursor();
  cursor.onsuccess = () => {
    const file = cursor.result;
    if (!file) {
      opening.result.close();
      return void done(files);
    }
    files[file.key] = file.value.contents ? new TextDecoder().decode(file.value.contents) : '';
    file.continue();
  };
};
"""


def shared_in(link):
    """Returns the first line of a link's text: the document's hash and the view (docs/share.md)."""
    packed = link[link.index(LINK_START) + len(LINK_START):]
    text = zlib.decompress(base64.urlsafe_b64decode(packed + "=" * (-len(packed) % 4)), -15).decode()
    return json.loads(text.split("\n")[0])


def document_of(link):
    return shared_in(link)["hash"]


def code_of(key):
    """Returns the name of the place on the keyboard where a key is."""
    if key.isalpha() and len(key) == 1:
        return "Key" + key.upper()
    return "Space" if key == " " else key


class Page(unittest.TestCase):
    """A test with its own page, of one size, in its own browser profile.

    The page is drawn with a quarter of its pixels, so that frames are fast without a graphics card.
    """
    width, height = 1024, 720

    def setUp(self):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.page = browser.open_browser(self.width, self.height, self.profile.name)
        self.page.set_script_timeout(240)
        self.small(self.width, self.height)
        folder = pathlib.Path(sys.argv[1])
        self.address = f"{browser.serve(folder.parent)}/{folder.name}"  # not at the root of its host
        self.devtools("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])

    def tearDown(self):
        self.assertEqual(browser.complaints(self.page), [])
        self.page.quit()
        self.profile.cleanup()

    def devtools(self, command, **parameters):
        """Sends a command of the Chrome DevTools Protocol and returns its result."""
        return self.page.execute_cdp_cmd(command, parameters)

    def execute(self, script, *arguments):
        self.page.execute_script(script, *arguments)

    def js(self, expression, *arguments):
        return self.page.execute_script("return " + expression, *arguments)

    def js_async(self, script, *arguments):
        """Runs a script; returns what it passes to its last argument, a function."""
        return self.page.execute_async_script(script, *arguments)

    def before_load(self, script):
        self.devtools("Page.addScriptToEvaluateOnNewDocument", source=script)

    def small(self, width, height, ratio=0.5, mobile=False):
        """Sets the page's size, and the number of screen pixels per page pixel."""
        self.devtools("Emulation.setDeviceMetricsOverride",
                      width=width, height=height, deviceScaleFactor=ratio, mobile=mobile)

    def touch_screen(self, fingers):
        self.devtools("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=fingers)

    def without_drawing(self):
        """Draws nothing: a software renderer takes most of a frame's time, and a long ride needs no pictures."""
        self.execute(WITHOUT_DRAWING)

    # What a hand does.
    def open(self, fragment=""):
        self.page.get("about:blank")
        self.page.get(self.address + "/index.html" + fragment)
        self.until_begun()

    def until_begun(self):
        self.until(lambda: self.js("said.hidden"), "the program has started")
        self.frames(4)

    def open_track(self):
        """Opens the page and closes the start screen."""
        self.open()
        self.key("Escape")

    def until(self, holds, what, longest=240):
        """Waits for a condition. `what` describes it, or is a function that returns what is found instead."""
        end = time.monotonic() + longest
        while not holds():
            if time.monotonic() > end:
                self.fail(f"not in {longest} s: {what() if callable(what) else what}")
            time.sleep(0.05)

    def until_titled(self, title, longest=240):
        self.until(lambda: self.title() == title, lambda: f"the title {title}; it is {self.title()}", longest)

    def until_ridden(self, metres, longest=240):
        self.until(lambda: self.number("ride.travelled") > metres,
                   lambda: f"{metres} m of ride: {self.value('ride.state')} at {self.value('ride.travelled')} m",
                   longest)

    def frames(self, count):
        for begun in range(0, count, 4):  # each call has a time limit
            self.js_async(NEXT_FRAMES, min(4, count - begun))

    def key(self, key, modifiers=0):
        special = {"Enter": 13, "Escape": 27, " ": 32}
        event = {
            "key": key,
            "code": code_of(key),
            "modifiers": modifiers,
            "windowsVirtualKeyCode": special.get(key, ord(key.upper()) if len(key) == 1 else 0),
        }
        text = key if len(key) == 1 and not modifiers & CTRL else ""
        commands = {"commands": ["paste"]} if key == "v" and modifiers & CTRL else {}
        self.devtools("Input.dispatchKeyEvent", type="keyDown", text=text, **event, **commands)
        self.frames(2)
        self.devtools("Input.dispatchKeyEvent", type="keyUp", **event)
        self.frames(1)

    def mouse(self, kind, x, y, buttons=0):
        moves = kind == "mouseMoved"
        self.devtools("Input.dispatchMouseEvent", type=kind, x=x, y=y, buttons=buttons,
                      button="none" if moves else "left", clickCount=0 if moves else 1)
        self.frames(2)

    def click(self, x, y):
        self.mouse("mouseMoved", x, y)
        self.mouse("mousePressed", x, y, 1)
        self.mouse("mouseReleased", x, y)

    def command(self, line):
        """Types a line into the command palette."""
        self.key("p", CTRL)
        self.frames(2)
        self.type(line)
        self.key("Enter")
        self.frames(3)

    def type(self, text):
        for letter in text:
            self.devtools("Input.dispatchKeyEvent", type="keyDown", key=letter, text=letter)
            self.devtools("Input.dispatchKeyEvent", type="keyUp", key=letter, text="")
        self.frames(2)

    def press(self, widget):
        """Clicks a widget, named by its label path as in scripts."""
        self.click(*self.place_of(widget))

    # The browser moves and lifts the finger by itself: on a busy machine the tests would be too slow, and the press
    # long.
    def swipe(self, x, y, dx, dy):
        self.devtools("Input.synthesizeScrollGesture", x=x, y=y, xDistance=dx, yDistance=dy,
                      preventFling=True, gestureSourceType="touch")
        self.frames(8)

    def tap(self, widget):
        """Taps a widget, named by its label path as in scripts."""
        x, y = self.place_of(widget)
        self.devtools("Input.synthesizeTapGesture", x=round(x), y=round(y), duration=50, gestureSourceType="touch")
        self.frames(8)

    def touch(self, kind, *points):
        fingers = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]
        self.devtools("Input.dispatchTouchEvent", type=kind, touchPoints=fingers)
        if kind == "touchEnd":
            self.frames(8)

    # What it finds.
    def value(self, question):
        """Returns the value of a query, or the place of "widget PATH" (app/script_host.h)."""
        return self.js("Module.ccall('coaster_answer', 'string', ['string'], [arguments[0]])", question)

    def number(self, query):
        """Returns the value of a query as a number, 0 if it has none."""
        return float(self.value(query) or 0)

    def place_of(self, widget):
        """Returns the middle of a widget once it can be used, in pixels of the page."""
        self.until(lambda: self.value("widget " + widget) != "", "the widget " + widget)
        ratio = self.js("devicePixelRatio")
        return [float(at) / ratio for at in self.value("widget " + widget).split()]

    def stored(self):
        """Returns the files that the browser stores for the next visit: names and texts."""
        return self.js_async(STORED)

    def stores(self, document):
        """Whether the browser stores an autosave of this document."""
        return any(f'"{document}"' in text for name, text in self.stored().items() if name.endswith(".info.json"))

    def downloads(self):
        """Returns the names and addresses of downloads since CATCH_DOWNLOADS."""
        return self.js("downloads")

    def title(self):
        return self.page.title

    def link(self):
        """Shares the track and returns the link on the clipboard; it holds the document's hash."""
        self.key("l", CTRL | SHIFT)
        self.frames(4)
        return self.js_async("""
            const [done] = arguments;
            navigator.clipboard.readText().then(done, (why) => done('' + why));
        """)

    def document(self):
        """Returns the hash of the open document, by sharing it."""
        return document_of(self.link())


def main():
    """Runs the tests of a file: PAGE_FOLDER SOURCE_FOLDER [CLASS.TEST...]."""
    unittest.main(argv=[sys.argv[0]] + sys.argv[3:], verbosity=2)


def source(name):
    """Returns the path of a file of the project."""
    return pathlib.Path(sys.argv[2], name)
