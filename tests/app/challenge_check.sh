# Challenges over several runs: medals are kept, an invalid progress file is set aside, a recording is judged the same.
. "$(dirname "$0")/lib.sh"
progress=$OUT/home/progress.json
mkdir -p "$OUT/home"
script pass "challenge \"$SOURCE/challenges/02_smooth_joints.json\"
lengths all in 5.5 out 5.5
expect challenge.medal == 1
frames 2"
pass() { run_script 0 pass --config "$OUT/home"; }
expect_kept() { grep -qF "$1" "$progress" || fail "$1 is not kept: $(cat "$progress")"; }
pass
expect_kept '"challenge": "02_smooth_joints"'
expect_kept '"medal": 1'
expect_kept '"query": "challenge.deviation"'
cp "$progress" "$OUT/first.json"
pass
cmp "$progress" "$OUT/first.json" || fail "the same success changed the file"

# Garbage and a truncated file are set aside with a notice; medals start from zero.
script aside 'expect toast ~ "progress.json.bad"'
for garbage in 'no JSON at all' "$(head -c 100 "$OUT/first.json")"; do
  rm -f "$progress".bad*  # a second one would be set aside beside it
  printf '%s' "$garbage" >"$progress"
  run_script 0 aside --config "$OUT/home"
  [ "$(cat "$progress.bad")" = "$garbage" ] || fail "it was not set aside"
  [ ! -e "$progress" ] || fail "it is still there"
done
pass
cmp "$progress" "$OUT/first.json" || fail "medals are not earned again"

# Without a home nothing is kept; a home that cannot be written is reported.
rm -rf "$OUT/home"
run_script 0 pass
[ ! -e "$OUT/home" ] || fail "a script without a home kept something"

# Recorded and replayed.
expect_code 0 --headless --script "$SOURCE/challenges/solutions/08_tired_train.coaster" --out "$OUT/run" \
  --record "$OUT/recorded.coaster"
script replay 'include "recorded.coaster"
expect challenge.medal == 3
expect challenge.judged == 3'
run_script 0 replay
finish
