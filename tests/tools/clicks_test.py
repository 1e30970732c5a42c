"""Counts what a person does in the scripts that say "# clicks N": at most N. Usage: clicks_test.py SCRIPT_FOLDER

A click, a key and a typed value count 1 each. Typing into a field is a click and a value, a menu's item is two clicks,
and so is a list's row if the line before does not open the list. Checks and waiting count nothing. Such a script may
contain nothing else, such as commands.
"""
import re
import sys
from pathlib import Path

COSTS = {
    "ui.click": 1, "ui.check": 1, "ui.open": 1, "ui.close": 1, "ui.drag": 1, "ui.doubleclick": 2, "ui.type": 2,
    "ui.menu": 2, "aim.click": 1, "aim.drag": 1, "aim.doubleclick": 2, "key": 1, "text": 1, "wheel": 1, "drop": 1,
    "coaster-script": 0, "env": 0, "expect": 0, "wait": 0, "frames": 0, "shot": 0, "ui.hover": 0, "aim.hover": 0,
}
TABS = "Menu/Workspace"


def clicks(script):
    """Returns the count; raises ValueError at a statement that is not input by hand."""
    sum_, before = 0, ""
    for number, line in enumerate(script.splitlines(), 1):
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0] not in COSTS:
            raise ValueError(f"line {number}: {words[0]} is not input by hand")
        sum_ += COSTS[words[0]]
        path = (re.findall(r'"([^"]*)"', line) or [""])[0]
        parent = path.rpartition("/")[0]
        if words[0] == "ui.click" and path.count("/") == 2 and parent not in (before, TABS):
            sum_ += 1
        if COSTS[words[0]] > 0:
            before = path
    return sum_


SAMPLES = [('ui.click "A/B"', 1), ('ui.click "A/B"\nexpect x == 1  # y\nui.click "A/B/C"', 2), ('ui.click "A/B/C"', 2),
           ('ui.click "Menu/Workspace/Ride"', 1), ('ui.type "A/B" "3"\nkey Enter', 3), ('ui.menu "A/B"\nframes 3', 2)]


def main(folder):
    wrong = [f"{script!r} counts {clicks(script)}, not {count}" for script, count in SAMPLES if clicks(script) != count]
    try:
        clicks("element loop")
        wrong.append("a command counts nothing")
    except ValueError:
        pass
    limited = {}
    for path in sorted(folder.glob("*.coaster")):
        if found := re.search(r"^# clicks (\d+)$", path.read_text(), re.M):
            limited[path] = int(found[1])
    if not limited:
        wrong.append("no script says how many clicks it may take")
    for path, limit in limited.items():
        try:
            count = clicks(path.read_text())
        except ValueError as error:
            wrong.append(f"{path.name}: {error}")
            continue
        print(f"{path.name}: {count} of {limit}")
        if count > limit:
            wrong.append(f"{path.name}: {count} clicks, keys and values, where the limit is {limit}")
    print("\n".join(wrong), end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
