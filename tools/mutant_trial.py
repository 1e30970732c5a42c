"""A build with tests, into which mutants are planted one at a time.

The build itself stays as it is: a mutant's file is compiled beside it and linked in place of its object, so that one
mutant takes one compilation, one link and the tests. Headers are written into the copied tree and built with all that
includes them.
"""
import hashlib
import json
import os
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
SCRATCH = (SOURCE / "build" / "mutants").resolve()
JOBS = int(os.environ.get("JOBS", os.cpu_count()))
SUITE = re.compile(r"^(?:TEST|TEST_F|TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+)", re.M)
MOST_MEMORY = 8 << 30  # bytes of address space that a test may take


def fail(message):
    print(f"tools/mutants: {message}", file=sys.stderr)
    sys.exit(2)


def copy_tree(target_root):
    """Updates the copy; unchanged files keep their time, so that little is rebuilt. Only in a folder that is new or
    that a former trial marked."""
    marker = target_root / ".made-by-tools"
    if target_root.exists() and any(target_root.iterdir()) and not marker.exists():
        sys.exit(f"{target_root} was not made by tools/mutants, so it stays. Choose another --build folder.")
    target_root.mkdir(parents=True, exist_ok=True)
    marker.touch()
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=SOURCE,
                            check=True, capture_output=True, text=True)
    wanted = {name for name in listed.stdout.split("\0") if name and (SOURCE / name).is_file()}
    for old in target_root.rglob("*") if target_root.exists() else ():
        if old.is_file() and old != marker and str(old.relative_to(target_root)) not in wanted:
            old.unlink()
    for name in wanted:
        source, target = SOURCE / name, target_root / name
        if target.exists() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(source.read_bytes())
        target.chmod(source.stat().st_mode)


def tree_hash(root):
    """A hash of what the results of tests depend on."""
    hasher = hashlib.sha256()
    for folder in ("src", "tests", "tracks", "cmake", "challenges", "envelopes"):
        for path in sorted((root / folder).rglob("*")):
            if path.is_file():
                hasher.update(str(path.relative_to(root)).encode() + b"\0" + path.read_bytes() + b"\0")
    return hasher.hexdigest()[:16]


class Suite:
    """The cases of one test suite, which one process runs."""

    def __init__(self, name, command, environment):
        self.name, self.command, self.environment = name, command, environment
        self.seconds, self.reached = None, None  # without a mutant; the functions reached, if that is known


class Build:
    """A build of a program of tests; `existing`: the folder of one of the working tree, else an own one, with coverage
    if clang is there."""

    def __init__(self, program, existing=None):
        self.program = program
        self.tree = SOURCE if existing else SCRATCH / "tree"
        self.folder = Path(existing).resolve() if existing else SCRATCH / "build"
        self.covered = not existing and bool(shutil.which("clang++") and shutil.which("llvm-profdata"))
        if not existing:
            copy_tree(self.tree)
            self.configure()
        if wrong := self.make():
            fail(f"the unchanged tree does not build:\n{wrong}")
        self.commands = {str((Path(c["directory"]) / c["file"]).resolve()): c
                         for c in json.loads((self.folder / "compile_commands.json").read_text())}
        self.link = self.link_command()
        self.binary = self.folder / "tests" / self.program
        self.planted = SCRATCH / "planted"
        self.planted.mkdir(parents=True, exist_ok=True)

    def configure(self):
        flags = "-O1"
        options = ["-DCMAKE_BUILD_TYPE=Debug", "-DCOASTER_WINDOW=OFF", "-DBUILD_TESTING=ON", "-DCOASTER_UNITY=OFF"]
        if self.covered:
            only = SCRATCH / "covered.txt"
            only.parent.mkdir(parents=True, exist_ok=True)
            if not only.exists():
                only.write_text("[clang]\nsrc:*/src/*\n")
            flags += f" -fprofile-instr-generate -fcoverage-mapping -fprofile-list={only}"
            options.append("-DCMAKE_CXX_COMPILER=clang++")
        options.append(f"-DCMAKE_CXX_FLAGS_DEBUG={flags}")
        if shutil.which("ld.lld"):
            options.append("-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld")
        subprocess.run(["cmake", "-S", self.tree, "-B", self.folder, "-G", "Ninja", *options], check=True,
                       stdout=subprocess.DEVNULL)

    def make(self):
        """Builds everything; returns the output if that failed, else nothing."""
        done = subprocess.run(["cmake", "--build", self.folder, "-j", str(JOBS), "--target", self.program],
                              capture_output=True, text=True)
        return done.stdout[-4000:] if done.returncode else None

    def link_command(self):
        """The words that link the program, with the objects of the rooms in place of their archives."""
        lines = subprocess.run(["ninja", "-C", self.folder, "-t", "commands", self.program], check=True,
                               capture_output=True, text=True).stdout.splitlines()
        members = {}
        for line in lines:
            if found := re.search(r"ar qc (lib\w+\.a) +(.*?) +&& ", line):
                members[found.group(1)] = shlex.split(found.group(2))
        line = next(part for part in reversed(lines[-1].split(" && ")) if f"-o tests/{self.program}" in part)
        words, taken = [], set()
        for word in shlex.split(line):
            name = Path(word).name
            if name in members:
                if name not in taken:
                    words += members[name]
                taken.add(name)
            elif "whole-archive" in word:  # -Wl,--whole-archive or, by clang, -Xlinker --whole-archive
                if words[-1] == "-Xlinker":
                    words.pop()
            else:
                words.append(word)
        if "-fuse-ld=lld" not in words and shutil.which("ld.lld"):
            words.insert(1, "-fuse-ld=lld")
        return words

    def places(self):
        """[first line, last line, name] of the program's functions, by file below the tree."""
        profile = self.planted / "none.profraw"
        subprocess.run([self.binary, "--gtest_filter=none"], env={**os.environ, "LLVM_PROFILE_FILE": str(profile)},
                       check=True, capture_output=True)
        merged = profile.with_suffix(".profdata")
        subprocess.run(["llvm-profdata", "merge", "-sparse", profile, "-o", merged], check=True)
        exported = subprocess.run(["llvm-cov", "export", "-skip-expansions", "-instr-profile", merged, self.binary],
                                  check=True, capture_output=True, text=True).stdout
        found = {}
        for function in json.loads(exported)["data"][0]["functions"]:
            file = Path(function["filenames"][0])
            if self.tree in file.parents:
                first, _, last = function["regions"][0][:3]
                found.setdefault(str(file.relative_to(self.tree)), []).append([first, last, function["name"]])
        return {file: sorted(places) for file, places in sorted(found.items())}

    def compiles(self, file):
        return str(self.tree / file) in self.commands

    def plant(self, file, source):
        """Builds the program with this source of a file: (program, nothing), or (nothing, the compiler's output)."""
        if file.endswith(".h"):
            return self.plant_header(file, source)
        command = self.commands[str(self.tree / file)]
        path, was = self.planted / Path(file).name, self.tree / file
        path.write_text(source)
        words = [word for word in shlex.split(command["command"])]
        words = words[1:] if Path(words[0]).name == "ccache" else words
        old, new = words[words.index("-o") + 1], str(path.with_suffix(".o"))
        words = [new if word == old and words[i - 1] == "-o" else str(path) if word == str(was) else
                 word for i, word in enumerate(words)]
        for option in ("-MF", "-MT"):
            if option in words:
                words[words.index(option) + 1] = str(path.with_suffix(".d"))
        compiled = subprocess.run([*words, "-w"], cwd=command["directory"], capture_output=True, text=True)
        if compiled.returncode:
            return None, compiled.stderr[-2000:]
        program = self.planted / self.program
        link = [new if word == old else str(program) if self.link[i - 1] == "-o" else word
                for i, word in enumerate(self.link)]
        if new not in link:
            fail(f"{old} is not linked into {self.program}")
        linked = subprocess.run(link, cwd=self.folder, capture_output=True, text=True)
        if linked.returncode:  # not a mutant's fault
            fail(f"{self.program} with {file} does not link:\n{linked.stderr[-2000:]}")
        return program, None

    def plant_header(self, file, source):
        if self.tree == SOURCE:
            fail(f"{file}: a header needs the tool's own build")
        path = self.tree / file
        whole = path.read_text()
        path.write_text(source)
        try:
            if wrong := self.make():
                return None, wrong
            program = self.planted / self.program
            shutil.copy(self.binary, program)
            return program, None
        finally:
            path.write_text(whole)


class Room:
    """The tests of a room, in suites that a process each runs."""

    def __init__(self, build, name, not_counted):
        self.build, self.name, self.not_counted = build, name, not_counted
        self.files = {}  # the names of the test files of each suite, without _test.cpp
        self.suites = self.suites_of_room()
        self.recall()

    def suites_of_room(self):
        """The suites of the room's test files, with the environment that CTest gives them."""
        listed = subprocess.run(["ctest", "--show-only=json-v1"], cwd=self.build.folder, check=True,
                                capture_output=True, text=True)
        prefix = self.build.program.removesuffix("_tests") + "."
        found, files = {}, self.files
        for path in sorted((self.build.tree / "tests" / self.name).rglob("*_test.cpp")):
            for name in SUITE.findall(path.read_text()):
                files.setdefault(name, set()).add(path.name.removesuffix("_test.cpp"))
        for test in json.loads(listed.stdout)["tests"]:
            name = re.match(re.escape(prefix) + r"(?:[^.]*/)?(\w+)\.", test["name"])
            if not name or name.group(1) not in files or name.group(1) in found:
                continue
            environment = next((p["value"] for p in test["properties"] if p["name"] == "ENVIRONMENT"), [])
            without = ":".join(self.not_counted)
            suite = name.group(1)
            found[suite] = Suite(suite, [f"--gtest_filter={suite}.*:*/{suite}.*:{suite}/*-{without}",
                                         "--gtest_fail_fast", "--gtest_brief=1"],
                                 dict(one.split("=", 1) for one in environment))
        return found

    def run_suite(self, suite, binary, most_seconds, profile=os.devnull):
        """The first case that failed, "time-out", or nothing when all passed."""
        environment = {**os.environ, **suite.environment, "RC_PARAMS": "seed=1 max_success=40",
                       "LLVM_PROFILE_FILE": str(profile)}
        with subprocess.Popen([str(binary), *suite.command], cwd=self.build.folder / "tests", env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                              start_new_session=True,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY,) * 2)) as process:
            try:
                output, _ = process.communicate(timeout=most_seconds)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.communicate()
                return f"{suite.name} (time-out)"
        if process.returncode == 0:
            return None
        failed = re.search(r"\[  FAILED  \] (\S+?\.[\w/]+)", output)
        return failed.group(1) if failed else f"{suite.name} (crash)"

    def recall(self):
        """Takes what an earlier run has measured of the same tree; with coverage, measures all suites that are left."""
        self.cache = SCRATCH / f"suites_{self.name}.json"
        key = tree_hash(self.build.tree) + str(self.build.folder)
        self.known = json.loads(self.cache.read_text()) if self.cache.exists() else {}
        if self.known.get("key") != key:
            self.known = {"key": key, "suites": {}, "places": self.build.places() if self.build.covered else {}}
        if self.build.covered:
            self.measure(self.suites.values())
        else:
            self.take()

    def measure(self, suites):
        """Runs suites without a mutant that no one has run so yet: each has to pass."""
        new = [suite for suite in suites if suite.name not in self.known["suites"]]
        with ThreadPoolExecutor(JOBS) as pool:
            for suite, entry in zip(new, pool.map(self.measured, new)):
                self.known["suites"][suite.name] = entry
        if new:
            self.cache.write_text(json.dumps(self.known))
        self.take()

    def take(self):
        for suite in self.suites.values():
            if suite.name in self.known["suites"]:
                suite.seconds, reached = self.known["suites"][suite.name]
                suite.reached = None if reached is None else set(reached)

    def measured(self, suite):
        profile, began = self.build.planted / f"{suite.name}.profraw", time.monotonic()
        if wrong := self.run_suite(suite, self.build.binary, 1800, profile if self.build.covered else os.devnull):
            fail(f"{self.name}: {wrong} fails without a mutant")
        seconds = time.monotonic() - began
        return seconds, self.reached_in(profile) if self.build.covered else None

    def reached_in(self, profile):
        """The names of the functions that a run entered."""
        merged = profile.with_suffix(".profdata")
        subprocess.run(["llvm-profdata", "merge", "-sparse", profile, "-o", merged], check=True)
        shown = subprocess.run(["llvm-profdata", "show", "--all-functions", merged], check=True, capture_output=True,
                               text=True).stdout
        profile.unlink(), merged.unlink()
        return functions_counted(shown)

    def reaching(self, file, line):
        """The names of the suites that enter the innermost function around a line; all if that is not known."""
        if not self.build.covered:
            return set(self.suites)
        around = [(last - first, name) for first, last, name in self.known["places"].get(file, ())
                  if first <= line <= last]
        if not around:
            return set()
        names = {name for size, name in around if size == min(around)[0]}
        return {suite.name for suite in self.suites.values() if suite.reached & names}

    def order(self, file, suites):
        """The likeliest first: those of the file's own tests, of tests that include its header, then the fast ones."""
        header = re.sub(r"^src/(.*)\.\w+$", r"\1.h", file)
        tests = (self.build.tree / "tests" / self.name).rglob("*_test.cpp")
        including = {path.name.removesuffix("_test.cpp") for path in tests
                     if f'#include "{header}"' in path.read_text()}
        def rank(name):
            own = Path(file).stem in self.files[name]
            return (not own, not self.files[name] & including, self.suites[name].seconds or 0, name)
        return [self.suites[name] for name in sorted(suites, key=rank)]

    def killer(self, program, suites):
        """The first case that fails; nothing when all pass."""
        def one(suite):
            return self.run_suite(suite, program, 20 + 5 * suite.seconds)
        with ThreadPoolExecutor(JOBS) as pool:
            for first in range(0, len(suites), JOBS):
                self.measure(suites[first:first + JOBS])
                for wrong in pool.map(one, suites[first:first + JOBS]):
                    if wrong:
                        return wrong
        return None


def functions_counted(shown):
    """The functions in the output of llvm-profdata show whose counters are not all 0."""
    return re.findall(r"^  (\S.*):\n    Hash:", shown, re.M)
