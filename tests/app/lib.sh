# Shared by the checks in this folder: runs the program and reports what differs from the expectation.
# In: COASTER (the program), OUT (a folder of this check), SOURCE (the source folder).
set -u
rm -rf "$OUT"
mkdir -p "$OUT"
failures=0

# expect_code CODE arguments...: checks the program's exit code; its output is in $OUT/stdout and $OUT/stderr.
expect_code() {
  local wanted=$1
  shift
  "$COASTER" "$@" >"$OUT/stdout" 2>"$OUT/stderr"
  check_code $? "$wanted" "coaster $*"
}
# check_code FOUND CODE WHAT: checks the exit code of a run that the caller started, with stderr in $OUT/stderr.
check_code() { [ "$1" = "$2" ] || fail "$3: exit code $1, expected $2: $(head -c 400 "$OUT/stderr")"; }
# script NAME LINES: writes a script. run_script CODE NAME arguments...: runs it; it may write in $OUT/run.
script() { printf 'coaster-script 1\n%s\n' "$2" >"$OUT/$1.coaster"; }
run_script() { expect_code "$1" --headless --script "$OUT/$2.coaster" --out "$OUT/run" "${@:3}"; }
expect_text() { grep -qF -- "$2" "$OUT/$1" || fail "$1 has no '$2': $(head -c 400 "$OUT/$1")"; }
expect_empty() { [ ! -s "$OUT/$1" ] || fail "$1 is not empty: $(head -c 400 "$OUT/$1")"; }
# The lines on stderr except the one that names the driver.
messages() { grep -v '^Drawing with ' "$OUT/stderr"; }
fail() {
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}
finish() { exit $((failures > 0)); }
