"""Prints the medians of Google Benchmark's JSON as a table, under the machine's line."""
import json
import re
import statistics
import subprocess
import sys


def runs_of(report):
    """The repetitions of each benchmark by name, in the order of the file."""
    runs = {}
    for run in report["benchmarks"]:
        if run.get("run_type") == "iteration" and not run.get("error_occurred"):
            name = re.sub(r"/(manual_time|real_time|iterations:\d+|repeats:\d+)", "", run["name"])
            runs.setdefault(name, []).append(run)
    return runs


def median(runs, key):
    values = [run[key] for run in runs if key in run]
    return statistics.median(values) if values else None


def machine_line(report, runs):
    """Processor, cores, last cache, compiler and number of runs, which apply to every figure."""
    context = report["context"]
    try:
        with open("/proc/cpuinfo") as file:
            model = re.search(r"model name\s*:\s*(.*)", file.read()).group(1)
    except (OSError, AttributeError):
        model = "unknown processor"
    caches = [cache for cache in context.get("caches", []) if cache["level"] >= 2]
    sizes = ", ".join(f"L{cache['level']} {cache['size'] // 1024} KiB" for cache in caches)
    compiler = subprocess.run(["g++", "--version"], capture_output=True, text=True).stdout.split("\n")[0]
    repetitions = max((len(of) for of in runs.values()), default=0)
    return f"{model}, {context['num_cpus']} cores, {sizes}; {compiler}; medians of {repetitions} interleaved runs"


FIGURES = ("ns_per_", "ms_", "cpu_s_", "mb_", "kb_", "ratio_", "worst_", "difference_", "error_", "drift_",
           "evaluations", "uploads", "rebuilds", "shadow_maps", "draw_calls", "triangles", "vertices", "checksum")


def main():
    with open(sys.argv[1]) as file:
        report = json.load(file)
    runs = runs_of(report)
    if not runs:
        sys.exit("no benchmark was run: does the filter match one? (--benchmark_list_tests)")
    print(machine_line(report, runs))
    width = max(len(name) for name in runs)
    print(f"{'benchmark':{width}} {'time':>12}  figures")
    for name, of in sorted(runs.items()):
        figures = "  ".join(f"{key} {median(of, key):.4g}" for key in of[0] if key.startswith(FIGURES))
        print(f"{name:{width}} {median(of, 'real_time'):9.4g} {of[0]['time_unit']:2}  {figures}")


if __name__ == "__main__":
    main()
