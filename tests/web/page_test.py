#!/usr/bin/python3
"""Building, sharing, files, fingers and random input in the page: PAGE_FOLDER SOURCE_FOLDER [CLASS.TEST...]."""
import os
import random
import time

from page import CTRL, Page, document_of, main, shared_in, source


class Hands(Page):
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

    def test_a_link_is_the_track(self):
        self.open()
        self.key("Escape")
        link = self.link()
        self.assertTrue(link.startswith(self.address + "/index.html#coaster=1."), link[:80])
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
        views = [shared_in(self.link())]
        self.touch("touchStart", (800, 90))
        self.touch("touchMove", (760, 100))
        self.touch("touchMove", (700, 120))
        self.touch("touchEnd")
        views.append(shared_in(self.link()))
        self.touch("touchStart", (600, 200), (700, 200))
        self.touch("touchMove", (580, 220), (740, 220))
        self.touch("touchMove", (560, 240), (780, 240))
        self.touch("touchEnd")
        views.append(shared_in(self.link()))
        self.assertNotEqual(views[0]["yaw"], views[1]["yaw"])
        self.assertEqual(views[0]["distance"], views[1]["distance"])
        self.assertLess(views[2]["distance"], 0.8 * views[1]["distance"], "wider by 2.2")
        self.assertNotEqual(views[2]["target"], views[1]["target"])
        self.assertEqual(views[0]["hash"], views[2]["hash"], "the track is as it was")

    def test_the_touch_keyboard_types(self):
        self.page.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 1})
        self.open()
        self.key("Escape")
        focused = lambda: self.js("document.activeElement.id")
        self.touch("touchStart", (800, 90))
        self.touch("touchEnd")
        self.assertEqual(focused(), "canvas", "nothing takes text")
        self.key("p", CTRL)
        self.until(lambda: focused() == "typed", "the field that shows the keyboard")
        # As keyboards on screens do: words replace what was composed, without keys.
        self.page.execute_cdp_cmd("Input.imeSetComposition", {"text": "nex", "selectionStart": 3, "selectionEnd": 3})
        self.page.execute_cdp_cmd("Input.insertText", {"text": "new"})
        self.frames(8)
        self.key("Enter")
        self.until(lambda: self.title() == "Untitled - coaster", "the command: " + self.title())
        self.until(lambda: focused() == "canvas", "the keyboard goes")

    def test_a_key_fills_the_screen(self):
        self.open()
        self.key("Escape")
        for full in (True, False):
            self.key("F11")
            self.until(lambda: self.js("document.fullscreenElement !== null") == full, f"full screen: {full}")

    def test_files_come_in_and_go_out(self):
        self.open()
        self.key("Escape")
        track = source("tracks/helix.json")
        self.js("void (window.chosen = null, HTMLInputElement.prototype.click = function () { window.chosen = this; document.body.append(this); })")
        self.page.execute_script("Module.coasterPick()")
        self.page.find_element("css selector", "input[type=file]").send_keys(str(track))
        self.until(lambda: self.js("Module.coasterPicked()") == "/tmp/opened/helix.json", "the chosen file")
        self.page.execute_script("openFile(Module.coasterPicked())")
        self.until(lambda: self.title() == "Silver Spiral - coaster", "the file's name: " + self.title())
        self.page.execute_script("window.sent = []; HTMLAnchorElement.prototype.click = function () { sent.push(this.download); };")
        self.command('save "/home/coaster/mine.json"')
        self.until(lambda: self.js("sent.join()") == "mine.json", "the download: " + self.js("sent.join()"))

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
    main()
