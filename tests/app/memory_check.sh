# The memory budget: readers refuse early, very long tracks are coarse, and a failed allocation saves and ends with 70.
# In, besides: FAILING_NEW (a library for LD_PRELOAD, failing_new.cpp; empty in sanitized builds).
. "$(dirname "$0")/lib.sh"
TRACK=$SOURCE/tests/tracks/eight.json
# within KILOBYTES CODE arguments...: runs the program in that much address space.
within() {
  local most=$1 wanted=$2
  shift 2
  (ulimit -v "$most"; "$COASTER" "$@" >"$OUT/stdout" 2>"$OUT/stderr")
  local found=$?
  [ "$found" = "$wanted" ] || fail "coaster $* in $most kB: exit code $found, expected $wanted: $(head -c 400 "$OUT/stderr")"
}
limited=yes
[ -n "${FAILING_NEW:-}" ] || limited= # sanitizers reserve terabytes of address space

# Files that are larger in memory than on disk.
zeros() { printf '['; head -c "$1" /dev/zero | sed 's/\x0/0,/g'; printf '0]'; }
zeros 30000000 >"$OUT/zeros.json"
carts() { for i in $(seq 1 "$1"); do printf '%s{"id": "c%d", "segment": "s1", "fraction": 0}' "$([ "$i" = 1 ] || echo ,)" "$i"; done; }
for n in 10000 10001; do
  sed -n '/"carts"/q;p' "$TRACK" >"$OUT/carts-$n.json"
  printf '"carts": [%s]}\n' "$(carts "$n")" >>"$OUT/carts-$n.json"
done
{ printf '<root><element>'; head -c 4000000 /dev/zero | sed 's/\x0/<a\/>/g'; printf '</element></root>'; } >"$OUT/large.nl2elem"
corner() { # KNOT X Y Z
  printf '{"id": "k%d", "position": [%s, %s, %s], "tangent": [1, 0, 0], "up": [0, 1, 0], "in": 10000, "out": 10000, "joint": "smooth"}' "$@"
}
corners() {
  printf '{"format": "coaster-track", "version": 1, "name": "Corners", "closed": false, "start_speed": 50, "datum": 0, "knots": ['
  for i in $(seq 1 "$1"); do
    [ "$i" = 1 ] || printf ', '
    c=$((i * 5 % 8))
    corner "$i" "$((c & 1 ? 100000 : -100000))" "$((c & 2 ? 100000 : -100000))" "$((c & 4 ? 100000 : -100000))"
  done
  printf '], "segments": ['
  for i in $(seq 1 $(($1 - 1))); do
    [ "$i" = 1 ] || printf ', '
    printf '{"id": "s%d", "from": "k%d", "to": "k%d", "turns": 0}' "$i" "$i" $((i + 1))
  done
  printf '], "carts": [{"id": "c1", "segment": "s1", "fraction": 0.5}]}\n'
}
# row N: a straight of N segments of 10 m, each with a chain.
row() {
  printf '{"format": "coaster-track", "version": 1, "name": "Row", "closed": false, "start_speed": 9, "datum": 0, "knots": ['
  seq 1 $(($1 + 1)) | awk '{ printf "%s{\"id\": \"k%d\", \"position\": [%d, 5, 0], \"tangent\": [1, 0, 0], \"up\": [0, 1, 0], \"in\": 3, \"out\": 3, \"joint\": \"smooth\"}", (NR > 1 ? ", " : ""), $1, 10 * $1 - 90000 }'
  printf '], "segments": ['
  seq 1 "$1" | awk '{ printf "%s{\"id\": \"s%d\", \"from\": \"k%d\", \"to\": \"k%d\", \"turns\": 0, \"equipment\": \"lift\"}", (NR > 1 ? ", " : ""), $1, $1, $1 + 1 }'
  printf '], "carts": [{"id": "c1", "segment": "s1", "fraction": 0}]}\n'
}
row 15000 >"$OUT/row.json"
corners 40 >"$OUT/corners.json"
corners 400 >"$OUT/many_corners.json"
if [ -n "$limited" ]; then
  within 1500000 3 --validate "$OUT/zeros.json"
  expect_text stderr "more than the limit of 8000000 values"
  within 500000 3 --validate "$OUT/carts-10001.json"
  expect_text stderr "carts: more than the limit of 10000"
  within 500000 0 --report "$OUT/carts-10000.json"
  within 300000 3 --validate "$OUT/large.nl2elem"
  expect_text stderr "larger than the limit of 4194304 bytes"
  within 2500000 0 --headless "$OUT/corners.json" --size 96x54 --frames 2 --out "$OUT/ride"
  expect_text stderr "This is a very long track. Ties, equipment and supports are drawn only near the eye."
  for name in corners many_corners; do within 2500000 0 --report "$OUT/$name.json"; done
  # Chains of 150 km: drawn near the eye alone, and too much for a solid.
  within 1500000 0 --headless "$OUT/row.json" --size 96x54 --frames 2 --out "$OUT/ride"
  printf 'coaster-script 1\nload "%s"\nexpect error save "$OUT/a.obj" ~ "the limit of 3000000 vertices"\nexpect error save "$OUT/a.gltf" ~ "the limit"\n' "$OUT/row.json" >"$OUT/solid.coaster"
  within 1500000 0 --headless --script "$OUT/solid.coaster" --out "$OUT/run"
  # Without enough of it for anything: one line and an exit code of its own.
  within 250000 70 --validate "$OUT/zeros.json"
  [ "$(cat "$OUT/stderr")" = "Out of memory." ] || fail "expected one line: $(cat "$OUT/stderr")"
fi
rm -f "$OUT/zeros.json" "$OUT/large.nl2elem"

# A sheet has as many pixels as a picture at most.
{
  printf 'coaster-script 1\nenv size 640x360\nshot "a.png"\nexpect error sheet "sheet.png"'
  printf ' "a.png"%.0s' $(seq 200)
  printf ' ~ "more than the limit of 33177600 pixels"\n'
} >"$OUT/sheet.coaster"
expect_code 0 --headless --script "$OUT/sheet.coaster" --out "$OUT/run"

# In however little, a run ends well or with that line: drivers and the compilers in them crash where an allocation of
# theirs fails. How much a driver needs differs between versions, so most runs have about that much.
if [ -n "$limited" ]; then
  runs_within() { # KILOBYTES: returns 0 if the run ends well, 1 if it ends for want of memory
    (ulimit -v "$1"; "$COASTER" --headless "$TRACK" --size 96x54 --frames 2 --out "$OUT/ride" >"$OUT/stdout" 2>"$OUT/stderr")
    local code=$?
    case $code in
      0) return 0 ;;
      70) expect_text stderr "Out of memory." ;;
      4) expect_text stderr "cannot be loaded (" ;; # the driver is larger than that
      *) fail "in $1 kB: exit code $code: $(head -c 400 "$OUT/stderr")" ;;
    esac
    return 1
  }
  little=100000 enough=1000000
  runs_within $little && fail "a run ends well in $little kB"
  runs_within $enough || fail "a run does not end well in $enough kB"
  while [ $((enough - little)) -gt 5000 ]; do
    middle=$(((little + enough) / 2))
    if runs_within $middle; then enough=$middle; else little=$middle; fi
  done
  for most in $(seq $((little - 35000)) 5000 $((enough + 20000))); do runs_within "$most"; done
fi

# The n-th allocation fails, for many n: always 70 and one line, or the script's normal end. Unsaved work can be
# recovered.
if [ -n "$limited" ]; then
  printf 'coaster-script 1\nenv size 64x36\nload "%s"\nmove @k2 to 1 9 4\nframes 120\nlog "the end"\n' "$TRACK" >"$OUT/some.coaster"
  saved=0 ended=0
  for n in 1 10 100 1000 10000 20000 30000 40000 45000 50000 55000 60000 65000 70000 80000 100000000; do
    rm -rf "$OUT/home"
    FAIL_AT=$n LD_PRELOAD=$FAILING_NEW "$COASTER" --headless --script "$OUT/some.coaster" --config "$OUT/home" --out "$OUT/run" >"$OUT/stdout" 2>"$OUT/stderr"
    code=$?
    case $code in
      0) ended=$((ended + 1)) ;;
      70)
        [ "$(messages | wc -l)" = 1 ] || fail "allocation $n: expected one line: $(cat "$OUT/stderr")"
        expect_text stderr "Out of memory."
        if grep -q "Unsaved changes are kept for the next start" "$OUT/stderr"; then
          saved=$((saved + 1))
          ls "$OUT"/home/recovery/*.info.json >"$OUT/found" 2>&1 || fail "allocation $n: nothing can be recovered"
        fi ;;
      *) fail "allocation $n: exit code $code: $(head -c 400 "$OUT/stderr")" ;;
    esac
  done
  [ "$saved" -gt 0 ] || fail "no allocation failed while there was unsaved work"
  [ "$ended" -gt 0 ] || fail "the script never ended"
fi

# A file over the size limit is an error like a full disk, and the old file stays.
printf 'coaster-script 1\nload "%s"\nsave "$OUT/own.json"\n' "$TRACK" >"$OUT/save.coaster"
(ulimit -f 1; "$COASTER" --headless --script "$OUT/save.coaster" --out "$OUT/run" >/dev/null 2>"$OUT/stderr")
[ $? = 5 ] || fail "ulimit -f: expected exit code 5: $(cat "$OUT/stderr")"
expect_text stderr "write: File too large"
[ ! -e "$OUT/run/own.json" ] || fail "half a file is left"
finish
