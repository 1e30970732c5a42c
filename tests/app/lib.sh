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
  local found=$?
  [ "$found" = "$wanted" ] || fail "coaster $*: exit code $found, expected $wanted: $(head -c 400 "$OUT/stderr")"
}
expect_text() { grep -qF -- "$2" "$OUT/$1" || fail "$1 has no '$2': $(head -c 400 "$OUT/$1")"; }
expect_empty() { [ ! -s "$OUT/$1" ] || fail "$1 is not empty: $(head -c 400 "$OUT/$1")"; }
# The lines on stderr except the one that names the driver.
messages() { grep -v '^Drawing with ' "$OUT/stderr"; }
fail() {
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}
finish() { exit $((failures > 0)); }
