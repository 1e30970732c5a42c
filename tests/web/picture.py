#!/usr/bin/python3
"""Takes docs/web.png, the page's picture of a ride on Red Comet: PAGE_FOLDER SOURCE_FOLDER."""
from page import FIXED_STEPS, Page, main, source


class Picture(Page):
    width, height = 1280, 720

    def test_of_a_ride(self):
        self.before_load(FIXED_STEPS)  # the picture does not depend on the machine's speed
        self.small(self.width, self.height, 1)
        self.open_track()
        for line in ("hints off", "workspace ride", "camera_mode chase"):
            self.command(line)
        self.key(" ")
        self.until_ridden(140)  # the first drop
        self.execute("window.step = 1000 / 60")
        self.frames(60)
        source("docs/web.png").write_bytes(self.page.get_screenshot_as_png())


if __name__ == "__main__":
    main()
