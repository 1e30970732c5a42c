# The command line: the meaning of each exit code, and the output on stdout and stderr.
. "$(dirname "$0")/lib.sh"

expect_code 0 --version
expect_text stdout "coaster "
expect_code 0 --help
expect_text stdout "--headless"
expect_code 0 --help-script
expect_text stdout "ride.energy_drift"
expect_text stdout "split @segment:NUMBER"
expect_code 2 --no-such-option
expect_empty stdout
expect_code 2 --size 12
expect_code 2 --frames -3
expect_code 2 a.json b.json
expect_code 2 --validate
expect_code 2 --headless
expect_text stderr "--headless needs a FILE or a --script, such as: coaster --headless FILE"

for track in "$SOURCE"/tracks/*.json; do expect_code 0 --validate "$track"; done
expect_text stdout "ok"
expect_code 3 --validate "$SOURCE/tests/tracks/truncated.json"
expect_text stderr "truncated.json:"
expect_code 3 --validate "$OUT/no-such-file.json"
expect_code 3 --validate "$OUT/notes.doc"
expect_text stderr "notes.doc: error: expected a file ending in .json, "
expect_text stderr " or .fvd, or a script ending in .coaster"
expect_code 0 --validate "$SOURCE/challenges/01_first_hill.json"
expect_text stdout "does not pass, as it must: rolled back"
# rule GOAL TRACK: writes a challenge of one goal on that start track.
rule() {
  cat >"$OUT/rule.json" <<END
{"format": "coaster-challenge", "version": 1, "name": "N", "teaches": "T", "judged": "lap", "track": "$2",
 "goals": [{"expect": "$1", "text": "x"}]}
END
}
rule "knotz == 3" "$SOURCE/tracks/gentle.json"
expect_code 3 --validate "$OUT/rule.json"
expect_text stderr 'rule.json: error: goals[0].expect:1: no query "knotz"; did you mean "knots"?'
rule "knots == 3" "no_such_track.json"
expect_code 3 --validate "$OUT/rule.json"
expect_text stderr "rule.json: error: track: "
rule "knots == 24" "$SOURCE/tracks/gentle.json"
expect_code 3 --validate "$OUT/rule.json"
expect_text stderr "its start track passes it already (gold)"
script challenge 'challenge "rule.json"
challenge "no_such.json"'
run_script 3 challenge
expect_text stderr "challenge.coaster:3:1: error:"
script good 'frames 1
expect knots == 99'
expect_code 0 --validate "$OUT/good.coaster"
script bad 'fraems 1
expect knotz == 1'
expect_code 2 --validate "$OUT/bad.coaster"
expect_text stderr "bad.coaster:2:1: error:"
expect_text stderr 'did you mean "frames"'
expect_text stderr "bad.coaster:3:8: error:"

run_script 2 bad
expect_code 2 --headless --script "$OUT/no-such-script.coaster" --out "$OUT/run"
run_script 1 good
expect_text stderr "good.coaster:3:8: error: expected knots == 99, found 0"
for file in frame.png widgets.txt state.json; do [ -s "$OUT/run/$file" ] || fail "no $file after a failure"; done
script gone 'load "gone.json"'
run_script 3 gone
script late 'wait tick == 100000 max 10 ticks'
run_script 6 late
script outside 'save "outside.json"'
run_script 2 outside
[ ! -e "$OUT/outside.json" ] && [ ! -e outside.json ] || fail "a script wrote outside of its folder"
script snap 'snap "none"'
run_script 1 snap
expect_text stderr "--update-goldens"
run_script 0 snap --update-goldens
run_script 0 snap
# What passes is not written again, though its bytes are not those that the program writes. A name of two pictures is an
# error.
printf 'trailing' >>"$OUT/golden/none.png"
cp "$OUT/golden/none.png" "$OUT/kept.png"
run_script 0 snap --update-goldens
cmp -s "$OUT/golden/none.png" "$OUT/kept.png" || fail "--update-goldens wrote a picture that passes"
script twice "snap \"twice\"
load \"$SOURCE/tracks/loop.json\"
snap \"twice\""
run_script 1 twice --update-goldens
expect_text stderr 'twice.coaster:4:1: error: snap "twice" was taken before in this run, of another picture'
script other "load \"$SOURCE/tracks/loop.json\"
snap \"none\""
run_script 1 other
expect_text stderr "of them in an 8x8 block; another driver may change 115 and 8; see "
script changed 'env size 600x300
snap "none"'
run_script 1 changed
# Files that differ say how, in their own terms.
script pictures "load \"$SOURCE/tracks/loop.json\"
shot \"\$OUT/a.png\"
move @k5 to 1 40 2
shot \"\$OUT/b.png\"
env size 600x300
shot \"\$OUT/c.png\"
expect file \"\$OUT/a.png\" same \"\$OUT/a.png\"
expect error expect file \"\$OUT/a.png\" same \"\$OUT/c.png\" ~ \"in size: 640x360 and 600x300 pixels\"
expect file \"\$OUT/a.png\" same \"\$OUT/b.png\""
run_script 1 pictures
grep -qE 'a.png differs from .*b.png in [0-9]+ of 230400 pixels, the first at x [0-9]+ y [0-9]+, by up to' \
  "$OUT/stderr" || fail "two pictures differ: $(cat "$OUT/stderr")"
# The errors of a script as JSON: those of reading, that of running, and none.
run_script 2 bad --json
python3 - "$OUT" <<'PYTHON' || fail "--json of a script that cannot be read: $(cat "$OUT/stdout")"
import json, sys
found = json.load(open(f"{sys.argv[1]}/stdout"))
assert found["code"] == 2 and [e["line"] for e in found["errors"]] == [2, 3], found
PYTHON
script passes 'repeat 5
append at 1 2 3
expect knots < 3
end'
run_script 1 passes --json
python3 - "$OUT" <<'PYTHON' || fail "--json of a script that fails: $(cat "$OUT/stdout")"
import json, sys
found = json.load(open(f"{sys.argv[1]}/stdout"))
state = json.load(open(f"{sys.argv[1]}/run/state.json"))["error"]
assert found["code"] == 1 and found["errors"] == state and len(state) == 1, (found, state)
assert state[0]["line"] == 4 and state[0]["from"][0]["pass"] == 3 and state[0]["from"][0]["of"] == 5, state
PYTHON
expect_code 0 --validate "$OUT/passes.coaster" --json
tr -d ' \n' <"$OUT/stdout" | grep -qx '{"code":0,"errors":\[\]}' || fail "--validate --json: $(cat "$OUT/stdout")"
# Two scripts of one name do not share out/NAME at once: the second is refused. One after the other they do, also after
# a kill. A folder that the user named gives a warning.
mkdir -p "$OUT/a" "$OUT/b"
cp "$OUT/passes.coaster" "$OUT/b/foo.coaster"
script a/foo 'repeat 1000000
ticks 10000000
end'
at_out() (cd "$OUT" && exec "$COASTER" --headless --script "$@")
(cd "$OUT" && exec "$COASTER" --headless --script a/foo.coaster) >"$OUT/slow" 2>&1 &
slow=$!
for _ in $(seq 100); do grep -q "^Drawing" "$OUT/slow" && break; sleep 0.1; done
at_out b/foo.coaster >"$OUT/stdout" 2>"$OUT/stderr"
check_code $? 2 "two scripts of one name"
expect_text stderr "out/foo: another run of coaster writes there; give this run a folder of its own, such as --out "
[ -z "$(ls "$OUT/out/foo")" ] || fail "the refused script wrote $(ls "$OUT/out/foo")"
at_out b/foo.coaster --out out/foo-2 >"$OUT/stdout" 2>"$OUT/stderr"
check_code $? 1 "a folder of its own"
at_out b/foo.coaster --out out/foo >"$OUT/stdout" 2>"$OUT/stderr"
check_code $? 1 "a folder that the user named"
expect_text stderr "warning: out/foo: another run of coaster writes there, too"
kill -9 $slow
wait $slow 2>/dev/null
at_out b/foo.coaster >"$OUT/stdout" 2>"$OUT/stderr"
check_code $? 1 "after a kill"

script hash "load \"$SOURCE/tracks/loop.json\"
log hash document"
run_script 0 hash
grep -qE '^[0-9a-f]{16}$' "$OUT/stdout" || fail "log hash document printed $(cat "$OUT/stdout")"

: >"$OUT/file"
expect_code 5 --headless --script "$OUT/hash.coaster" --out "$OUT/file/below"
expect_code 5 --headless "$SOURCE/tracks/loop.json" --out "$OUT/file/below"
expect_code 3 --headless "$SOURCE/tests/tracks/truncated.json" --out "$OUT/ride"
expect_code 0 --headless "$SOURCE/tests/tracks/two_knots.json" --size 320x180 --out "$OUT/ride" --json
[ -s "$OUT/ride/ride.png" ] || fail "no picture of the ride"
expect_text stdout '"top_speed_m_s"'
expect_code 0 --headless "$SOURCE/tests/tracks/two_knots.json" --size 320x180 --out "$OUT/ride" --frames 3
expect_text stdout "Two knots"
expect_text stdout "Stopped after 0 s"
# A train at rest is a stall, as in the report; all knots are at one point.
# flat COMMAND: writes the track of two knots level, and edited by that command of sed.
flat() {
  sed -e 's/"start_speed": 4/"start_speed": 0/' -e 's/3\.75/12.25/' -e "$1" \
    "$SOURCE/tests/tracks/two_knots.json" >"$OUT/flat.json"
}
flat ''
expect_code 0 --headless "$OUT/flat.json" --size 96x54 --out "$OUT/ride"
expect_text stdout "Train c1 stalled at 0.0 m"
expect_code 0 --report "$OUT/flat.json"
expect_text stdout "stalled at 0.0 m"
flat 's/30\.5, 12\.25, -2\.25/0.5, 12.25, 1.75/'
expect_code 0 --validate "$OUT/flat.json"
expect_text stderr "flat.json: warning: all 2 knots are at one point"
expect_code 0 --headless "$SOURCE/tests/tracks/ring.nltrack" --size 320x180 --out "$OUT/ride"
expect_text stdout "The train completed the lap."
expect_text stderr "The train completes the ride with a start speed of "
# A script's load reports what a FILE does, and nothing of a file without notices.
script loads "load \"$SOURCE/tests/tracks/two_knots.json\"
load \"$SOURCE/tests/tracks/jump.csv\""
run_script 0 loads
messages >"$OUT/script_notices"
expect_text script_notices "jump.csv:22: warning: the frame jumps"
expect_code 0 --headless "$SOURCE/tests/tracks/jump.csv" --size 96x54 --frames 0 --out "$OUT/ride"
messages >"$OUT/file_notices"
cmp -s "$OUT/script_notices" "$OUT/file_notices" || 
  fail "a script's load reports other notices: $(cat "$OUT/script_notices")"
# Changes by another program are not overwritten.
script theirs 'append at 0 5 0
save "$OUT/own.json"
append at 9 5 0
dump "own"
append at 9 9 0
save "$OUT/own.json"'
run_script 5 theirs
expect_text stderr "own.json was changed by another program since it was opened"
# Values that Mesa crashes on, at its start or in the first picture, and versions that are too old.
for driver in GALLIUM_DRIVER=none_such LP_NATIVE_VECTOR_WIDTH=0 LP_NATIVE_VECTOR_WIDTH=64 \
  MESA_GLSL_VERSION_OVERRIDE=130 MESA_GL_VERSION_OVERRIDE=2.1; do
  env "$driver" "$COASTER" --headless --script "$OUT/hash.coaster" --out "$OUT/run" >"$OUT/stdout" 2>"$OUT/stderr"
  [ $? = 4 ] || fail "$driver: expected exit code 4: $(cat "$OUT/stderr")"
  [ "$(messages | grep -vc '^error: ')" = 1 ] || fail "$driver: expected one line: $(cat "$OUT/stderr")"
  grep -qE "crashed at its start.* $driver|OpenGL 3.3 is needed" "$OUT/stderr" || fail "$driver: $(cat "$OUT/stderr")"
done
expect_text stderr "OpenGL 3.3 is needed"
# The library that draws; a report needs none.
for library in osmesa:OSMesa egl:EGL; do
  COASTER_HEADLESS=${library%:*} \
    "$COASTER" --headless --script "$OUT/hash.coaster" --out "$OUT/run" >"$OUT/stdout" 2>"$OUT/stderr"
  case $? in
    0)
      grep -qE "^Drawing with ${library#*:}: .+, OpenGL [0-9.]+" "$OUT/stderr" ||
        fail "$library: $(cat "$OUT/stderr")" ;;
    4) expect_text stderr "was not found" ;; # not installed
    *) fail "$library: $(cat "$OUT/stderr")" ;;
  esac
done
expect_code 0 --report "$SOURCE/tracks/loop.json"
grep -q "^Drawing" "$OUT/stderr" && fail "--report draws"
expect_code 0 --report --json "$SOURCE/tracks/loop.json"
python3 -c 'import json, sys; r = json.load(sys.stdin); assert r["lap_s"] > 10 and r["end"] is None' <"$OUT/stdout" ||
  fail "--report --json: $(cat "$OUT/stdout")"
expect_code 2 --report --frames 3 "$SOURCE/tracks/loop.json"
expect_text stderr "--frames has no effect with --report"
GALLIUM_DRIVER=llvmpipe run_script 0 hash
env -u DISPLAY -u WAYLAND_DISPLAY "$COASTER" "$SOURCE/tracks/loop.json" >"$OUT/stdout" 2>"$OUT/stderr"
check_code $? 4 "no display"
expect_text stderr "--headless"
finish
