"""Prints the medians of Google Benchmark's JSON as a table, with ratios to the plain store of the same bytes."""
import json
import re
import statistics
import subprocess
import sys

with open(sys.argv[1]) as file:
    report = json.load(file)

runs = {}
for run in report["benchmarks"]:
    if run.get("run_type") == "iteration":
        runs.setdefault(run["name"].split("/repeats")[0], []).append(run)

context = report["context"]
try:
    with open("/proc/cpuinfo") as file:
        model = re.search(r"model name\s*:\s*(.*)", file.read()).group(1)
except (OSError, AttributeError):
    model = "unknown processor"
compiler = subprocess.run(["g++", "--version"], capture_output=True, text=True).stdout.split("\n")[0]
print(f"{model}, {context['num_cpus']} cores; {compiler}; medians of {len(next(iter(runs.values())))} interleaved runs")


def median(name, key):
    values = [run[key] for run in runs.get(name, []) if key in run]
    return statistics.median(values) if values else None


store = median("evaluate/store", "ns_per_point")
print(f"{'benchmark':58} {'time':>12} {'figures'}")
for name in runs:
    unit = runs[name][0]["time_unit"]
    figures = []
    for key in runs[name][0]:
        if key.startswith(("ns_per", "ms_", "ratio", "checksum", "uploads", "rebuilds", "vertices")):
            value = median(name, key)
            figures.append(f"{key} {value * 1 if not key.startswith('ns_') else value * 1e9 if value < 1e-6 else value:.4g}")
    per_point = median(name, "ns_per_point")
    if per_point and store and name != "evaluate/store":
        figures.append(f"x store {per_point / store:.2f}")
    print(f"{name:58} {median(name, 'cpu_time'):9.4g} {unit:2} {'  '.join(figures)}")
