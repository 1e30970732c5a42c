# A signal ends the program within a second whatever it is doing, with the unsaved changes kept.
. "$(dirname "$0")/lib.sh"
user=(--config "$OUT/home" --out "$OUT" --size 480x270)
mkdir -p "$OUT/home"
cp "$SOURCE/tracks/helix.json" "$OUT/own.json"
left() { find "$OUT/home/recovery" -name '*.info.json' ! -name '.*' 2>/dev/null | wc -l; }
script offered 'expect recoverable == 1
ui.click "Recovery/Recover"
frames 1
expect dirty == on
expect position @k2 == 3 9 4 +- 0.001
save "$OUT/saved.json"'

# ends NAME STATEMENTS SECONDS [kept]: the signal comes that long after the statements have begun.
ends() {
  script "$1" "env size 64x36
load \"\$OUT/own.json\"
move @k2 to 3 9 4
frames 1
shot \"ready.png\"
$2"
  rm -f "$OUT/ready.png"
  "$COASTER" --headless --script "$OUT/$1.coaster" "${user[@]}" >"$OUT/stdout" 2>"$OUT/stderr" &
  pid=$!
  for _ in $(seq 600); do
    [ -e "$OUT/ready.png" ] && break
    sleep 0.05
  done
  sleep "$3"
  kill -0 $pid 2>/dev/null || fail "$1 has ended before the signal: $(cat "$OUT/stderr")"
  local began ended
  began=$(date +%s%N)
  kill -15 $pid
  wait $pid 2>/dev/null
  check_code $? 143 "$1"
  ended=$(date +%s%N)
  [ $(((ended - began) / 1000000)) -le 1900 ] || fail "$1 ended after $(((ended - began) / 1000000)) ms"
  expect_text stderr "error: stopped by a signal"
  [ "$(left)" = 1 ] || fail "$1: no changes were kept"
  [ -n "${4:-}" ] || return # a track of many megabytes is not read again here
  expect_code 0 --headless --script "$OUT/offered.coaster" "${user[@]}"
}

ends ticks 'ride.start
ticks 10000000' 0.3 kept
ends frames 'frames 1000000' 0.3 kept
ends seek 'move @k1 to 16777217 -4.12 26.83
turns @s10 to 0
seek ride.speed_max == 20 by height of all' 1 kept
ends duplicate 'closed off
resolution 1
repeat 40
duplicate all
end' 3
finish
