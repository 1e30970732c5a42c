# Runs replace, empty and remove only what runs made: files of the user stay, with the reason, whatever a script or an
# option names. What runs made is replaced by later runs.
. "$(dirname "$0")/lib.sh"
TRACK=$SOURCE/tests/tracks/two_knots.json
kReason="no run of coaster made this file"

# mine FILE...: makes a run folder with these files of the user.
mine() {
  rm -rf "$OUT/run"
  mkdir -p "$OUT/run"
  local file
  for file; do
    mkdir -p "$(dirname "$OUT/run/$file")"
    echo "mine" >"$OUT/run/$file"
  done
  files=("$@")
}
stay() {
  local file
  for file in "${files[@]}"; do
    [ "$(cat "$OUT/run/$file" 2>/dev/null)" = mine ] || fail "$1: $file was replaced or removed"
  done
}
# kept LINE FILE...: a script with this line ends with code 2 and the reason, and the user's files stay. Without them it
# works, twice.
kept() {
  local line=$1
  shift
  mine "$@"

  printf 'coaster-script 1\nenv size 96x54\nload "%s"\nframes 1\n%b\n' "$TRACK" "$line" >"$OUT/try.coaster"
  run_script 2 try
  expect_text stderr "$kReason"
  stay "$line"
  rm -rf "$OUT/run"
  run_script 0 try
  run_script 0 try
}
kept 'env home "$OUT/docs"\nframes 2' docs/letter.txt
kept 'env home "$OUT/docs"\nframes 2' docs/deep/settings.json docs/deep/er/x
kept 'movie.start "$OUT/mine"\nticks 8\nmovie.stop' mine/frame-00000.png mine/frame-00001.png
kept 'movie.start "$OUT/mine"\nticks 8\nmovie.stop' mine/frame-00555.png
kept 'shot "$OUT/a.png"' a.png
kept 'save "$OUT/a.json"' a.json
kept 'save "$OUT/a.json" overwrite' a.json
kept 'save "$OUT/a.obj"' a.mtl
kept 'save "$OUT/a.svg"' a.svg
kept 'report "$OUT/r.txt"' r.txt
kept 'report "$OUT/r.csv"' r.csv
kept 'shot "$OUT/a.png"\nsheet "$OUT/sheet.png" "a.png"' sheet.png
kept 'dump "d"' d.frame.png
kept 'dump "d"' d.widgets.txt
kept 'dump "d"' d.state.json
kept 'dump "d"' d.json

# In a folder of the user, such as the current one.
mine README.md sub/x
mkdir "$OUT/run/sub/empty"
printf 'coaster-script 1\nenv size 96x54\nenv home "$OUT/sub"\nframes 2\n' >"$OUT/try.coaster"
(cd "$OUT/run" && "$COASTER" --headless --script ../try.coaster --out . 2>"$OUT/stderr")
check_code $? 2 "env home in the current folder"
expect_text stderr "$kReason"
stay "env home"
[ -d "$OUT/run/sub/empty" ] || fail "an empty folder is gone"

# Recordings and the track beside them.
for name in rec.coaster rec.json rec-2.json; do
  mine "$name"
  code=5
  [ $name != rec-2.json ] || code=2  # of the statement that opens a second track
  printf 'coaster-script 1\nenv size 96x54\nload "%s"\n' "$TRACK" >"$OUT/try.coaster"
  run_script $code try --record "$OUT/run/rec.coaster"
  stay "--record beside $name"
done
rm -rf "$OUT/run"
run_script 0 try --record "$OUT/run/rec.coaster"
run_script 0 try --record "$OUT/run/rec.coaster"

# Saving a track over its own file is what its user asks for.
mine
cp "$TRACK" "$OUT/run/own.json"
printf 'coaster-script 1\nload "$OUT/own.json"\nstart_speed 7\nsave "$OUT/own.json"\n' >"$OUT/try.coaster"
run_script 0 try
cmp -s "$TRACK" "$OUT/run/own.json" && fail "a track was not saved over its own file"
finish
