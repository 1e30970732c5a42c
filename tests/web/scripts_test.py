#!/usr/bin/python3
"""Runs scripts of tests/scripts in a page, one after the other.

Usage: PAGE_FOLDER SOURCE_FOLDER PART/PARTS, or NAME... instead.
Each has to end with exit code 0, as natively; those in SKIPPED with 77, at a line that says what they need.
"""
import pathlib
import sys
import time

from selenium.common.exceptions import WebDriverException

import browser

LONGEST = 300  # s for a script
SKIPPED = {"gpu_evaluators"}  # geometry shaders


class Runner:
    """A browser with the page of scripts; a new one after a script that hangs."""

    def __init__(self, address):
        self.address = address
        self.page = None

    def run(self, name):
        """Returns a script's exit code, None if it has none, and what it says."""
        arguments = ["--headless", "--script", f"tests/scripts/{name}.coaster", "--out", f"/tmp/out/{name}"]
        try:
            if not self.page:
                self.page = browser.open_browser(800, 600)
                self.page.set_script_timeout(LONGEST)
                self.page.get(f"{self.address}/scripts.html")
            return self.page.execute_async_script("run(arguments[0]).then(arguments[1]);", arguments)
        except WebDriverException as wrong:
            self.close()
            return None, str(wrong)

    def close(self):
        if self.page:
            self.page.quit()
        self.page = None


def chosen(source, words):
    every = sorted(path.stem for path in source.glob("tests/scripts/*.coaster"))
    if words and "/" in words[0]:
        part, parts = map(int, words[0].split("/"))
        return every[part - 1::parts]
    return words or every


def main():
    names = chosen(pathlib.Path(sys.argv[2]), sys.argv[3:])
    runner = Runner(browser.serve(sys.argv[1]))
    wrong = skipped = 0
    for name in names:
        began = time.monotonic()
        code, said = runner.run(name)
        good = code == (77 if name in SKIPPED else 0)
        wrong += not good
        skipped += good and code == 77
        word = "FAILED" if not good else "skipped" if code == 77 else "passed"
        print(f"{word} ({code}): {name}, {time.monotonic() - began:.1f} s", flush=True)
        if code != 0:
            print(said[said.rfind("tests/scripts"):], flush=True)
    runner.close()
    print(f"{len(names)} scripts in a page: {wrong} failed, {skipped} skipped")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
