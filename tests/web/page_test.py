#!/usr/bin/python3
"""Building, sharing, files, fingers and random input in the page: PAGE_FOLDER SOURCE_FOLDER [CLASS.TEST...]."""
import os
import random
import time

from page import CATCH_DOWNLOADS, COMMAND, CTRL, DRAWN, FIXED_STEPS, SHIFT, Page, document_of, main, shared_in, source

# Passes the number of orange pixels in the middle row of a picture, over a sixteenth of its width.
ORANGE = DRAWN + """
const [picture, done] = arguments;
drawn('data:image/png;base64,' + picture).then((brush) => {
  const { width, height } = brush.canvas;
  const side = width / 16;
  const row = brush.getImageData((width - side) / 2, height / 2, side, 1).data;
  let orange = 0;
  for (let i = 0; i < row.length; i += 4) orange += row[i] > 220 && row[i + 1] < 170 && row[i + 2] < 90;
  done(orange);
}, (why) => done(String(why)));
"""
# As in WebKit: only an input may write the clipboard, and timers that begin there.
COPY_DURING_INPUT = """
let answering = false;
const during = (act) => (...words) => {
  const before = answering;
  answering = true;
  try { return act(...words); } finally { answering = before; }
};
const listen = window.addEventListener, timer = window.setTimeout;
window.addEventListener = function (kind, act, ...more) {
  return listen.call(this, kind, /^(pointerup|keydown)$/.test(kind) ? during(act) : act, ...more);
};
window.setTimeout = (act, delay) => timer(answering && delay <= 1000 ? during(act) : act, delay);
if (navigator.clipboard) {
  window.write = navigator.clipboard.writeText.bind(navigator.clipboard);
  navigator.clipboard.writeText = (text) => answering ? write(text) : Promise.reject(new Error('no input'));
}
"""
# As in a page that does not come by https, until the test reads the clipboard.
WITHOUT_CLIPBOARD = """
const later = navigator.clipboard;
Object.defineProperty(Navigator.prototype, 'clipboard', { get: () => window.given && later });
"""
# Opens no dialog for a file: its field stays in the page.
CATCH_FILE_DIALOG = "HTMLInputElement.prototype.click = function () { document.body.append(this); };"


class Hands(Page):
    def test_a_circuit_built_by_hand_is_ridden_and_there_after_a_reload(self):
        self.before_load(FIXED_STEPS)
        self.open()
        self.press("Start/New track")
        for element in ("Straight", "Climb", "Dive", "Curve"):
            self.press("Elements/" + element)
            self.key("Enter")
        self.press("Elements/Complete circuit")
        self.until(lambda: self.number("complete.proposals") > 0, "proposals")
        self.key("Enter")
        self.until(lambda: self.value("closed") == "on", "the circuit")
        self.without_drawing()
        self.key(" ")
        self.until_ridden(100, 500)  # past the lift
        self.until_titled("Untitled* - coaster")
        before = self.document()
        self.until(lambda: self.stores(before),
                   lambda: f"an autosave of {before} in the browser's store: {self.stored()}")
        self.open()
        self.press("Recover")
        self.until_titled("Untitled* - coaster")
        self.assertEqual(self.document(), before)
        self.key(" ")
        self.until(lambda: self.number("ride.distance") > 5, "the ride")

    def test_the_tutorial_waits_and_shows(self):
        self.open()
        self.press("Start/Tutorial")
        self.place_of("Lesson/Show me")
        self.mouse("mouseMoved", 600, 300)
        self.mouse("mousePressed", 600, 300, 1)
        self.mouse("mouseMoved", 660, 300, 1)
        self.mouse("mouseReleased", 660, 300)
        self.until(lambda: self.value("camera_yaw") not in ("", "35"), "the first step, looking around")
        self.press("Elements/Straight")
        self.until(lambda: self.value("element.preview") == "on", "the second step, by hand")
        self.press("Lesson/Show me")
        self.until(lambda: self.number("segments") > 0, "the third step")
        self.press("Elements/Climb")
        self.until(lambda: self.value("element") == "climb", "the fourth step, by hand")
        self.place_of("Lesson/Show me")
        self.press("Lesson/Leave")

    def test_a_link_is_the_track(self):
        self.open_track()
        link = self.link()
        self.assertTrue(link.startswith(self.address + "/index.html#coaster=1."), link[:80])
        self.command("new")
        self.assertNotEqual(self.document(), document_of(link))
        self.js_async("navigator.clipboard.writeText(arguments[0]).then(arguments[1]);", link)
        self.key("v", CTRL)
        self.until_titled("Red Comet - coaster")
        self.assertEqual(self.document(), document_of(link))
        self.open(link[link.index("#"):])
        self.key("Escape")
        self.assertEqual(self.link(), link)
        self.open("#coaster=1.damaged")
        self.frames(10)
        self.assertEqual(self.title(), "Red Comet - coaster")
        self.assertTrue(self.js("said.hidden"), "a bad link is refused, and the program continues")

    def test_a_link_is_copied_by_browsers_that_let_only_an_input_copy(self):
        self.before_load(COPY_DURING_INPUT)
        self.open_track()
        self.assertTrue(self.copied(lambda: self.key("l", CTRL | SHIFT)).startswith(self.address))
        # A copy that no input asked for is taken at the next one, and the page says so.
        def write():
            time.sleep(1.5)  # the timers of the last input have ended
            self.execute("document.getElementById('note').hidden = true; Module.coasterCopy('late')")

        write()
        self.until(lambda: not self.js("document.getElementById('note').hidden"), "the page asks for an input")
        self.assertEqual(self.copied(lambda: self.click(800, 90)), "late")
        # What another program copies meanwhile is left.
        write()
        self.execute("window.dispatchEvent(new Event('blur'))")
        self.assertEqual(self.copied(lambda: self.click(800, 90), 2), "")

    def test_a_link_is_copied_without_https(self):
        self.before_load(WITHOUT_CLIPBOARD)
        self.open_track()
        self.key("l", CTRL | SHIFT)
        self.execute("window.given = true")
        self.until(lambda: self.on_clipboard().startswith(self.address), self.on_clipboard)

    def on_clipboard(self):
        return self.js_async("const [done] = arguments; navigator.clipboard.readText().then(done, done);")

    def copied(self, act, seconds=20):
        """Returns what an act writes to the clipboard; "" for nothing in so many seconds."""
        self.js_async("const [done] = arguments; write('before').then(done, done);")
        act()
        end = time.monotonic() + seconds
        while time.monotonic() < end and self.on_clipboard() == "before":
            time.sleep(0.05)
        return self.on_clipboard().replace("before", "")

    def test_keys_with_command_need_no_release(self):
        """On macOS no release of a key is reported while Command is held."""
        self.open_track()
        self.key("p", CTRL)
        self.type("loops")
        for key, code in (("Meta", "MetaLeft"), ("Backspace", "Backspace")):
            self.devtools("Input.dispatchKeyEvent", type="rawKeyDown", key=key, code=code, modifiers=COMMAND)
            self.frames(2)
        self.devtools("Input.dispatchKeyEvent", type="keyUp", key="Meta", code="MetaLeft")
        self.frames(2)
        self.type("new")
        time.sleep(2)  # a key that seems held would repeat
        self.frames(4)
        self.key("Enter")
        self.until_titled("Untitled - coaster", 30)

    def test_fingers_orbit_pan_and_zoom(self):
        self.touch_screen(2)
        self.open_track()
        views = [shared_in(self.link())]
        self.swipe(800, 90, -100, 30)
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
        self.assertEqual(views[0]["hash"], views[2]["hash"], "the track is unchanged")

    def test_the_touch_keyboard_types(self):
        self.touch_screen(1)
        self.open_track()
        focused = lambda: self.js("document.activeElement.id")
        self.touch("touchStart", (800, 90))
        self.touch("touchEnd")
        self.assertEqual(focused(), "canvas", "nothing takes text")
        self.key("p", CTRL)
        self.until(lambda: focused() == "typed", "the field that shows the keyboard")
        # As keyboards on screens do: words replace the composed text, without keys.
        self.devtools("Input.imeSetComposition", text="nex", selectionStart=3, selectionEnd=3)
        self.devtools("Input.insertText", text="new")
        self.frames(8)
        self.key("Enter")
        self.until_titled("Untitled - coaster")
        self.until(lambda: focused() == "canvas", "the keyboard closes")

    def test_a_key_fills_the_screen(self):
        self.open_track()
        for full in (True, False):
            self.key("F11")
            self.until(lambda: self.js("document.fullscreenElement !== null") == full, f"full screen: {full}")

    # A page each: one that is opened again may ask whether to recover the other's track.
    def marks_at(self, ratio):
        """Clicks beside a knot; returns the width of its mark in pixels, at so many pixels per point."""
        self.small(512, 360, ratio)
        self.open_track()
        for line in ("new", "append at -30 10 0", "append at 0 10 0", "append at 30 10 0", "camera.projection top",
                     "camera target 0 10 0 yaw 0 pitch 15 distance 60", "hints off", "show legend off", "panels off",
                     "select none"):
            self.command(line)
        self.click(256, 180 + 9)
        self.assertEqual(self.value("selected"), "none", "9 points below a knot")
        self.click(256, 180 + 4)
        self.assertEqual(self.value("selected"), "k2", "4 points below it")
        return self.js_async(ORANGE, self.page.get_screenshot_as_base64())

    def test_marks_are_10_points_wide_on_a_plain_screen(self):
        self.assertIn(self.marks_at(1), (10, 11), "the knot under the mouse without its rim: 10.5 points")

    def test_marks_are_as_large_and_as_easy_to_hit_on_a_dense_screen(self):
        self.assertIn(self.marks_at(2), (20, 21, 22))

    def test_files_come_in_and_go_out(self):
        self.open_track()
        self.execute(CATCH_FILE_DIALOG)
        self.execute("Module.coasterPick()")
        field = self.page.find_element("css selector", "input[type=file]")
        field.send_keys(str(source("tracks/helix.json")))
        self.until(lambda: self.js("Module.coasterPicked()") == "/tmp/opened/helix.json", "the chosen file")
        self.execute("openFile(Module.coasterPicked())")
        self.until_titled("Silver Spiral - coaster")
        dropped = {"items": [], "files": [str(source("tracks/gentle.json"))], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.devtools("Input.dispatchDragEvent", type=kind, x=500, y=300, data=dropped)
        self.until_titled("Meadow Breeze - coaster")
        self.execute(CATCH_DOWNLOADS)
        self.command('save "/home/coaster/mine.json"')
        self.until(lambda: [name for name, _ in self.downloads()] == ["mine.json"],
                   lambda: f"the download: {self.downloads()}")

    def test_random_input_breaks_nothing(self):
        self.open_track()
        rng = random.Random(20261123)
        keys = "abcdefghijklmnoprstuvwxyz0123456789 "
        end = time.monotonic() + float(os.environ.get("RANDOM_SECONDS", "60"))
        while time.monotonic() < end:
            if rng.random() < 0.5:
                self.click(rng.randrange(1024), rng.randrange(600))
            else:
                self.key(rng.choice(keys), CTRL if rng.random() < 0.1 and rng.random() < 0.5 else 0)
        self.assertTrue(self.js("said.hidden"), self.js("said.textContent"))


class Fingers(Page):
    """Touch screens."""

    def begin(self, width, height, ratio):
        self.touch_screen(2)
        self.small(width, height, ratio, mobile=True)
        self.open()

    def test_a_phone_in_landscape_rides(self):
        for width, height, ratio in ((844, 390, 1), (800, 360, 1), (667, 375, 2)):
            self.begin(width, height, ratio)
            for choice in ("New track", "Open or import", "Tutorial", "Challenges", "Back to the track", "Quit",
                           "Show at start"):
                self.place_of("Start/" + choice)
            self.tap("Start/Samples/helix")
            self.until_titled("Silver Spiral - coaster")
            self.assertEqual(self.value("widget Hints/Got it"), "", "the first steps would cover the track")
            self.tap("Menu/Workspace/Ride")
            self.tap("Ride/Play")
            self.until_ridden(5)
            self.tap("Ride/Camera")
            self.tap("Ride/Camera/Ride")
            self.until(lambda: self.value("camera_mode") == "ride", "the rider's view")
            self.tap("Ride/Pause")
            self.until(lambda: self.value("ride.state") == "paused", "the pause")

    def test_a_tablet_builds_and_scrolls(self):
        self.begin(1024, 768, 1)
        self.tap("Start/New track")
        self.tap("Elements/Straight")
        self.tap("Elements/Place")
        self.until(lambda: self.number("segments") > 0, "the element")
        self.tap("Menu/Workspace/Laboratory")
        self.place_of("Evaluation/Vertex shader")
        self.assertEqual(self.value("widget Evaluation/Geometry shader"), "", "it is greyed out")
        x, _ = self.place_of("Evaluation/Horner")
        self.touch("touchStart", (x - 40, 700), (x + 40, 700))
        for up in range(50, 301, 50):
            self.touch("touchMove", (x - 40, 700 - up), (x + 40, 700 - up))
            self.frames(2)
        self.touch("touchEnd")
        self.until(lambda: self.value("widget Evaluation/Horner") == "", "two fingers scroll")


if __name__ == "__main__":
    main()
