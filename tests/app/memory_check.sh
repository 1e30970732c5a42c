# The memory budget: readers refuse early, very long tracks are coarse, and a failed allocation saves and ends with 70.
# In, besides: FAILING_NEW (a library for LD_PRELOAD, failing_new.cpp; empty in sanitized builds).
. "$(dirname "$0")/lib.sh"
TRACK=$SOURCE/tests/tracks/eight.json
# limited_to KILOBYTES arguments...: runs the program in that much address space.
limited_to() {
  (
    ulimit -v "$1"
    "$COASTER" "${@:2}" >"$OUT/stdout" 2>"$OUT/stderr"
  )
}
# within KILOBYTES CODE arguments...: checks the exit code in that much address space.
within() {
  limited_to "$1" "${@:3}"
  check_code $? "$2" "coaster ${*:3} in $1 kB"
}
limited=yes
[ -n "${FAILING_NEW:-}" ] || limited= # sanitizers reserve terabytes of address space

# Files that are larger in memory than on disk.
# repeated N TEXT: the text N times.
repeated() { yes "$2" | head -n "$1" | tr -d '\n'; }
{ printf '['; repeated 30000000 0,; printf '0]'; } >"$OUT/zeros.json"
{ printf '<root><element>'; repeated 4000000 '<a/>'; printf '</element></root>'; } >"$OUT/large.nl2elem"
# listed N ITEM: items of a JSON list for the numbers 1 to N. @ is the number, @next the one after, @x its place on a
# line.
listed() {
  seq 1 "$1" | awk -v item="$2" 'BEGIN { parts = split(item, part, "@") } {
    text = part[1]
    for (i = 2; i <= parts; i++)
      if (part[i] ~ /^next/) text = text ($1 + 1) substr(part[i], 5)
      else if (part[i] ~ /^x/) text = text (10 * $1 - 90000) substr(part[i], 2)
      else text = text $1 part[i]
    printf "%s%s", (NR > 1 ? ",\n" : ""), text
  }'
}
for n in 10000 10001; do
  sed -n '/"carts"/q;p' "$TRACK" >"$OUT/carts-$n.json"
  printf '"carts": [%s]}\n' "$(listed "$n" '{"id": "c@", "segment": "s1", "fraction": 0}')" >>"$OUT/carts-$n.json"
done
# track SPEED KNOTS SEGMENTS: prints an open track of these.
track() {
  cat <<END
{"format": "coaster-track", "version": 1, "name": "Long", "closed": false, "start_speed": $1, "datum": 0,
"knots": [$2],
"segments": [$3],
"carts": [{"id": "c1", "segment": "s1", "fraction": 0.5}]}
END
}
# corners N: a track from corner to corner of a cube of 200 km, N of them.
corners() {
  local knots=
  for i in $(seq 1 "$1"); do
    local c=$((i * 5 % 8))
    local at="$((c & 1 ? 100000 : -100000)), $((c & 2 ? 100000 : -100000)), $((c & 4 ? 100000 : -100000))"
    knots+="${knots:+, }{\"id\": \"k$i\", \"position\": [$at], \"tangent\": [1, 0, 0], \"up\": [0, 1, 0],
      \"in\": 10000, \"out\": 10000, \"joint\": \"smooth\"}"
  done
  track 50 "$knots" "$(listed $(($1 - 1)) '{"id": "s@", "from": "k@", "to": "k@next", "turns": 0}')"
}
# row N: a straight of N segments of 10 m, each with a chain.
row() {
  local knots segments
  knots=$(listed $(($1 + 1)) '{"id": "k@", "position": [@x, 5, 0], "tangent": [1, 0, 0], "up": [0, 1, 0],
    "in": 3, "out": 3, "joint": "smooth"}')
  segments=$(listed "$1" '{"id": "s@", "from": "k@", "to": "k@next", "turns": 0, "equipment": "lift"}')
  track 9 "$knots" "$segments"
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
  within 2500000 0 --report "$OUT/corners.json"
  within 2500000 0 --report "$OUT/many_corners.json"
  # Chains of 150 km: drawn only near the eye, and too much for a solid.
  within 1500000 0 --headless "$OUT/row.json" --size 96x54 --frames 2 --out "$OUT/ride"
  script solid "load \"$OUT/row.json\"
expect error save \"\$OUT/a.obj\" ~ \"the limit of 3000000 vertices\"
expect error save \"\$OUT/a.gltf\" ~ \"the limit\""
  within 1500000 0 --headless --script "$OUT/solid.coaster" --out "$OUT/run"
  # Too little to read the file: one line and its own exit code.
  within 250000 70 --validate "$OUT/zeros.json"
  [ "$(cat "$OUT/stderr")" = "Out of memory." ] || fail "expected one line: $(cat "$OUT/stderr")"
fi
rm -f "$OUT/zeros.json" "$OUT/large.nl2elem"

# The largest picture with samples, density and scale: fewer samples, and 0.7 GB at most.
script large 'env size 7680x4320 msaa 16 density 4 scale 3
shot "large.png"'
most=$(python3 -c 'import resource, subprocess, sys
subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL, stderr=open(sys.argv[-1] + ".stderr", "w"))
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)' \
  "$COASTER" --headless --script "$OUT/large.coaster" --out "$OUT/run")
[ -n "$limited" ] && [ "${most:-9999999}" -gt 700000 ] && fail "a large picture took $most kB"
grep -q "Antialiasing is off: 7680x4320 pixels with" "$OUT/run.stderr" || fail "no word of fewer samples"

# A sheet has as many pixels as a picture at most.
script sheet "env size 640x360
shot \"a.png\"
expect error sheet \"sheet.png\"$(repeated 200 ' "a.png"') ~ \"more than the limit of 33177600 pixels\""
run_script 0 sheet

# In any amount of memory a run ends normally or with that line, although drivers and their compilers crash if one of
# their allocations fails. How much a driver needs differs between versions, so most runs have about that much.
if [ -n "$limited" ]; then
  runs_within() { # KILOBYTES: returns 0 if the run ends normally, 1 if it runs out of memory
    limited_to "$1" --headless "$TRACK" --size 96x54 --frames 2 --out "$OUT/ride"
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
  runs_within $little && fail "a run ends normally in $little kB"
  runs_within $enough || fail "a run does not end normally in $enough kB"
  while [ $((enough - little)) -gt 5000 ]; do
    middle=$(((little + enough) / 2))
    if runs_within $middle; then enough=$middle; else little=$middle; fi
  done
  for most in $(seq $((little - 35000)) 5000 $((enough + 20000))); do runs_within "$most"; done
fi

# The n-th allocation fails, for many n: always 70 and one line, or the script's normal end. Unsaved work can be
# recovered.
if [ -n "$limited" ]; then
  script some "env size 64x36
load \"$TRACK\"
move @k2 to 1 9 4
frames 120
log \"the end\""
  saved=0 ended=0
  for n in 1 10 100 1000 10000 20000 30000 40000 45000 50000 55000 60000 65000 70000 80000 100000000; do
    rm -rf "$OUT/home"
    FAIL_AT=$n LD_PRELOAD=$FAILING_NEW "$COASTER" --headless --script "$OUT/some.coaster" --config "$OUT/home" \
      --out "$OUT/run" >"$OUT/stdout" 2>"$OUT/stderr"
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

# A small stack is enough for the program and its threads; a smaller one is refused.
script ride "load \"$SOURCE/tracks/loop.json\"
ride.start
wait ride.lap == 1

shot \"\$OUT/ride.png\""
stack() {
  (
    ulimit -s "$1"
    "$COASTER" --headless --script "$OUT/ride.coaster" --out "$OUT/run" >"$OUT/stdout" 2>"$OUT/stderr"
  )
  check_code $? "$2" "ulimit -s $1"
}
[ -z "$limited" ] || stack 256 0
stack 255 70
expect_text stderr "The stack is limited to 255 kB. coaster needs 256 kB (ulimit -s 256)."

# A file over the size limit is an error like a full disk, and the old file stays.
script save "load \"$TRACK\"
save \"\$OUT/own.json\""
(
  ulimit -f 1
  "$COASTER" --headless --script "$OUT/save.coaster" --out "$OUT/run" >/dev/null 2>"$OUT/stderr"
)
check_code $? 5 "ulimit -f"
expect_text stderr "write: File too large"
[ ! -e "$OUT/run/own.json" ] || fail "half a file is left"
finish
