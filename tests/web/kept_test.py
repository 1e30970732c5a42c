#!/usr/bin/python3
"""What the page keeps for the next visit, and what it gives out: settings, medals, recovered work, photos, sound.

Usage: PAGE_FOLDER SOURCE_FOLDER [CLASS.TEST...]
"""
from selenium.common.exceptions import WebDriverException

from page import CATCH_DOWNLOADS, CTRL, DRAWN, Page, main

# Listens to sound devices: loudest() returns the loudest sample since the last call.
LISTEN = """
window.devices = [];
const Device = window.AudioContext;
window.AudioContext = class extends Device {
  constructor(...words) {
    super(...words);
    devices.push({ context: this, ears: [] });
  }
};
const connect = AudioNode.prototype.connect;
AudioNode.prototype.connect = function (to, ...words) {
  const device = devices.find(({ context }) => context.destination === to);
  if (device) {
    const ear = this.context.createAnalyser();
    device.ears.push(ear);
    connect.call(this, ear);
  }
  return connect.call(this, to, ...words);
};
window.loudest = () => Math.max(0, ...devices.flatMap(({ ears }) => ears).map((ear) => {
  const samples = new Float32Array(ear.fftSize);
  ear.getFloatTimeDomainData(samples);
  return Math.max(...samples.map(Math.abs));
}));
"""
# Passes the width, height and number of colours of the picture at an address, and its first pixels.
MEASURED = DRAWN + """
const [address, done] = arguments;
drawn(address).then((brush) => {
  const { width, height } = brush.canvas;
  const pixels = new Uint32Array(brush.getImageData(0, 0, width, height).data.buffer);
  done([width, height, new Set(pixels).size, [...pixels.slice(0, 4000)]]);
}, (why) => done(String(why)));
"""


class Kept(Page):
    width, height = 800, 600

    def test_settings_and_medals_are_there_after_a_reload(self):
        self.open_track()
        self.assertEqual(self.value("style"), "day")
        self.command("style dusk")
        self.command("sound 0.25")
        self.key("h", CTRL)
        self.press("Challenges/Why C1 matters")
        self.until(lambda: self.value("challenge.active") == "on", "the challenge")
        self.command("lengths all in 6 out 6")
        self.until(lambda: self.value("challenge.medal") == "2", lambda: "silver: " + self.value("challenge.medal"))
        self.until_kept("progress.json", '"medal": 2')
        self.until_kept("settings.json", '"style": "dusk"')
        self.open()
        self.assertEqual(self.value("style"), "dusk")
        self.assertEqual(self.value("sound"), "0.25")
        read = self.js("Module.FS.readFile(arguments[0], { encoding: 'utf8' })", self.path_of("progress.json"))
        self.assertIn('"medal": 2', read)

    def until_kept(self, name, text):
        """Waits until the stored file of that name has the text."""
        kept = lambda: self.stored().get(self.path_of(name), "")
        self.until(lambda: text in kept(), lambda: f"{text} in the stored {name}: {kept()}")

    def path_of(self, name):
        return next((path for path in self.stored() if path.endswith("/" + name)), "")

    def test_work_of_a_crashed_tab_is_recovered(self):
        self.open_track()
        self.command("new")
        self.command("element straight length 40")
        before = self.document()
        self.until(lambda: self.stores(before), "an autosave")
        first = self.page.current_window_handle
        self.page.switch_to.new_window("tab")
        second = self.page.current_window_handle
        self.page.switch_to.window(first)
        with self.assertRaises(WebDriverException):
            self.page.get("chrome://crash")  # its process dies without an event for the page
        self.page.switch_to.window(second)
        self.small(self.width, self.height)
        self.open()
        self.press("Recover")
        self.until_titled("Untitled* - coaster")
        self.assertEqual(self.document(), before)

    def test_work_is_kept_by_a_reload_and_the_browser_asks(self):
        asks = lambda: self.js("!window.dispatchEvent(new Event('beforeunload', { cancelable: true }))")
        self.open_track()
        self.assertFalse(asks(), "nothing is unsaved")
        self.command("new")
        self.command("element straight length 40")
        self.assertTrue(asks())
        self.command("element straight length 50")
        after = self.document()
        self.until(lambda: self.stores(after), "an autosave after some seconds", 30)
        self.page.refresh()
        self.until_begun()
        self.press("Recover")
        self.until_titled("Untitled* - coaster")
        self.assertEqual(self.document(), after)

    def test_a_photo_is_downloaded(self):
        self.open_track()
        self.execute(CATCH_DOWNLOADS)
        self.key("F12")
        self.until(lambda: len(self.downloads()) == 1, "the photo")
        self.key("F12", CTRL)
        self.until(lambda: len(self.downloads()) == 2, "the photo with panels")
        names, addresses = zip(*self.downloads())
        self.assertEqual(names, ("red-comet-1.png", "red-comet-2.png"))
        pictures = [self.js_async(MEASURED, address) for address in addresses]
        for width, height, colours, _ in pictures:
            self.assertEqual([width, height], self.js("[canvas.width, canvas.height]"))
            self.assertGreater(colours, 1000)
        self.assertNotEqual(pictures[0][3], pictures[1][3], "only the second shows the menu")

    def test_sound_begins_with_the_first_click(self):
        states = lambda: self.js("devices.map(({ context }) => context.state)")

        def until_devices(what, *wanted):
            self.until(lambda: states() == list(wanted), lambda: f"{what}: {states()}")

        def until_heard():
            self.until(lambda: self.js("loudest()") > 0.01,
                       lambda: f"the ride's sound; speed {self.value('ride.speed')}")

        self.before_load(LISTEN)
        self.open()
        self.assertEqual(states(), ["suspended"])
        self.press("Start/Samples/loop")
        until_devices("the sound device after a click", "running")
        self.assertLess(self.js("loudest()"), 1e-3, "a train at rest is silent")
        self.key(" ")
        until_heard()
        self.command("sound 0")
        until_devices("no sound output at volume 0, so that the machine's can sleep", "closed")
        self.command("sound 0.5")
        until_devices("another output with the sound", "closed", "running")
        until_heard()

    def test_sound_begins_with_a_finger(self):
        self.before_load(LISTEN)
        self.touch_screen(1)
        self.open()
        self.tap("Start/Samples/loop")
        self.until(lambda: self.js("devices[0].context.state") == "running", "the sound device after a touch")


if __name__ == "__main__":
    main()
