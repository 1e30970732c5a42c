"""The curve library as other programs see it: installs it, and builds and runs its examples from outside.

Usage: curve_library_check.py BUILD_FOLDER OUT_FOLDER CMAKE GENERATOR CXX_COMPILER

1. Public headers include only the standard library, GLM and each other, and define no macros.
2. The shared library exports what they declare and nothing else; the static one has no names outside coaster.
3. The examples and the one in the README build with find_package() alone, static and shared, and print what closed
   forms and other methods give.
"""
import math
import re
import shutil
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

INCLUDE = re.compile(r"^\s*#\s*include\s+(.*)$", re.M)
SYSTEM = {"libstdc++.so.6", "libm.so.6", "libgcc_s.so.1", "libc.so.6", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}


def run(*command):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"{' '.join(str(word) for word in command)}:\n{(result.stdout + result.stderr)[-3000:]}")
    return result.stdout


def bad_headers(headers):
    """What is wrong with the headers (name: text)."""
    for name, text in headers.items():
        for what in INCLUDE.findall(text):
            ours = re.match(r'"curve/(\w+\.h)"', what)
            if not re.match(r"<([a-z_0-9]+|glm/[\w/.]+)>", what) and not (ours and ours[1] in headers):
                yield f"{name}: includes {what}; expected the standard library, GLM or another public header"
        yield from (f"{name}: defines a macro: {line}" for line in re.findall(r"^\s*#\s*define.*", text, re.M))


def bad_exports(lines, headers):
    """What is wrong with the exports of the shared library, lines of nm -DC."""
    words = set(re.findall(r"\w+", " ".join(headers.values())))
    for line in lines:
        name = line.split(" ", 2)[2]
        ours = re.match(r"coaster::curve::(\w+)", name)
        if not ours or ours[1] not in words:
            yield f"the shared library exports {name}; expected only what the public headers declare"
    if len(lines) < 20:
        yield f"the shared library exports only {len(lines)} symbols"


def bad_definitions(lines):
    """What is wrong with the names of the static library, lines of nm -C: inline functions (weak) may be GLM's."""
    for kind, name in re.findall(r"^[0-9a-f]+ (\w) (.*)", "\n".join(lines), re.M):
        if kind in "TDBRGSC" and not re.match(r"coaster::(curve|base)::", name):
            yield f"the static library defines {name}; expected names of coaster::curve and coaster::base"


def cubic(t, p):
    u = 1 - t
    return [u * u * u * a + 3 * t * u * u * b + 3 * t * t * u * c + t * t * t * d for a, b, c, d in zip(*p)]


def slope(t, p):
    u = 1 - t
    return [3 * (u * u * (b - a) + 2 * t * u * (c - b) + t * t * (d - c)) for a, b, c, d in zip(*p)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def near(what, found, wanted, within):
    if not abs(found - wanted) <= within:
        raise AssertionError(f"{what}: {found!r}, expected {wanted!r} within {within}")


def check_lengths(rows):
    # The integral of sqrt(1 + (x/6)^2).
    arc = lambda x: 3 * (x / 6 * math.hypot(1, x / 6) + math.asinh(x / 6))
    near("length", float(rows["length"][0][0]), arc(12), 1e-11)
    near("coarse length", float(rows["coarse_length"][0][0]), arc(12), 1e-4 * arc(12))
    near("evaluations", float(rows["coarse_evaluations"][0][0]), 10, 0)
    points = [[float(word) for word in row] for row in rows["point"]]
    near("points", len(points), 7, 0)
    for i, (s, x, y) in enumerate(points):
        near("distance of a point", s, arc(12) * i / 6, 1e-11)
        near("length up to a point", arc(x), s, 1e-9)
        near("height of a point", y, x * x / 12, 1e-9)


def check_frames(rows):
    knots = [(10, 3, 0), (0, -2, 10), (-10, 1, 0), (0, 0, -10)]
    tangents = [(0, 0, 1), (-1, 0, 0), (0, 0, -1), (1, 0, 0)]
    steps, length, area, behind, bare, frames = 2000, 0.0, 0.0, [], [0.0, 1.0, 0.0], []
    before = [0.0, 0.0, 1.0]
    for i in range(4):
        a, b = knots[i], knots[(i + 1) % 4]
        p = [a, [x + 5.5 * d for x, d in zip(a, tangents[i])],
             [x - 5.5 * d for x, d in zip(b, tangents[(i + 1) % 4])], b]
        for k in range(1, steps + 1):
            length += math.sqrt(dot(*[slope((k - 0.5) / steps, p)] * 2)) / steps
            here = unit(slope(k / steps, p))
            # The solid angle of the triangle of two tangents and +Y (Oosterom and Strackee).
            area += 2 * math.atan2(cross(before, here)[1], 1 + dot(before, here) + before[1] + here[1])
            share = dot(bare, here) / (1 + dot(before, here))  # the least rotation from tangent to tangent
            bare = [u - share * (x + y) for u, x, y in zip(bare, before, here)]
            before = here
        behind.append(length)
        frames.append((bare, here))
    near("length of the loop", float(rows["length"][0][0]), length, 1e-5)
    # A vector carried along the loop turns by the area that the tangents enclose on the unit sphere (Gauss-Bonnet).
    turn = float(rows["turn"][0][0])
    near("turn", math.remainder(turn + area, 2 * math.pi), 0, 1e-6)
    near("frames", len(rows["frame"]), 4, 0)
    for row, part, (up, forward) in zip(rows["frame"], behind, frames):
        angle, left = turn * part / length, cross(up, forward)
        for k, word in enumerate(row):
            wanted = [math.cos(angle) * u - math.sin(angle) * x for u, x in zip(up, left)]
            near("frame", float(word), (wanted + cross(wanted, forward))[k], 1e-6)
    near("seam", float(rows["seam"][0][0]), 0, 1e-9)


def bend(p, t):
    """The curvature vector at t."""
    first, second = slope(t, p), [6 * ((1 - t) * (a - 2 * b + c) + t * (b - 2 * c + d)) for a, b, c, d in zip(*p)]
    size = dot(first, first)
    return [(s - dot(first, second) / size * f) / size for f, s in zip(first, second)]


def check_joint(rows):
    before = [[-10, 10, 0], [-10, 4.477, 0], [-5.523, 0, 0], [0, 0, 0]]
    after = [[0, 0, 0], [11.046, 0, 0], [20, 8.954, 2], [20, 20, 4]]
    jump = lambda a, b: math.dist(bend(a, 1), bend(b, 0))
    near("jump before", float(rows["before_jump"][0][0]), jump(before, after), 1e-7)
    points = lambda name: [[float(x) for x in rows[name][0][3 * i:3 * i + 3]] for i in range(4)]
    first, second = points("first"), points("second")
    near("jump after", jump(first, second), 0, 1e-6)
    near("printed jump after", float(rows["after_jump"][0][0]), jump(first, second), 1e-6)
    if rows["before_class"] != [["G1"]] or rows["after_class"] != [["G2"]] or rows["solved"] != [["1"]]:
        raise AssertionError(f"classes {rows['before_class']}, {rows['after_class']}: expected G1, G2")
    near("ends", math.dist(first[0], before[0]) + math.dist(second[3], after[3]), 0, 0)
    near("joint", math.dist(first[3], second[0]), 0, 0)
    along = cross(unit(minus(first[3], first[2])), unit(minus(second[1], second[0])))
    near("corner", math.sqrt(dot(along, along)), 0, 1e-6)
    moved = [(first[1], before[1]), (first[2], before[2]), (first[3], before[3]), (second[1], after[1]),
             (second[2], after[2])]
    near("movement", float(rows["movement"][0][0]), math.hypot(*(math.dist(*pair) for pair in moved)), 1e-5)
    near("movement below a metre", float(rows["movement"][0][0]), 0.5, 0.5)


def check_fit(rows):
    errors = {}
    for name in ("circle", "helix"):
        for spans, error, jump, joints, handle in rows[name]:
            errors[name, int(spans)] = float(error)
            near(f"G2 joints of the {name}", int(joints), int(spans) - 1, 0)
            near(f"largest jump of the {name}", float(jump), 0, 1e-5)
            # The handles follow from curvature and symmetry: drop = a sin + 3/2 a^2 curvature, where drop and sin are
            # those of the chord and the far tangent towards the centre.
            angle, r, rise = 2 * math.pi / int(spans), 10, 0 if name == "circle" else 6 / math.pi
            drop, curved = r * (1 - math.cos(angle)), r / (r * r + rise * rise)
            sin = math.sin(angle) * r / math.hypot(r, rise)
            a = (math.sqrt(sin * sin + 6 * curved * drop) - sin) / (3 * curved)
            near("handle", float(handle), a, 1e-9)
            if name == "helix":
                continue
            end = [r * math.cos(angle), r * math.sin(angle)]
            p = [[r, 0], [r, a], [end[0] + a * math.sin(angle), end[1] - a * math.cos(angle)], end]
            off = max(abs(math.hypot(*cubic(k / 400, p)) - r) for k in range(401))
            near("error of the circle", float(error), off, 0.02 * off)
    near("order of the circle", math.log2(errors["circle", 4] / errors["circle", 8]), 6, 0.25)
    near("error of the helix", errors["helix", 6], 1e-3, 1e-3)
    near("order of the helix", math.log2(errors["helix", 6] / errors["helix", 12]), 6, 1)


def check_evaluators(rows):
    wanted = {"bernstein", "de_casteljau", "horner", "forward_differences", "estrin", "horner8", "forward_differences8"}
    if set(rows) != wanted:
        raise AssertionError(f"evaluators {sorted(rows)}, expected {sorted(wanted)}")
    p = [[Fraction(x) for x in row] for row in ((101.5, 3, -7), (104, 9, 2), (111, -5, 3), (117, 2, -4))]
    exact = [float(x) for x in cubic(Fraction(37, 100), p)]
    for name, [(error, bound, *vertex)] in rows.items():
        error, bound = float(error), float(bound)
        if not 1e-7 < error <= bound:
            raise AssertionError(f"{name}: error {error}, expected above 1e-7 and at most {bound}")
        near(f"vertex of {name}", math.dist([float(x) for x in vertex], exact), 0, 1.001 * error)


def check_nearest(rows):
    # From d/dt |B(t) - target|^2 = 0: 12 t^2 = height - 6 on the axis, or 0.
    wanted = {(0, 3, 0): (0, 3), (0, 15, 0): (math.sqrt(0.75), 12), (0, 8, 5): (math.sqrt(1 / 6), math.sqrt(85)),
              (20, 30, 0): (1, math.hypot(8, 18)), (6, 3, -2): (0.5, 2)}
    found = {tuple(map(float, row[:3])): [float(x) for x in row[3:]] for row in rows["nearest"]}
    if found.keys() != wanted.keys():
        raise AssertionError(f"targets {sorted(found)}")
    for target, (t, distance) in wanted.items():
        near(f"t next to {target}", found[target][0], t, 1e-9)
        near(f"distance of {target}", found[target][1], distance, 1e-9)
        near(f"x next to {target}", found[target][2], 12 * t, 1e-8)
        near(f"y next to {target}", found[target][3], 12 * t * t, 1e-8)


def check_readme(rows):
    near("length", float(rows["length"][0][0]), 6 * (math.sqrt(5) + math.asinh(2) / 2), 1e-6)
    x, y, _ = map(float, rows["point"][0])
    near("length up to the point", 3 * (x / 6 * math.hypot(1, x / 6) + math.asinh(x / 6)), 10, 1e-4)
    near("height of the point", y, x * x / 12, 1e-4)


CHECKS = {"lengths": check_lengths, "frames": check_frames, "joint": check_joint, "fit": check_fit,
          "evaluators": check_evaluators, "nearest": check_nearest, "readme": check_readme}


def wrong_figures(name, text):
    """What is wrong with an example's output."""
    rows = {}
    for line in text.splitlines():
        first, *rest = line.split()
        rows.setdefault(first, []).append(rest)
    try:
        CHECKS[name](rows)
    except (AssertionError, KeyError, ValueError, IndexError) as error:
        yield f"{name}: {error!r}"


def unnoticed(headers, exports, texts):
    """Faults that the checks above must find, and do not."""
    for line in ('#include "base/check.h"', "#include <fmt/format.h>", "#include <zlib.h>",
                 '#include "curve/g2_repair.h"', "#define CHECK(x)"):
        if not [*bad_headers({**headers, "g2.h": headers["g2.h"] + line + "\n"})]:
            yield f"a header with {line} passes"
    for name in ("std::vector<double>::reserve(unsigned long)", "coaster::base::sin_cos(double)", "helper(int)",
                 "coaster::curve::detail::baseline_kernels()", "coaster::curve::each_root()"):
        if not [*bad_exports([*exports, f"{0:016x} T {name}"], headers)]:
            yield f"an export {name} passes"
    if not [*bad_definitions([f"{0:016x} T helper(int)"])]:
        yield "a name of the static library outside coaster passes"
    for name, text in texts.items():
        for number in {*re.findall(r"(?<=\s)-?\d+\.\d{6,}(?![\de])", text)} - {f"{0:.9f}", f"-{0:.9f}", f"{0:.12f}"}:
            if name == "evaluators" or abs(float(number)) < 1e-3:  # errors are as large as they are
                continue
            if not [*wrong_figures(name, text.replace(number, repr(float(number) * 1.01), 1))]:
                yield f"{name} with {number} off by 1 % passes"


def examples(prefix, out, cmake, generator, compiler):
    """Builds the installed examples from outside; returns what each prints, by kind of library and name."""
    docs, source, build = prefix / "share/doc/coaster_curve", out / "examples", out / "examples_build"
    shutil.copytree(docs / "examples", source)
    (source / "readme.cpp").write_text(re.search(r"```cpp\n(.*?)```", (docs / "README.md").read_text(), re.S)[1])
    names = sorted((path.name for path in (prefix / "include/coaster/curve").iterdir()), reverse=True)
    all_headers = "".join(f"#include <coaster/curve/{name}>\n" for name in names)
    (source / "headers.cpp").write_text(all_headers + "int main() {}\n")
    run(cmake, "-S", source, "-B", build, "-G", generator, f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror")
    run(cmake, "--build", build)
    return {kind: {name: run(build / f"{name}_{kind}") for name in CHECKS} for kind in ("static", "shared")}


def wrong_files(prefix, headers, exports):
    """What is wrong with what was installed."""
    [archive], [shared] = prefix.glob("lib*/**/libcoaster_curve.a"), prefix.glob("lib*/**/libcoaster_curve.so")
    exports += run("nm", "-DC", "--defined-only", shared).splitlines()
    needed = set(re.findall(r"NEEDED.*\[(.*)\]", run("readelf", "-d", shared)))
    yield from bad_headers(headers)
    yield from bad_exports(exports, headers)
    yield from bad_definitions(run("nm", "-gC", "--defined-only", archive).splitlines())
    yield from (f"the shared library needs {name}" for name in sorted(needed - SYSTEM))
    docs = prefix / "share/doc/coaster_curve"
    if "MIT License" not in (docs / "LICENSE").read_text():
        yield "LICENSE is not the licence"
    for path in (docs / "examples").glob("*.cpp"):
        if (count := len(path.read_text().splitlines())) > 60:
            yield f"{path.name}: {count} lines, at most 60"


def wrong_examples(texts, headers, exports):
    """What is wrong with what the examples print."""
    for name in CHECKS:
        for kind in texts:
            yield from (f"{kind}: {fault}" for fault in wrong_figures(name, texts[kind][name]))
        if texts["static"][name] != texts["shared"][name]:
            yield f"{name}: static and shared differ"
    yield from unnoticed(headers, exports, texts["static"])


def wrong_package(prefix, build, out, cmake, generator):
    """What is wrong with versions and components."""
    (out / "other").mkdir()
    (out / "other/CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(other LANGUAGES NONE)\n"
        "find_package(coaster_curve 9.9 QUIET)\nmessage(STATUS \"found: ${coaster_curve_FOUND}\")\n")
    if "found: 0" not in run(cmake, "-S", out / "other", "-B", out / "other_build", "-G", generator,
                             f"-DCMAKE_PREFIX_PATH={prefix}"):
        yield "version 0.1 counts as 9.9"
    # A plain installation takes components whose condition ends "OR NOT CMAKE_INSTALL_COMPONENT".
    conditions = re.findall(r"^ *if\(.*curve_library.*", (build / "cmake_install.cmake").read_text(), re.M)
    if not conditions or any("NOT CMAKE_INSTALL_COMPONENT" in line for line in conditions):
        yield "a plain installation contains the curve library"


def main():
    build, out, cmake, generator, compiler = Path(sys.argv[1]), Path(sys.argv[2]).resolve(), *sys.argv[3:]
    if not all((build / f"curve_library/libcoaster_curve.{ending}").exists() for ending in ("a", "so")):
        print("skipped: the library is not built (targets curve_static and curve_shared)")
        sys.exit(77)
    shutil.rmtree(out, ignore_errors=True)
    prefix = out / "a prefix"
    run(cmake, "--install", build, "--component", "curve_library", "--prefix", prefix)
    headers = {path.name: path.read_text() for path in (prefix / "include/coaster/curve").iterdir()}
    exports = []
    wrong = [*wrong_files(prefix, headers, exports), *wrong_package(prefix, build, out, cmake, generator)]
    if not wrong:
        wrong = [*wrong_examples(examples(prefix, out, cmake, generator, compiler), headers, exports)]
    print("\n".join(wrong), end="\n" if wrong else "")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
