#!/usr/bin/python3
"""Long work in the page: imports and searches in the background, movies, ten minutes of ride.

Usage: PAGE_FOLDER SOURCE_FOLDER [CLASS.TEST...]
"""
import sys

from page import CATCH_DOWNLOADS, CTRL, FIXED_STEPS, SHIFT, Page, main

# Lists how far the worker is in each of the page's frames, 0 to 1.
COUNT_FRAMES = """
window.parts = [];
const next = () => {
  parts.push(Module.coasterWork.part);
  requestAnimationFrame(next);
};
next();
"""
# Counts workers and gives them nothing to do, so that an import never ends.
IDLE_WORKERS = """
window.workers = 0;
const end = Worker.prototype.terminate;
Worker.prototype.postMessage = () => { ++workers; };
Worker.prototype.terminate = function () {
  --workers;
  end.call(this);
};
"""
COUNT_WORKERS = """
window.workers = 0;
const begin = Module.coasterWork.begin;
Module.coasterWork.begin = (...words) => {
  const begun = begin(...words);
  workers += begun;
  return begun;
};
"""
# Passes the duration (s), width and height of the movie at an address, once the picture at 0.5 s shows.
PLAYED = """
const [address, done] = arguments;
const video = document.createElement('video');
video.onerror = () => done([video.error.message, 0, 0]);
video.onseeked = () => done([video.duration, video.videoWidth, video.videoHeight]);
video.onloadeddata = () => { video.currentTime = 0.5; };
video.muted = true;
video.src = address;
"""
MEMORY = "[Module._coaster_allocated(), performance.memory.usedJSHeapSize, Module.HEAPU8.length]"


class Work(Page):
    def begin(self, width=480, height=320):
        self.small(width, height)
        self.open_track()

    def test_an_import_goes_on_beside_the_frames(self):
        self.begin()
        native = self.document()
        self.command('save "rows.csv"')
        self.command('load "rows.csv"')
        self.until(lambda: self.title() != "Red Comet - coaster", "the imported track")
        first = self.document()
        self.assertNotEqual(first, native)
        self.command('save "rows.json"')  # New would ask about an import that is not saved
        self.command("new")
        self.execute(COUNT_FRAMES)
        self.command('load "rows.csv"')
        self.until(lambda: self.title() != "Untitled - coaster", "the imported track")
        parts = [part for part in self.js("parts") if 0 < part < 1]
        self.assertGreater(len(parts), 0, "frames are drawn, and the bar moves")
        self.assertEqual(parts, sorted(parts))
        self.assertEqual(self.document(), first)

    def test_an_import_can_be_cancelled(self):
        self.begin()
        self.command('save "rows.csv"')
        before = self.document()
        self.execute(IDLE_WORKERS)
        self.command('load "rows.csv"')
        self.until(lambda: self.js("workers") == 1, "the import has begun")
        self.frames(10)
        self.key("Escape")
        self.until(lambda: self.js("workers") == 0, "its worker has ended")
        self.frames(4)
        self.assertEqual(self.title(), "Red Comet - coaster")
        self.assertEqual(self.document(), before)

    def test_a_search_goes_on_beside_the_frames(self):
        self.begin()
        before = self.document()
        self.execute(COUNT_WORKERS)
        self.command("seek ride.height_max == 27 by height of all")
        self.until(lambda: self.title() == "Red Comet* - coaster", "the search", 120)
        self.assertEqual(self.js("workers"), 1)
        self.assertNotEqual(self.document(), before)
        self.key("z", CTRL)
        self.frames(4)
        self.assertEqual(self.document(), before, "one step to undo")

    def test_a_movie_is_a_file_that_the_browser_plays(self):
        self.begin()
        self.execute(CATCH_DOWNLOADS)
        self.key("F12", SHIFT)
        self.until(lambda: self.js("Module.coasterMovie.part()") > 0, "the first picture", 60)
        self.frames(40)
        self.key("F12", SHIFT)
        self.until(self.downloads, "the download")
        name, address = self.downloads()[0]
        self.assertEqual(name, "red-comet-movie-1.webm")
        length, width, height = self.js_async(PLAYED, address)
        self.assertGreater(length, 1, "40 frames of 1/30 s")
        self.assertLess(length, 4)
        self.assertEqual([width, height], self.js("[canvas.width, canvas.height]"))

    def test_without_an_encoder_it_says_so(self):
        self.before_load("delete window.VideoEncoder;")
        self.begin()
        self.key("F12", SHIFT)
        self.frames(10)
        self.assertEqual(self.js("Module.coasterMovie.part()"), 0)
        pictures = self.js("Module.FS.analyzePath('/home/coaster/red-comet-movie-1').exists")
        self.assertFalse(pictures, "no pictures fill the memory")

    def test_ten_minutes_of_ride_take_no_memory(self):
        self.begin(320, 200)
        self.without_drawing()
        self.command("ride start")
        self.key("F9")
        self.execute(FIXED_STEPS)

        def used_after(minutes):
            end = self.js("performance.now()") + 60e3 * minutes
            self.until(lambda: self.js("performance.now()") > end, f"{minutes} minutes", 500)
            self.devtools("HeapProfiler.collectGarbage")
            return self.js(MEMORY)

        before = used_after(1)
        travelled = self.number("ride.travelled")
        after = used_after(10)
        travelled = self.number("ride.travelled") - travelled
        print(f"# memory after 1 and 11 minutes of ride (allocated, JavaScript, WebAssembly): {before}, {after}; "
              f"{travelled:.0f} m", file=sys.stderr)
        self.assertGreater(travelled, 600 * 2, "m in 600 s: the trains keep running")
        self.assertLess(after[0] - before[0], 1e6)
        self.assertLess(after[1] - before[1], 2e6)
        self.assertEqual(after[2], before[2])


if __name__ == "__main__":
    main()
