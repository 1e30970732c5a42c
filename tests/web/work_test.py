#!/usr/bin/python3
"""What takes long in the page: imports and searches beside its frames, movies, ten minutes of ride: PAGE_FOLDER SOURCE_FOLDER [CLASS.TEST...]."""
import sys

from page import CTRL, SHIFT, Page, document_of, main


class Work(Page):
    def begin(self, width=480, height=320):
        self.small(width, height)
        self.open()
        self.key("Escape")

    def count_frames(self):
        """Counts the page's frames, and notes what the worker has done in each of them."""
        self.page.execute_script(
            "window.parts = []; const next = () => { parts.push(Module.coasterWork.part); requestAnimationFrame(next); }; next();")

    def test_an_import_goes_on_beside_the_frames(self):
        self.begin()
        native = document_of(self.link())
        self.command('save "rows.csv"')
        self.command('load "rows.csv"')
        self.until(lambda: self.title() != "Red Comet - coaster", "the imported track")
        first = document_of(self.link())
        self.assertNotEqual(first, native)
        self.command('save "rows.json"')  # New would ask about an import that is not saved
        self.command("new")
        self.count_frames()
        self.command('load "rows.csv"')
        self.until(lambda: self.title() != "Untitled - coaster", "the imported track")
        parts = [part for part in self.js("parts") if 0 < part < 1]
        self.assertGreater(len(parts), 0, "frames go on, and the bar moves")
        self.assertEqual(parts, sorted(parts))
        self.assertEqual(document_of(self.link()), first)

    def test_an_import_can_be_cancelled(self):
        self.begin()
        self.command('save "rows.csv"')
        before = document_of(self.link())
        # An import that takes forever: its worker gets nothing to do.
        self.page.execute_script("window.workers = 0; const end = Worker.prototype.terminate;"
                                 "Worker.prototype.postMessage = () => { ++workers; }; Worker.prototype.terminate = function () { --workers; end.call(this); };")
        self.command('load "rows.csv"')
        self.until(lambda: self.js("workers") == 1, "the import has begun")
        self.frames(10)
        self.key("Escape")
        self.until(lambda: self.js("workers") == 0, "its worker has ended")
        self.frames(4)
        self.assertEqual(self.title(), "Red Comet - coaster")
        self.assertEqual(document_of(self.link()), before)

    def test_a_search_goes_on_beside_the_frames(self):
        self.begin()
        before = document_of(self.link())
        self.page.execute_script("window.workers = 0; const begin = Module.coasterWork.begin;"
                                 "Module.coasterWork.begin = (...words) => { const begun = begin(...words); workers += begun; return begun; };")
        self.command("seek ride.height_max == 27 by height of all")
        self.until(lambda: self.title() == "Red Comet* - coaster", "the search", 120)
        self.assertEqual(self.js("workers"), 1)
        self.assertNotEqual(document_of(self.link()), before)
        self.key("z", CTRL)
        self.frames(4)
        self.assertEqual(document_of(self.link()), before, "one step to undo")

    def test_a_movie_is_a_file_that_the_browser_plays(self):
        self.begin()
        self.page.execute_script("window.movie = null; HTMLAnchorElement.prototype.click = function () { movie = [this.download, this.href]; };")
        self.key("F12", SHIFT)
        self.until(lambda: self.js("Module.coasterMovie.part()") > 0, "the first picture", 60)
        self.frames(40)
        self.key("F12", SHIFT)
        self.until(lambda: self.js("movie") is not None, "the download")
        name, address = self.js("movie")
        self.assertEqual(name, "red-comet-movie-1.webm")
        length, width, height = self.page.execute_async_script(
            "const [address, done] = arguments; const video = document.createElement('video'); video.onerror = () => done([video.error.message, 0, 0]);"
            "video.onseeked = () => done([video.duration, video.videoWidth, video.videoHeight]); video.onloadeddata = () => { video.currentTime = 0.5; };"
            "video.muted = true; video.src = address;", address)
        self.assertGreater(length, 1, "40 frames of 1/30 s")
        self.assertLess(length, 4)
        self.assertEqual([width, height], self.js("[canvas.width, canvas.height]"))

    def test_without_an_encoder_it_says_so(self):
        self.page.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": "delete window.VideoEncoder;"})
        self.begin()
        self.key("F12", SHIFT)
        self.frames(10)
        self.assertEqual(self.js("Module.coasterMovie.part()"), 0)
        self.assertFalse(self.js("Module.FS.analyzePath('/home/coaster/red-comet-movie-1').exists"), "no pictures fill the memory")

    def test_ten_minutes_of_ride_take_no_memory(self):
        self.begin(320, 200)
        self.without_drawing()
        self.command("ride start")
        self.key("F9")
        # A quarter of a second for each frame, the longest that a frame makes up for.
        self.page.execute_script("let time = performance.now(); performance.now = () => time; const next = () => { time += 250; requestAnimationFrame(next); }; next();"
                                 "window.minutes = () => time / 60000;")

        def used_after(minutes):
            end = self.js("minutes()") + minutes
            self.until(lambda: self.js("minutes()") > end, f"{minutes} minutes", 500)
            self.page.execute_cdp_cmd("HeapProfiler.collectGarbage", {})
            return self.js("[Module._coaster_allocated(), performance.memory.usedJSHeapSize, Module.HEAPU8.length]")
        before = used_after(1)
        travelled = float(self.value("ride.travelled"))
        after = used_after(10)
        travelled = float(self.value("ride.travelled")) - travelled
        print(f"# memory after 1 and 11 minutes of ride (allocated, JavaScript, WebAssembly): {before}, {after}; {travelled:.0f} m", file=sys.stderr)
        self.assertGreater(travelled, 600 * 2, "m in 600 s: the trains go on")
        self.assertLess(after[0] - before[0], 1e6)
        self.assertLess(after[1] - before[1], 2e6)
        self.assertEqual(after[2], before[2])


if __name__ == "__main__":
    main()
