"""Turns Google Benchmark's log (--v=2) on stdin into a line of progress every five seconds; passes on other lines.

Usage: bench_progress.py RUNS. RUNS: how many there will be, benchmarks times repetitions.
"""
import re
import sys
import time


def main():
    start, shown = time.monotonic(), -5.0
    iterations, runs = {}, 0
    for line in sys.stdin:
        found = re.match(r"-- LOG\(\d+\): Running (.*) for (\d+)", line)
        if found:
            name, count = found.groups()
            # A benchmark's first run is tried with more and more iterations.
            if iterations.setdefault(name, count) == count:
                runs += 1
            iterations[name] = count
            seconds = time.monotonic() - start
            if seconds >= shown + 5:
                shown = seconds
                print(f"{seconds:4.0f} s  run {runs} of {sys.argv[1]}: {name}", file=sys.stderr, flush=True)
        elif not line.startswith("-- LOG("):
            print(line, end="", file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
