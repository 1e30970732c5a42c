"""Every place of the program and its tools that removes, replaces, renames or truncates a file is listed here with the
rule that keeps a user's files, and with a test of that rule. The rule: only what this run made is removed or replaced,
or what an earlier run marked as its own, or what the user was asked about.

Usage: overwrites_check.py SOURCE
"""
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

CALLS = re.compile(r"(?:::|\b)(unlinkat|unlink|rmdir|renameat|ftruncate|truncate|fopen|ofstream|remove_all|resize_file|"
                   r"copy_file)\(|(?:iles\w*|below|Files\([^()]*\))\.(write_atomic|create|rename|remove\w*)\(|"
                   r"(?:\.|->)(put_in_place)\(|filesystem::(remove|rename)\(|\b(O_CREAT|O_TRUNC)\b")
MADE, ASKED, OWN = ("below a folder, only files that runs made", "the user named or was asked about it",
                    "a name that only the program uses")
# Of each file of src: the calls, the rule, and its tests.
SRC = {
    "base/files.cpp": ("O_CREAT O_CREAT put_in_place renameat renameat unlinkat unlinkat unlinkat unlinkat", MADE,
                       "root.a_file_that_no_run_made_is_neither_replaced_nor_removed",
                       "root.a_folder_is_emptied_only_if_runs_made_all_of_it",
                       "files.names_that_look_alike_are_nobody_s_leftovers",
                       "root.the_list_of_made_files_is_no_way_out"),
    "base/file_lock.cpp": ("O_CREAT ftruncate unlinkat", OWN, "root.a_lock_s_name_with_other_words_is_left_alone",
                           "root.a_lock_is_a_new_file_below"),
    "script/runner.cpp": ("remove_made", MADE, "script.overwrites_check"),
    "script/runner_output.cpp": ("write_atomic " * 5, MADE, "script.overwrites_check"),
    "script/recorder.cpp": ("create put_in_place", MADE, "script.overwrites_check"),
    "app/movie.cpp": ("create put_in_place remove_made write_atomic", MADE, "script.overwrites_check"),
    "app/pictures.cpp": ("write_atomic write_atomic", MADE + "; goldens by an option", "script.overwrites_check"),
    "app/user_data_keeper.cpp": ("remove_leftovers rename write_atomic", OWN, "script.settings_check",
                       "settings_file.a_newer_version_is_refused"),
    "base/crash_guard.cpp": ("put_in_place", OWN,
                             "autosave.what_a_crash_completes_replaces_the_one_before_and_is_removed_whole"),
    "exchange/own/autosave.cpp": ("create create remove remove_leftovers_in write_atomic write_atomic", OWN,
                                  "autosave.what_belongs_to_none_is_removed_and_what_cannot_be_read_stays"),
    "exchange/formats.cpp": ("write_atomic write_atomic", ASKED,
                             "DialogsTest.materials_beside_a_new_export_are_not_lost_unasked",
                             "Applying.a_file_that_another_program_changed_is_not_overwritten"),
    "edit/perform/files.cpp": ("write_atomic", ASKED, "script.overwrites_check"),
}
TOOL_CALLS = re.compile(r"\brm -|\brmtree\(|\.unlink\(|-exec rm|os\.remove\(|shutil\.move\(|\bmv |\btruncate\b")
# Of each tool: how often it removes, and why a user's files stay.
TOOLS = {
    "usage.sh": (1, "fresh() refuses folders without its mark"),
    "chroot": (1, "claim() refuses folders without its mark"),
    "package": (1, "cpack's own folder, made in this run"),
    "mutant_trial.py": (2, "copy_tree() refuses folders without its mark; profiles of this run"),
}
CASE = re.compile(r"^(?:TEST|TEST_F|RC_GTEST_PROP)\(\s*(\w+),\s*(\w+)", re.M)


def calls_in(text):
    found = collections.Counter()
    for line in text.splitlines():
        found.update(name for names in CALLS.findall(line.split("//")[0]) for name in names if name)
    return found


def check_sources(source, wrong):
    names = {f"{suite}.{case}" for file in (source / "tests").rglob("*_test.cpp")
             for suite, case in CASE.findall(file.read_text())}
    names |= {"script." + file.stem for file in (source / "tests/app").glob("*_check.sh")}
    for file in sorted((source / "src").rglob("*.cpp")):
        name = str(file.relative_to(source / "src"))
        found, row = calls_in(file.read_text()), SRC.get(name)
        listed = collections.Counter(row[0].split()) if row else collections.Counter()
        if found != listed:
            wrong.append(f"src/{name}: found {sorted(found.elements())}, listed {sorted(listed.elements())}")
        wrong += [f"src/{name}: there is no test {test}" for test in (row[2:] if row else ()) if test not in names]


def check_tools(source, wrong):
    for file in sorted((source / "tools").iterdir()):
        lines = file.read_text().splitlines() if file.is_file() else []
        count = sum(bool(TOOL_CALLS.search(line)) for line in lines if not line.lstrip().startswith("#"))
        if count != TOOLS.get(file.name, (0,))[0]:
            wrong.append(f"tools/{file.name} removes {count} times, listed are {TOOLS.get(file.name, (0,))[0]}")
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / "folder"
        folder.mkdir()
        (folder / "mine").write_text("mine")

        def fresh():
            script = f'. "{source}/tools/usage.sh"\nfresh "{folder}"\n'
            return subprocess.run(["bash", "-euc", script, f"{source}/tools/web"], capture_output=True, text=True)

        refused = fresh()
        if refused.returncode != 1 or "not made by the tools" not in refused.stderr or not (folder / "mine").exists():
            wrong.append(f"tools: a user's folder was emptied: {refused.stderr}")
        (folder / "mine").unlink()
        if fresh().returncode != 0:
            wrong.append("tools: an empty folder was refused")
        (folder / "made").write_text("made")
        if fresh().returncode != 0 or (folder / "made").exists():
            wrong.append("tools: a folder of the tools was not emptied")


def main():
    source, wrong = pathlib.Path(sys.argv[1]), []
    check_sources(source, wrong)
    check_tools(source, wrong)
    print("\n".join(wrong))
    raise SystemExit(bool(wrong))


main()
