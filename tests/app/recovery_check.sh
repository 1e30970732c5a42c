# Programs that are killed, receive a signal, or run at the same time: unsaved changes are offered for recovery, and two
# programs never write the same file.
. "$(dirname "$0")/lib.sh"
user=(--config "$OUT/home" --out "$OUT" --size 480x270)
run() { expect_code "$1" --headless --script "$OUT/$2.coaster" "${user[@]}"; }
# Runs a script in the background until it has written its picture ready.png; its process is $pid.
launch() {
  rm -f "$OUT/ready.png"
  # A shell's background jobs ignore SIGINT and SIGQUIT from their start on, which the program respects.
  env --default-signal "${@:2}" "$COASTER" --headless --script "$OUT/$1.coaster" "${user[@]}" >"$OUT/stdout.$1" \
    2>"$OUT/stderr.$1" &
  pid=$!
  for _ in $(seq 600); do
    [ -e "$OUT/ready.png" ] && return
    kill -0 $pid 2>/dev/null || break
    sleep 0.05
  done
  fail "$1 did not get ready: $(cat "$OUT/stderr.$1")"
}
left() { find "$OUT/home/recovery" -name '*.info.json' ! -name '.*' | wc -l; }

mkdir -p "$OUT/home"
echo '{"format": "coaster-settings", "version": 1, "autosave_seconds": 5}' >"$OUT/home/settings.json"
cp "$SOURCE/tracks/gentle.json" "$OUT/own.json"
chmod 640 "$OUT/own.json"
cp "$OUT/own.json" "$OUT/before.json"

# kill -9: the timer's autosave exists, the file is unchanged.
script killed 'env size 64x36
load "$OUT/own.json"
move @k2 to 3 9 4
frames 290
expect autosaves == 0
wait autosaves == 1 max 60 frames
frames 340
expect autosaves == 1
shot "ready.png"
frames 1000000'
launch killed
kill -9 $pid
wait $pid 2>/dev/null
cmp "$OUT/own.json" "$OUT/before.json" || fail "the file has changed"
[ "$(left)" = 1 ] || fail "no autosave was left"

# Later keeps it; the dialog shows both times; then it is recovered, unsaved, and saved to its original file.
script later 'expect recoverable == 1
expect visible "Recovery/File saved"
expect visible "Recovery/Autosaved"
ui.click "Recovery/Later"
expect recoverable == 0
expect not visible "Recovery/Question"'
run 0 later
[ "$(left)" = 1 ] || fail "Later lost the autosave"
script recover 'expect recoverable == 1
ui.click "Recovery/Recover"
frames 1
expect track_file == "own.json"
expect dirty == on
expect position @k2 == 3 9 4 +- 0.001
expect autosaves == 1
key Ctrl+S
expect dirty == off
expect locked_by == ""
key Ctrl+Q'
run 0 recover
cmp -s "$OUT/own.json" "$OUT/before.json" && fail "what was recovered is not saved"
[ "$(stat -c %a "$OUT/own.json")" = 640 ] || fail "the file's mode has changed"
[ "$(left)" = 0 ] || fail "an autosave is left of what is saved"

# SIGTERM, SIGINT, SIGHUP, SIGPIPE, SIGQUIT, SIGXCPU: autosaved at once, exit code 128 plus the signal's number.
script signalled 'env size 64x36
load "$OUT/own.json"
move @k2 to 5 8 4
log "moved"
shot "ready.png"
frames 1000000'
for signal in 15 2 1 13 3 24 10 12 30; do
  launch signalled
  kill -$signal $pid
  wait $pid
  code=$?
  [ $code = $((128 + signal)) ] || fail "signal $signal: exit code $code"
  [ "$(left)" = 1 ] || fail "signal $signal: no autosave was left"
  expect_text stdout.signalled moved
  expect_text stderr.signalled "error: stopped by a signal"
  script drop 'expect recoverable == 1
ui.click "Recovery/Discard"
frames 1
expect recoverable == 0
expect knots == 0'
  run 0 drop
  [ "$(left)" = 0 ] || fail "Discard left an autosave"
done
find "$OUT/home/recovery" -type f | grep . && fail "files are left in the recovery folder"

# As nohup starts it: SIGHUP changes nothing.
launch signalled --ignore-signal=HUP
kill -HUP $pid
sleep 0.3
kill -0 $pid 2>/dev/null || fail "an ignored signal ended the program"
kill -TERM $pid
wait $pid
check_code $? 143 "SIGTERM after an ignored SIGHUP"
script drop 'ui.click "Recovery/Discard"
frames 1'
run 0 drop

# The same without a folder for autosaves. Whatever else ends the program, the lines it has printed are there.
user=(--out "$OUT" --record "$OUT/recorded.coaster")
for signal in 15 9; do
  rm -f "$OUT/recorded.coaster"
  launch signalled
  kill -$signal $pid
  wait $pid 2>/dev/null
  check_code $? $((128 + signal)) "signal $signal"
  expect_text stdout.signalled moved
  if [ $signal = 15 ]; then
    expect_text stderr.signalled "error: stopped by a signal"
    expect_text recorded.coaster "move @k2 to 5 8 4"
  fi
done
user=(--config "$OUT/home" --out "$OUT" --size 480x270)

# Two programs and one file, by its name and by a link.
ln -s own.json "$OUT/link.json"
script first 'env size 64x36
load "$OUT/own.json"
shot "ready.png"
frames 1000000'
launch first
cp "$OUT/own.json" "$OUT/before.json"
script second 'load "$OUT/link.json"
expect toast ~ "is open in another coaster (process"
expect locked_by ~ "process"
move @k2 to 9 9 9
expect error save "$OUT/own.json" ~ "under another name"
expect error save "$OUT/link.json" ~ "under another name"
key Ctrl+S
expect visible "Save as/Name"
ui.type "Save as/Name" "$OUT/own.json"
expect toast ~ "under another name"
expect dirty == on
save "$OUT/other.json"
expect locked_by == ""
expect dirty == off'
run 0 second
cmp "$OUT/own.json" "$OUT/before.json" || fail "the locked file was written"
kill -9 $pid
wait $pid 2>/dev/null
[ -e "$OUT/.own.json.lock" ] || fail "the killed program had no lock"
script third 'load "$OUT/link.json"
expect locked_by == ""
move @k2 to 7 7 7
expect error save "$OUT/link.json" ~ "is a symbolic link"
save "$OUT/own.json"
expect dirty == off'
run 0 third
[ -L "$OUT/link.json" ] || fail "the link was replaced"
cmp -s "$OUT/own.json" "$OUT/before.json" && fail "the file was not saved"
[ ! -e "$OUT/.own.json.lock" ] || fail "a lock is left"

# A folder for autosaves that cannot be created: one notice, and the program continues.
rm -rf "$OUT/home/recovery"
: >"$OUT/home/recovery"
script unwritable 'env size 64x36
load "$OUT/own.json"
move @k2 to 3 3 3
wait toast ~ "The autosave failed" max 400 frames
frames 340
expect autosaves == 0
expect dirty == on
save "$OUT/own.json"
expect dirty == off'
run 0 unwritable
finish
