# Movies: numbered pictures by the script's time, a file by ffmpeg if it is installed, and nothing lost if it is missing
# or fails.
. "$(dirname "$0")/lib.sh"
mkdir -p "$OUT/none" "$OUT/good" "$OUT/bad"
cat >"$OUT/good/ffmpeg" <<'END'
#!/bin/sh
printf '%s\n' "$PWD" "$@" >>"$FFMPEG_LOG"
echo "frame=3"; echo "progress=continue"
for last; do :; done
echo "a movie" >"$last"
END
cat >"$OUT/bad/ffmpeg" <<'END'
#!/bin/sh
echo "frame=1"
echo "Unknown encoder 'libx264'" >&2
exit 3
END
chmod +x "$OUT"/good/ffmpeg "$OUT"/bad/ffmpeg
export FFMPEG_LOG="$OUT/ffmpeg.log"
# with_ffmpeg WHICH CODE arguments...: runs the program with that ffmpeg, or none, in PATH. The fake ones use only
# commands built into sh.
with_ffmpeg() {
  local before=$PATH
  PATH=$OUT/$1
  expect_code "${@:2}"
  PATH=$before
}
# expect_pictures DIR N: exactly frame-00000.png to the Nth.
expect_pictures() {
  local found
  found=$(cd "$1" && echo frame-*.png)
  local wanted
  wanted=$(for ((i = 0; i < $2; ++i)); do printf 'frame-%05d.png ' "$i"; done)
  [ "$found " = "$wanted" ] || fail "$1 has $found, expected $2 pictures"
}
size_of() { od -An -tu1 -j16 -N8 "$1" | tr -s ' '; }  # of a PNG: width and height, four bytes each
# ride_script NAME LINES: writes a script that starts a ride; small.
ride_script() {
  script "$1" "env size 160x90
load \"$SOURCE/tracks/loop.json\"
panels off
camera chase
ride.start
$2"
}
# movie FFMPEG CODE NAME arguments...: runs such a script with that ffmpeg.
movie() { with_ffmpeg "$1" "$2" --headless --script "$OUT/$3.coaster" --out "$OUT/run" "${@:4}"; }

# Drawn and undrawn time count alike; 0.4 s are 12 pictures at 30, 10 at 24, 24 at 60 a second.
ride_script time 'frames 6
ticks 24
wait tick >= 48
frames 0'
for rate in 30:12 24:10 60:24; do
  movie none 0 time --movie "$OUT/m" --fps ${rate%:*}
  expect_pictures "$OUT/m" ${rate#*:}
  expect_text stderr "Saved ${rate#*:} pictures in $OUT/m. Install ffmpeg"
  [ ! -e "$OUT/m/movie.mp4" ] || fail "a movie file without ffmpeg"
done
# expect_size FILE BYTES: checks a picture's width and height, four bytes each.
expect_size() { [ "$(size_of "$1")" = " $2" ] || fail "the size of $1 is$(size_of "$1"), expected $2"; }
expect_size "$OUT/m/frame-00000.png" "0 0 0 160 0 0 0 90"
cmp -s "$OUT/m/frame-00000.png" "$OUT/m/frame-00023.png" && fail "the first and the last picture are the same"

# The same pictures again, independent of frames drawn in between; 60 a second contains every second picture of 30.
cp -r "$OUT/m" "$OUT/before"
ride_script bundled 'ticks 48'
movie none 0 bundled --movie "$OUT/m" --fps 30
for i in 00 01 02 11; do
  twice=$(printf %02d $((2 * 10#$i)))
  cmp -s "$OUT/m/frame-000$i.png" "$OUT/before/frame-000$twice.png" ||
    fail "picture $i differs between 30 and 60 a second"
done

# ffmpeg runs in the folder of the pictures; the user's files there are not changed.
echo mine >"$OUT/m/frame-1.png"
movie good 0 time --movie "$OUT/m" --gif
expect_text stderr "Saved 12 pictures in $OUT/m, with movie.mp4 and movie.gif."
[ "$(cat "$OUT/m/frame-1.png")" = mine ] || fail "a file that is no picture of a movie was removed"
[ -s "$OUT/m/movie.mp4" ] && [ -s "$OUT/m/movie.gif" ] || fail "no movie files"
[ "$(grep -cx "$OUT/m" "$FFMPEG_LOG")" = 2 ] || fail "ffmpeg did not run in the folder of the pictures"
for word in frame-%05d.png -framerate 30 12 yuv420p mp4 gif; do
  grep -qx -- "$word" "$FFMPEG_LOG" || fail "ffmpeg did not get the argument $word"
done

# A failure of ffmpeg gives one line and does not fail the program.
movie bad 0 time --movie "$OUT/m2"
expect_text stderr "Saved 12 pictures in $OUT/m2."
expect_text stderr "There is no movie.mp4 because ffmpeg failed: Unknown encoder 'libx264'"
[ "$(messages | wc -l)" = 1 ] || fail "more than one line about ffmpeg"
expect_pictures "$OUT/m2" 12

# One lap of a track, and a given number of pictures.
with_ffmpeg none 0 --headless --movie "$OUT/ride" --frames 3 --size 161x91 --camera ride "$SOURCE/tracks/loop.json"
expect_pictures "$OUT/ride" 3
expect_size "$OUT/ride/frame-00002.png" "0 0 0 161 0 0 0 91"
with_ffmpeg none 0 --headless --movie "$OUT/lap" --fps 10 --size 64x36 --json "$SOURCE/tests/tracks/two_knots.json"
seconds=$(sed -n 's/.*"time_s": \([0-9]*\).*/\1/p' "$OUT/stdout")
pictures=$(ls "$OUT/lap" | wc -l)
[ "$pictures" -ge $((10 * seconds)) ] && [ "$pictures" -le $((10 * seconds + 11)) ] ||
  fail "$pictures pictures of a ride of $seconds s"

# By statement: only below $OUT, at known rates, one at a time, of one size.
ride_script said 'movie.start "$OUT/a b" fps 60
ticks 10
expect movie.frames == 5
movie.stop
ticks 10
expect movie.frames == 5
expect file "$OUT/a b/frame-00004.png" exists
expect not file "$OUT/a b/frame-00005.png" exists
expect error movie.stop ~ "no movie"'
movie good 0 said
[ -s "$OUT/run/a b/movie.mp4" ] || fail "no movie in a folder with a blank"
ride_script outside 'movie.start "elsewhere"'
run_script 2 outside
ride_script rate 'movie.start "$OUT/m" fps 25'
expect_code 2 --validate "$OUT/rate.coaster"
expect_text stderr 'found "25"'
ride_script twice 'movie.start "$OUT/m"
expect error movie.start "$OUT/n" ~ "already"'
movie none 0 twice
ride_script resized 'movie.start "$OUT/m"
ticks 4
resize 200x90
ticks 8
movie.stop'
movie none 2 resized
expect_text stderr "160x90 became 200x90"
expect_code 2 --movie "$OUT/m" "$SOURCE/tracks/loop.json"
expect_code 2 --headless --movie "$OUT/m" --fps 25 "$SOURCE/tracks/loop.json"
: >"$OUT/file"
expect_code 5 --headless --movie "$OUT/file/m" "$SOURCE/tracks/loop.json"

# By hand: from the menu until Stop, or until the ride is over; the pictures show only the scene, not the bar.
script hand "env size 640x360
load \"$SOURCE/tests/tracks/two_knots.json\"
"'name "By hand"
ui.menu "File/Record movie"
frames 12
expect visible "Movie/Stop"
expect movie.frames >= 6
expect toast ~ "Recording one lap as pictures in"
expect toast ~ "Without ffmpeg there is no movie file"
shot "$OUT/bar.png"
ui.click "Movie/Stop"
frames 1
expect not visible "Movie/Stop"
expect toast ~ "by-hand-movie-1. Install ffmpeg"
expect file "$OUT/by-hand-movie-1/frame-00005.png" exists
key Shift+F12
expect ride.state == running
wait ride.state != running max 14400 ticks
frames 2
expect not visible "Movie/Stop"
expect toast ~ "by-hand-movie-2. Install ffmpeg"'
with_ffmpeg none 0 --headless --script "$OUT/hand.coaster" --out "$OUT/hand"
expect_size "$OUT/hand/by-hand-movie-1/frame-00000.png" "0 0 2 128 0 0 1 104"  # as large as the window

# A movie changes neither document nor motion.
ride_script hashes 'frames 7
ticks 13
log hash document hash motion'
run_script 0 hashes
plain=$(cat "$OUT/stdout")
movie none 0 hashes --movie "$OUT/m" --fps 24
[ "$plain" = "$(cat "$OUT/stdout")" ] || fail "recording a movie changes the motion"
finish
