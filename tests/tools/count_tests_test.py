"""tools/count_tests sums what CTest itself reports for small suites. Usage: count_tests_test.py COUNT_TESTS CTEST"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

# Tests by name: their programs and properties.
TESTS = {
    "good": ("/bin/true", ""),
    "bad": ("/bin/false", ""),
    "skipped": ('/bin/sh -c "exit 77"', "SKIP_RETURN_CODE 77"),
    "not_run": ("/nonexistent", ""),
    "slow": ("/bin/sleep 9", "TIMEOUT 0.2"),
    "disabled": ("/bin/true", "DISABLED ON"),
    # Passes the second time.
    "repeated": ('/bin/sh -c "if [ -e once ]; then rm once; else touch once; exit 1; fi"', ""),
}


def suite(folder, name, tests):
    """Makes a suite and returns the command that runs it."""
    path = pathlib.Path(folder, name)
    path.mkdir()
    lines = []
    for test in tests:
        program, properties = TESTS[test]
        lines.append(f"add_test({test} {program})")
        if properties:
            lines.append(f"set_tests_properties({test} PROPERTIES {properties})")
    (path / "CTestTestfile.cmake").write_text("\n".join(lines))
    return f"{shlex.quote(sys.argv[2])} --test-dir {path} --repeat until-pass:2"


def numbers(text):
    return [int(number) for number in re.findall(r"\d+", text)]


def main():
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        every = suite(folder, "every", TESTS)
        fine = suite(folder, "fine", ["good", "skipped", "repeated"])
        one = suite(folder, "one", ["good"])
        none = suite(folder, "none", [])
        # Commands, [passed, failed, skipped], and a line of the last list.
        cases = [
            ([one], [1, 0, 0], None),
            ([every], [2, 3, 1], "7 - repeated"),  # not among the failed ones
            ([fine, one], [3, 0, 1], "2 - skipped (Skipped)"),
            ([one, every, fine], [5, 3, 2], "5 - slow (Timeout)"),
            ([f"{one}; {fine}", every], [5, 3, 2], "4 - not_run (Not Run)"),
            ([one, f"{fine}; exit 3"], [3, 1, 1], "(exit code 3)"),
            ([one, none], [1, 1, 0], "(no tests, exit code 0)"),
            (["exit 4", one], [1, 1, 0], "exit 4 (no tests, exit code 4)"),
            ([f"cat {folder}/absent", "true"], [0, 2, 0], "true (no tests, exit code 0)"),
        ]
        for commands, expected, listed in cases:
            ran = subprocess.run([sys.argv[1], *commands], capture_output=True, text=True)
            printed, _, closing = ran.stdout.rpartition("\n=== ")
            lines = [line for line in closing.splitlines()[1:] if line]
            passed, failed, skipped = expected
            name = " | ".join(commands).replace(folder, "").replace(sys.argv[2], "ctest")
            if numbers(lines[0]) != expected:
                wrong.append(f"{name}: {lines[0]}, expected {expected}")
            percent = 100 if failed == 0 else 100 * (passed + skipped) // sum(expected)
            found, *counts = numbers(lines[1])
            if abs(found - percent) > 1 or counts != [failed, sum(expected)] or "tests passed, " not in lines[1]:
                wrong.append(f"{name}: {lines[1]}")
            if not re.match(r"Total Test time \(real\) = +\d+\.\d\d sec$", lines[2]):
                wrong.append(f"{name}: {lines[2]}")
            if ran.returncode != (failed > 0):
                wrong.append(f"{name}: exit code {ran.returncode}")
            if listed and ("repeated" not in listed) != any(listed in line for line in lines[3:]):
                wrong.append(f"{name}: not in the lists: {listed}")
            if "ctest" in name and "Test project" not in printed:
                wrong.append(f"{name}: the output is not passed on")
        # A suite alone has the same closing lines as CTest gives it.
        for command in (every, fine, one):
            own = subprocess.run(command, shell=True, capture_output=True, text=True).stdout
            counted = subprocess.run([sys.argv[1], command], capture_output=True, text=True).stdout
            counted = counted.rpartition("\n=== ")[2]
            for line in own.splitlines():
                closing = "% tests passed" in line or re.match(r"\t +\d+ - ", line)
                if closing and "Disabled" not in line and line not in counted:
                    wrong.append(f"CTest says {line.strip()}, tools/count_tests says {counted.strip()}")
    # This output may be counted, too.
    print("\n".join(line.replace("%", " percent").replace("\t", " ") for line in wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
