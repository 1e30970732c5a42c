#!/usr/bin/python3
"""Runs the scripts of tests/scripts in pages, several side by side: PAGE_FOLDER SOURCE_FOLDER [NAME...].

Each has to end with exit code 0, as natively; those in SKIPPED with 77, at a line that says what they need, and those in
DIFFERS at the picture that is named there.
"""
import concurrent.futures
import os
import pathlib
import sys
import time
import urllib.parse

import browser

LONGEST = 180  # s for a script
SKIPPED = {"gpu_evaluators"}  # geometry shaders
# A patch of the track's own shadow at the limit of its bias: 30 pixels of a block that another rasteriser lights.
DIFFERS = {"looks": "look_dusk_rider.png in"}


def run(address, script):
    page = browser.open_browser(800, 600)
    try:
        words = ["--headless", "--script", f"tests/scripts/{script}.coaster", "--out", f"/tmp/out/{script}"]
        page.get(f"{address}/script.html?" + urllib.parse.urlencode([("arg", word) for word in words]))
        until = time.monotonic() + LONGEST
        code = None
        while code is None and time.monotonic() < until:
            time.sleep(0.1)
            code = page.execute_script("return window.exitCode")
        return code, page.execute_script("return window.lines.join('\\n')")
    except Exception as wrong:  # a page that hangs
        return None, str(wrong)
    finally:
        page.quit()


def main():
    address = browser.serve(sys.argv[1])
    source = pathlib.Path(sys.argv[2])
    names = sys.argv[3:] or sorted(p.stem for p in source.glob("tests/scripts/*.coaster"))
    wrong, skipped = 0, 0
    with concurrent.futures.ThreadPoolExecutor(max(1, (os.cpu_count() or 2) - 1)) as pool:
        started = {pool.submit(run, address, name): name for name in names}
        for done in concurrent.futures.as_completed(started):
            name = started[done]
            code, said = done.result()
            good = code == (77 if name in SKIPPED else 1 if name in DIFFERS else 0) and DIFFERS.get(name, "") in said
            wrong += not good
            skipped += good and code == 77
            print(f"{'FAILED' if not good else 'skipped' if code == 77 else 'passed'} ({code}): {name}", flush=True)
            if code != 0:
                print(said[said.rfind("tests/scripts"):], flush=True)
    print(f"{len(names)} scripts in pages: {wrong} failed, {skipped} skipped")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
