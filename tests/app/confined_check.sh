# A script writes nothing outside its folder, for any links, hard links and pipes prepared there.
. "$(dirname "$0")/lib.sh"
TRACK=$SOURCE/tests/tracks/two_knots.json
away=$OUT/away
mkdir -p "$away" "$OUT/bin"
cat >"$OUT/bin/ffmpeg" <<'END'
#!/bin/sh
for last; do :; done
echo "a movie" >"$last"
END
chmod +x "$OUT/bin/ffmpeg"
PATH=$OUT/bin:$PATH

# prepare LINK...: makes a run folder of these dangling links, each to a file of the same name outside.
prepare() {
  rm -rf "$OUT/run"
  mkdir -p "$OUT/run"
  local link
  for link; do
    mkdir -p "$(dirname "$OUT/run/$link")"
    ln -s "$away/$(basename "$link")" "$OUT/run/$link"
  done
}
# run CODE TEXT arguments...: runs a script of these lines.
run() {
  printf 'coaster-script 1\nenv size 96x54\nload "%s"\n%b' "$TRACK" "$2" >"$OUT/try.coaster"
  run_script "$1" try "${@:3}"
  [ "$1" != 2 ] || expect_text stderr "is a symbolic link; this run writes only below $OUT/run"
  nothing_outside "$2 ${*:3}"
}
nothing_outside() {
  [ -z "$(ls -A "$away")" ] || fail "$1 wrote outside: $(ls -A "$away")"
  rm -rf "$away"
  mkdir "$away"
}

# A link instead of the file ends a script with code 2; not even its evidence is written through a link.
prepare a.json
run 2 'save "$OUT/a.json"\n'
[ ! -e "$OUT/run/frame.png" ] && fail "the evidence of a failure is missing"
prepare frame.png widgets.txt state.json
run 1 'expect knots == 77\n'

# refused LINE...: each statement fails because of a link.
refused() {
  local lines= line
  for line; do lines+="expect error $line ~ \"is a symbolic link; this run writes only below $OUT/run\"\n"; done
  run 0 "measure\nwait measuring == off max 20000 frames\nshot \"\$OUT/good.png\"\n$lines"
}
prepare a.{json,png,csv,txt,gltf,new.png} b.frame.png c.widgets.txt d.state.json e.json sheet.png
refused 'save "$OUT/a.json"' 'save "$OUT/a.gltf"' 'shot "$OUT/a.png"' 'snap a' 'sheet "$OUT/sheet.png" "good.png"' \
  'dump "b"' 'dump "c"' 'dump "d"' 'dump "e"' 'report "$OUT/a.csv"' 'report "$OUT/a.txt"' \
  'section.save "$OUT/a.json" @q1' 'measure.save "$OUT/a.json"'

# Links instead of a folder.
prepare
ln -s "$away" "$OUT/run/in"
refused 'save "$OUT/in/a.json"' 'shot "$OUT/in/a.png"' 'dump "in/a"' 'snap in/a' 'env home "$OUT/in/home"' \
  'movie.start "$OUT/in/m"' 'movie.start "$OUT/in"'

# Movies: pictures and the file that ffmpeg writes; by statement and by option.
# stays FILE: checks that the link is still there.
stays() { [ -L "$OUT/run/$1" ] || fail "the link $1 was replaced"; }
prepare m/frame-00000.png
printf 'coaster-script 1\nenv size 96x54\nload "%s"\nmovie.start "$OUT/m"\n' "$TRACK" >"$OUT/try.coaster"
run_script 2 try
expect_text stderr "no run of coaster made this file"
stays m/frame-00000.png
prepare
run 0 'movie.start "$OUT/m"\nticks 8\nmovie.stop\n'
[ "$(cat "$OUT/run/m/movie.mp4")" = "a movie" ] || fail "no movie file"
prepare m/movie.mp4
run 0 'movie.start "$OUT/m"\nticks 8\nmovie.stop\n'
expect_text stderr "movie.mp4: is a symbolic link"
run 0 'ticks 8\n' --movie "$OUT/run/m"

# Recordings are refused where a link is.
for name in rec.coaster rec.json; do
  prepare "$name"
  run 5 "load \"$TRACK\"\n" --record "$OUT/run/rec.coaster"
  expect_text stderr "is a symbolic link"
  stays "$name"
done
prepare rec-2.json
run 2 "load \"$TRACK\"\n" --record "$OUT/run/rec.coaster"
stays rec-2.json

# The user's folder of a script: links in it are no way out; no lock next to a file outside.
for link in home/settings.json home/recovery; do
  prepare "$link"
  printf 'coaster-script 1\nenv home "$OUT/home"\n' >"$OUT/try.coaster"
  run_script 2 try
  stays "$link"
done
nothing_outside "env home"
prepare
cp "$TRACK" "$away/foreign.json"
script home "env size 96x54
env home \"\$OUT/home\"
load \"$away/foreign.json\"
load \"$away/foreign.json\"
frames 2
move @k1 to 1 2 3
frames 4000"
ln "$away/foreign.json" "$OUT/foreign.json"
touch "$away/.foreign.json.lock"
run_script 0 home
[ -e "$away/.foreign.json.lock" ] || fail "a lock outside was deleted"
cmp -s "$away/foreign.json" "$TRACK" || fail "a track outside was changed"
rm -f "$away/foreign.json" "$away/.foreign.json.lock" "$OUT/foreign.json"
nothing_outside "env home"
prepare
run 0 'env home "$OUT/home"\nsave "$OUT/a.json"\nframes 2\n'

# A photo takes the next number.
prepare two-knots-1.png
run 0 'key f12\nframes 2\n'

# A hard link is replaced where a run made a file of that name; a pipe is refused.
prepare
run 0 'save "$OUT/a.json"\n'
echo victim >"$OUT/victim"
ln -f "$OUT/victim" "$OUT/run/a.json"
mkfifo "$OUT/run/b.json"
run 0 'save "$OUT/a.json"\n'
[ "$(cat "$OUT/victim")" = victim ] || fail "a hard link was written through"
run 5 'save "$OUT/b.json"\n'

# --out itself may be a link.
prepare
mv "$OUT/run" "$OUT/real"
ln -s real "$OUT/run"
run 0 'save "$OUT/a.json"\nshot "$OUT/b/a.png"\n'
[ -f "$OUT/real/a.json" ] && [ -f "$OUT/real/b/a.png" ] || fail "a folder named by a link was not written to"

# Without --out nobody named the folder: no link on the way is followed, and a script's name leads nowhere else.
# here CODE arguments...: runs the program in the run folder.
here() {
  local wanted=$1
  shift
  (cd "$OUT/run" && "$COASTER" --headless "$@" >"$OUT/stdout" 2>"$OUT/stderr")
  check_code $? "$wanted" "coaster $*"
  nothing_outside "$*"
}
prepare
script run/ride 'env size 96x54
save "$OUT/a.json"'
cp "$OUT/run/ride.coaster" "$OUT/run/...coaster"
here 2 --script ...coaster
[ ! -e "$OUT/run/a.json" ] || fail "a script's name led it out of the folder"
here 0 --script ride.coaster
[ -f "$OUT/run/out/ride/a.json" ] || fail "nothing was written to out/ride"
for link in out/ride out; do
  rm -rf "$OUT/run/out"
  mkdir -p "$(dirname "$OUT/run/$link")"
  ln -s "$away" "$OUT/run/$link"
  here 2 --script ride.coaster
  expect_text stderr "$link: is a symbolic link"
done
here 2 "$TRACK" --size 96x54 --frames 1
expect_text stderr "out: is a symbolic link"

# Golden pictures lie below the script's folder.
ln -s "$away" "$OUT/golden"
script golden 'env size 96x54
snap a'
run_script 2 golden --update-goldens
nothing_outside "--update-goldens"
finish
