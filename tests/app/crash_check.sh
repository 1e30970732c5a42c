# Crashes on purpose at every place of a frame, in a job, and in every way: one line says what failed, and the next
# start offers the work as it was when the last command had ended.
. "$(dirname "$0")/lib.sh"
user=(--config "$OUT/home" --out "$OUT" --size 480x270)
mkdir -p "$OUT/home"
cp "$SOURCE/tracks/gentle.json" "$OUT/own.json"
cp "$SOURCE/tests/tracks/hills.csv" "$OUT/hills.csv"
sanitized=yes # they print a report, too
[ -z "${FAILING_NEW:-}" ] || sanitized=
left() { find "$OUT/home/recovery" -name '*.info.json' ! -name '.*' 2>/dev/null | wc -l; }

# crash NAME STATEMENTS...: runs a script that changes the track and crashes; its exit code is $code.
crash() {
  script "$1" "env size 480x270
load \"\$OUT/own.json\"
move @k2 to 3 9 4
frames 1
$2"
  (
    ulimit -c 0
    [ -z "${limit:-}" ] || ulimit -v "$limit"
    exec "$COASTER" --headless --script "$OUT/$1.coaster" "${user[@]}" >"$OUT/stdout" 2>"$OUT/stderr.all"
  ) 2>/dev/null
  code=$?
  grep -v -e '^Drawing with' -e '^==' "$OUT/stderr.all" >"$OUT/stderr"
}
# recovers NAME: the work is offered, is as it was, and nothing is left when it has been discarded again.
script offered 'expect recoverable == 1
ui.click "Recovery/Recover"
frames 1
expect track_file == "own.json"
expect dirty == on
expect position @k2 == 3 9 4 +- 0.001
expect not visible "Recovery/Question"
key Ctrl+S
expect dirty == off
key Ctrl+Q'
recovers() {
  [ "$(left)" = 1 ] || fail "$1: no autosave was left"
  expect_code 0 --headless --script "$OUT/offered.coaster" "${user[@]}"
  find "$OUT/home/recovery" -type f | grep . && fail "$1: files are left in the recovery folder"
  cp "$SOURCE/tracks/gentle.json" "$OUT/own.json"
}
kept="Unsaved changes were kept, and the next start offers them."
one_line() {
  [ -n "$sanitized" ] || [ "$(wc -l <"$OUT/stderr")" = 1 ] || fail "$1: expected one line: $(cat "$OUT/stderr")"
}

for place in input panels command ticks findings drawing keeping; do
  crash "$place" "fault crash $place
move @k3 to 9 9 9
frames 1"
  [ $code -ge 128 ] || [ -n "$sanitized" ] || fail "$place: exit code $code"
  expect_text stderr "coaster crashed (SIGSEGV, an invalid memory access). $kept"
  one_line "$place"
  recovers "$place"
done

crash job 'fault crash job
fault import slow 5
drop "$OUT/hills.csv"
ui.click "Unsaved changes/Discard"
frames 20'
expect_text stderr "coaster crashed (SIGSEGV, an invalid memory access). $kept"
one_line job
recovers job

for way in check exception stack; do
  crash "$way" "fault crash drawing $way
frames 1"
  case $way in
    check) expect_text stderr "check failed: top != 0 (a planned crash). $kept" ;;
    exception) expect_text stderr "coaster crashed (exception: a planned crash). $kept" ;;
    stack) expect_text stderr "coaster crashed (SIGSEGV, an invalid memory access). $kept" ;;
  esac
  one_line "$way"
  recovers "$way"
done

if [ -z "$sanitized" ]; then # sanitizers reserve terabytes of address space
  limit=2500000 crash memory 'fault crash drawing memory
frames 1'
  check_code $code 70 "memory"
  expect_text stderr "Out of memory. $kept"
  one_line memory
  recovers memory
fi

# launch STATEMENTS: runs a script in the background until it has written ready.png; its process is $pid.
launch() {
  script launched "env size 64x36
load \"\$OUT/own.json\"
move @k2 to 3 9 4
$1
shot \"ready.png\"
frames 1000000"
  rm -f "$OUT/ready.png"
  (
    ulimit -c 0
    exec "$COASTER" --headless --script "$OUT/launched.coaster" "${user[@]}" >"$OUT/stdout" 2>"$OUT/stderr"
  ) &
  pid=$!
  for _ in $(seq 600); do
    [ -e "$OUT/ready.png" ] && return
    kill -0 $pid 2>/dev/null || break
    sleep 0.05
  done
  fail "did not get ready: $(cat "$OUT/stderr")"
}
# Signals of crashes from another process end the program at once.
if [ -z "$sanitized" ]; then
  for signal in 6 11 7 8 4; do
    launch 'frames 1'
    kill -$signal $pid
    wait $pid 2>/dev/null
    check_code $? $((128 + signal)) "signal $signal"
    expect_text stderr "$kept"
    recovers "signal $signal"
  done
  # No room for the copy: the autosave before it stays complete.
  echo '{"format": "coaster-settings", "version": 1, "autosave_seconds": 5}' >"$OUT/home/settings.json"
  launch 'wait autosaves == 1 max 400 frames
move @k3 to 9 9 9
frames 1'
  prlimit --pid $pid --fsize=1000 # more than the line, less than the track
  kill -11 $pid
  wait $pid 2>/dev/null
  expect_text stderr "Unsaved changes could not be written."
  recovers full
fi
finish
