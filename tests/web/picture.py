#!/usr/bin/python3
"""Takes docs/web.png, the page's picture of a ride on Red Comet: PAGE_FOLDER SOURCE_FOLDER."""
from page import Page, main, source

# A clock of its own: a software renderer is slow, and the picture should not show on what machine it was taken.
CLOCK = "window.step = 250; let time = performance.now(); performance.now = () => time; const next = () => { time += step; requestAnimationFrame(next); }; next();"


class Picture(Page):
    width, height = 1280, 720

    def test_of_a_ride(self):
        self.before_load(CLOCK)
        self.small(self.width, self.height, 1)
        self.open()
        self.key("Escape")
        for line in ("hints off", "workspace ride", "camera_mode chase"):
            self.command(line)
        self.key(" ")
        self.until(lambda: float(self.value("ride.travelled") or 0) > 140, "the first drop")
        self.js("void (window.step = 1000 / 60)")
        self.frames(60)
        source("docs/web.png").write_bytes(self.page.get_screenshot_as_png())


if __name__ == "__main__":
    main()
