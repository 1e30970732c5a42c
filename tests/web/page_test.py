#!/usr/bin/python3
"""What a person does with the page, by mouse and keyboard alone: PAGE_FOLDER SOURCE_FOLDER."""
import base64
import gzip
import json
import os
import pathlib
import random
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
    def setUp(self):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.page = browser.open_browser(profile=self.profile.name)
        self.page.execute_cdp_cmd("Browser.grantPermissions", {"permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"]})

    def tearDown(self):
        self.assertEqual(browser.complaints(self.page), self.expected())
        self.page.quit()
        self.profile.cleanup()

    def expected(self):
        return []

    # What a hand does.
    def open(self, fragment=""):
        self.page.get("about:blank")
        self.page.get(ADDRESS + "/index.html" + fragment)
        self.until(lambda: self.js("said.hidden"), "the program has started")
        self.frames(4)

    def js(self, text, *arguments):
        return self.page.execute_script("return " + text, *arguments)

    def until(self, holds, what, longest=30):
        end = time.monotonic() + longest
        while not holds():
            self.assertLess(time.monotonic(), end, f"not in {longest} s: {what}")
            time.sleep(0.05)

    def frames(self, count):
        self.page.execute_async_script(
            "const done = arguments[1]; let left = arguments[0]; const next = () => left-- > 0 ? requestAnimationFrame(next) : done(); next();", count)

    def key(self, key, modifiers=0, code=None, text=None):
        virtual = {"Enter": 13, "Escape": 27, " ": 32}.get(key, ord(key.upper()) if len(key) == 1 else 0)
        event = {"key": key, "code": code or ("Key" + key.upper() if key.isalpha() and len(key) == 1 else key),
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
            self.key(letter, code="Space" if letter == " " else None)
        self.key("Enter")
        self.frames(4)

    # What it finds.
    def title(self):
        return self.page.title

    def link(self):
        """Shares the track and returns what is on the clipboard: it holds the document's hash."""
        self.key("l", CTRL | SHIFT)
        self.frames(4)
        return self.page.execute_async_script("const done = arguments[0]; navigator.clipboard.readText().then(done, (why) => done('' + why));")

    def test_a_track_built_here_is_there_after_a_reload(self):
        self.open()
        self.key("Escape")
        self.command("new")
        self.command("element straight length 30 equipment station")
        self.command("element climb height 20")
        self.command("element dive height 18")
        self.command("complete")
        self.until(lambda: self.title() == "Untitled* - coaster", "the title tells of changes: " + self.title())
        before = document_of(self.link())
        self.until(lambda: self.js("Module.FS.analyzePath(arguments[0]).exists && Module.FS.readdir(arguments[0]).length > 2",
                                   "/home/coaster/.local/state/coaster/recovery"), "the autosave", 60)
        time.sleep(3)  # for the browser's store
        self.open()
        self.frames(4)
        for y in range(int(0.4 * self.js("innerHeight")), int(0.7 * self.js("innerHeight")), 12):  # where "Recover" is
            if self.title() == "Red Comet - coaster":
                self.click(self.js("innerWidth") / 2 - 195, y)
        self.until(lambda: self.title() == "Untitled* - coaster", "the recovered track: " + self.title())
        self.assertEqual(document_of(self.link()), before)

    def test_a_second_tab_keeps_nothing_and_says_so(self):
        self.open()
        first = self.page.current_window_handle
        self.page.switch_to.new_window("tab")
        self.open()
        self.assertIn("open in another tab", self.js("document.getElementById('note').innerText"))
        self.key("Escape")
        self.command("element straight length 40")
        time.sleep(7)  # longer than until an autosave
        self.page.close()
        self.page.switch_to.window(first)
        self.open()
        self.assertEqual(self.js("document.getElementById('note').hidden"), True)
        self.assertFalse(self.js("Module.FS.analyzePath(arguments[0]).exists", "/home/coaster/.local/state/coaster/recovery/42-1.info.json"))

    def test_a_link_is_the_track(self):
        self.open()
        self.key("Escape")
        link = self.link()
        self.assertTrue(link.startswith(ADDRESS + "/index.html#coaster=1."), link[:80])
        self.command("new")
        self.assertNotEqual(document_of(self.link()), document_of(link))
        self.page.execute_async_script("navigator.clipboard.writeText(arguments[0]).then(arguments[1]);", link)
        self.key("v", CTRL)
        self.until(lambda: self.title() == "Red Comet - coaster", "the pasted track: " + self.title())
        self.assertEqual(document_of(self.link()), document_of(link))
        self.open(link[link.index("#"):])
        self.key("Escape")
        self.assertEqual(self.link(), link)
        self.open("#coaster=1.damaged")
        self.frames(10)
        self.assertEqual(self.title(), "Red Comet - coaster")
        self.assertTrue(self.js("said.hidden"), "a bad link is refused, and the program goes on")

    def test_fingers_orbit_pan_and_zoom(self):
        self.page.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 2})
        self.open()
        self.key("Escape")

        def touch(kind, *points):
            fingers = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]
            self.page.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": fingers})
            if kind == "touchEnd":
                self.frames(8)
        views = [shared_in(self.link())]
        touch("touchStart", (800, 90))
        touch("touchMove", (760, 100))
        touch("touchMove", (700, 120))
        touch("touchEnd")
        views.append(shared_in(self.link()))
        touch("touchStart", (600, 200), (700, 200))
        touch("touchMove", (580, 220), (740, 220))
        touch("touchMove", (560, 240), (780, 240))
        touch("touchEnd")
        views.append(shared_in(self.link()))
        self.assertNotEqual(views[0]["yaw"], views[1]["yaw"])
        self.assertEqual(views[0]["distance"], views[1]["distance"])
        self.assertLess(views[2]["distance"], 0.8 * views[1]["distance"], "wider by 2.2")
        self.assertNotEqual(views[2]["target"], views[1]["target"])
        self.assertEqual(views[0]["hash"], views[2]["hash"], "the track is as it was")

    def test_files_come_in_and_go_out(self):
        self.open()
        self.key("Escape")
        track = pathlib.Path(SOURCE, "tracks/helix.json")
        self.js("void (window.chosen = null, HTMLInputElement.prototype.click = function () { window.chosen = this; document.body.append(this); })")
        self.page.execute_script("Module.coasterPick()")
        self.page.find_element("css selector", "input[type=file]").send_keys(str(track))
        self.until(lambda: self.js("Module.coasterPicked()") == "/tmp/opened/helix.json", "the chosen file")
        self.page.execute_script("openFile(Module.coasterPicked())")
        self.until(lambda: self.title() == "Silver Spiral - coaster", "the file's name: " + self.title())
        self.page.execute_script("window.sent = []; HTMLAnchorElement.prototype.click = function () { sent.push(this.download); };")
        self.command('save "/home/coaster/mine.json"')
        self.until(lambda: self.js("sent.join()") == "mine.json", "the download: " + self.js("sent.join()"))

    def test_it_works_without_a_network_after_the_first_visit(self):
        self.open()
        self.until(lambda: self.page.execute_async_script(
            "const done = arguments[0]; navigator.serviceWorker.ready.then(() => caches.keys()).then((all) => done(all.length === 1));"), "the worker")
        self.page.execute_cdp_cmd("Network.enable", {})
        self.page.execute_cdp_cmd("Network.emulateNetworkConditions", {"offline": True, "latency": 0, "downloadThroughput": 0, "uploadThroughput": 0})
        self.open()
        self.assertEqual(self.title(), "Red Comet - coaster")

    def test_a_lost_context_is_told(self):
        self.open()
        self.page.execute_script("canvas.getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()")
        self.until(lambda: self.js("said.textContent").startswith("The display is gone."), "what it says: " + self.js("said.textContent"))
        self.assertEqual(len(browser.complaints(self.page)), 1)

    def test_it_is_small(self):
        names = ["index.html", "page.js", "worker.js", "coaster.js", "coaster.wasm", "coaster.data"]
        sent = sum(len(gzip.compress(pathlib.Path(FOLDER, name).read_bytes(), 9)) for name in names)
        self.open()
        memory = self.js("Module.HEAPU8.length + performance.memory.usedJSHeapSize")
        print(f"{sent} bytes with gzip, {memory / 1e6:.0f} MB of memory", file=sys.stderr)
        self.assertLess(sent, 1.8e6)
        self.assertLess(memory, 200e6)

    def test_random_input_breaks_nothing(self):
        self.open()
        self.key("Escape")
        rng = random.Random(20261123)
        keys = "abcdefghijklmnoprstuvwxyz0123456789 "
        end = time.monotonic() + float(os.environ.get("RANDOM_SECONDS", "20"))
        while time.monotonic() < end:
            if rng.random() < 0.5:
                self.click(rng.randrange(1024), rng.randrange(600))
            else:
                self.key(rng.choice(keys), CTRL if rng.random() < 0.1 and rng.random() < 0.5 else 0)
        self.assertTrue(self.js("said.hidden"), self.js("said.textContent"))


if __name__ == "__main__":
    FOLDER, SOURCE = sys.argv[1:3]
    ADDRESS = browser.serve(FOLDER)
    unittest.main(argv=[sys.argv[0]] + sys.argv[3:], verbosity=2)
