# Challenges over several runs: medals are kept, an invalid progress file is set aside, a recording is judged the same.
. "$(dirname "$0")/lib.sh"
progress=$OUT/home/progress.json
mkdir -p "$OUT/home"
pass() { # a script that passes the challenge of the joints, in that home
  printf 'coaster-script 1\nchallenge "%s/challenges/02_smooth_joints.json"\nlengths all in 5.5 out 5.5\nexpect challenge.medal == 1\nframes 2\n' "$SOURCE" >"$OUT/pass.coaster"
  expect_code 0 --headless --script "$OUT/pass.coaster" --config "$OUT/home" --out "$OUT/run"
}
pass
grep -q '"challenge": "02_smooth_joints"' "$progress" && grep -q '"medal": 1' "$progress" || fail "the medal is not kept: $(cat "$progress")"
grep -q '"query": "challenge.deviation"' "$progress" || fail "the values are not kept"
cp "$progress" "$OUT/first.json"
pass
cmp "$progress" "$OUT/first.json" || fail "the same success changed the file"

# Garbage and a truncated file are set aside with a notice; medals start from zero.
for garbage in 'no JSON at all' "$(head -c 100 "$OUT/first.json")"; do
  rm -f "$progress".bad*  # a second one would be set aside beside it
  printf '%s' "$garbage" >"$progress"
  printf 'coaster-script 1\nexpect toast ~ "progress.json.bad"\n' >"$OUT/told.coaster"
  expect_code 0 --headless --script "$OUT/told.coaster" --config "$OUT/home" --out "$OUT/run"
  [ "$(cat "$progress.bad")" = "$garbage" ] || fail "it was not set aside"
  [ ! -e "$progress" ] || fail "it is still there"
done
pass
cmp "$progress" "$OUT/first.json" || fail "medals do not go on"

# Without a home nothing is kept; a home that cannot be written is reported.
rm -rf "$OUT/home"
expect_code 0 --headless --script "$OUT/pass.coaster" --out "$OUT/run"
[ ! -e "$OUT/home" ] || fail "a script without a home kept something"

# Recorded and replayed.
expect_code 0 --headless --script "$SOURCE/challenges/solutions/08_tired_train.coaster" --out "$OUT/run" --record "$OUT/recorded.coaster"
printf 'coaster-script 1\ninclude "recorded.coaster"\nexpect challenge.medal == 3\nexpect challenge.judged == 3\n' >"$OUT/replay.coaster"
expect_code 0 --headless --script "$OUT/replay.coaster" --out "$OUT/replayed"
finish
