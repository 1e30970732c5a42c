#!/usr/bin/python3
"""What the page keeps for the next visit, and what it gives out: settings, medals, work of a tab that crashed, photos, sound:
PAGE_FOLDER SOURCE_FOLDER [CLASS.TEST...]."""
from selenium.common.exceptions import WebDriverException

from page import CTRL, Page, document_of, main

# Listens to what sound devices play: the loudest sample of each of them since the last call of loudest().
LISTEN = """
window.devices = [];
const Device = window.AudioContext;
window.AudioContext = class extends Device { constructor(...words) { super(...words); devices.push({ context: this, ears: [] }); } };
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


class Kept(Page):
    width, height = 800, 600

    def begin(self):
        self.open()
        self.key("Escape")

    def test_settings_and_medals_are_there_after_a_reload(self):
        self.begin()
        self.assertEqual(self.value("style"), "day")
        self.command("style dusk")
        self.command("sound 0.25")
        self.key("h", CTRL)
        self.press("Challenges/Why C1 matters")
        self.until(lambda: self.value("challenge.active") == "on", "the challenge")
        self.command("lengths all in 6 out 6")
        self.until(lambda: self.value("challenge.medal") == "2", lambda: "silver: " + self.value("challenge.medal"))
        self.until(lambda: '"medal": 2' in self.kept("progress.json"), lambda: "the medal in the store: " + self.kept("progress.json"))
        self.until(lambda: '"style": "dusk"' in self.kept("settings.json"), lambda: "the style in the store: " + self.kept("settings.json"))
        self.open()
        self.assertEqual(self.value("style"), "dusk")
        self.assertEqual(self.value("sound"), "0.25")
        read = self.js("Module.FS.readFile(arguments[0], { encoding: 'utf8' })", self.path_of("progress.json"))
        self.assertIn('"medal": 2', read)

    def kept(self, name):
        """Returns the text of a stored file, "" if there is none."""
        return self.stored().get(self.path_of(name), "")

    def path_of(self, name):
        return next((path for path in self.stored() if path.endswith("/" + name)), "")

    def test_work_of_a_crashed_tab_is_recovered(self):
        self.begin()
        self.command("new")
        self.command("element straight length 40")
        before = document_of(self.link())
        self.page.execute_script("const now = performance.now.bind(performance); performance.now = () => now() + 60e3;")  # longer than until an autosave
        self.until(lambda: self.stores(before), "an autosave")
        first = self.page.current_window_handle
        self.page.switch_to.new_window("tab")
        second = self.page.current_window_handle
        self.page.switch_to.window(first)
        with self.assertRaises(WebDriverException):
            self.page.get("chrome://crash")  # its process dies: no event tells the page
        self.page.switch_to.window(second)
        self.small(self.width, self.height)
        self.open()
        self.press("Recover")
        self.until_titled("Untitled* - coaster")
        self.assertEqual(document_of(self.link()), before)

    def test_a_photo_is_downloaded(self):
        self.begin()
        self.page.execute_script("window.photos = []; HTMLAnchorElement.prototype.click = function () { photos.push([this.download, this.href]); };")
        self.key("F12")
        self.until(lambda: self.js("photos.length") == 1, "the photo")
        self.key("F12", CTRL)
        self.until(lambda: self.js("photos.length") == 2, "the photo with panels")
        self.assertEqual([name for name, _ in self.js("photos")], ["red-comet-1.png", "red-comet-2.png"])
        # Width, height, number of colours, and colours of some places.
        pictures = [self.page.execute_async_script(
            "const [address, done] = arguments; const image = new Image(); image.onerror = () => done('no picture'); image.onload = () => {"
            "const canvas = new OffscreenCanvas(image.width, image.height), brush = canvas.getContext('2d'); brush.drawImage(image, 0, 0);"
            "const pixels = new Uint32Array(brush.getImageData(0, 0, image.width, image.height).data.buffer);"
            "done([image.width, image.height, new Set(pixels).size, [...pixels.slice(0, 4000)]]); }; image.src = address;", address)
            for _, address in self.js("photos")]
        for width, height, colours, _ in pictures:
            self.assertEqual([width, height], self.js("[canvas.width, canvas.height]"))
            self.assertGreater(colours, 1000)
        self.assertNotEqual(pictures[0][3], pictures[1][3], "the menu is in the second alone")

    def test_sound_begins_with_the_first_click(self):
        self.before_load(LISTEN)
        self.open()
        self.assertEqual(self.js("devices.map(({ context }) => context.state)"), ["suspended"])
        self.press("Start/Samples/loop")
        self.until(lambda: self.js("devices.map(({ context }) => context.state)") == ["running"], "the sound device after a click")
        self.assertLess(self.js("loudest()"), 1e-3, "a train that stands is silent")
        self.key(" ")
        self.until(lambda: self.js("loudest()") > 0.01, lambda: f"the ride's sound; speed {self.value('ride.speed')}")
        self.command("sound 0")
        states = lambda: self.js("devices.map(({ context }) => context.state)")
        self.until(lambda: states() == ["closed"], lambda: f"no sound output at volume 0, so that the machine's can sleep: {states()}")
        self.command("sound 0.5")
        self.until(lambda: states() == ["closed", "running"], lambda: f"another output with the sound: {states()}")
        self.until(lambda: self.js("loudest()") > 0.01, lambda: f"the ride's sound again; speed {self.value('ride.speed')}")


if __name__ == "__main__":
    main()
