# The program's output cannot control the terminal, and output that cannot be written is an error.
. "$(dirname "$0")/lib.sh"
esc=$(printf '\033[31m')
csi=$(printf '\302\23331m') # the same in one character, U+009B
# harmless WHAT: checks that the last run printed no control characters.
harmless() {
  LC_ALL=C grep -nP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]' "$OUT/stdout" "$OUT/stderr" &&
    fail "$1 is printed unchanged"
}

# Paths, options and lines.
printf 'no json' >"$OUT/a$esc.json"
for path in "$OUT/a$esc.json" "$OUT/none$esc$csi.json"; do
  expect_code 3 --validate "$path"
  expect_text stderr '\u001b[31m'
  harmless "a path"
  expect_code 3 --headless "$path" --out "$OUT/run"
  harmless "a path"
  script try "load \"$path\""
  run_script 3 try
  harmless "a path of a script"
done
expect_code 2 "--splat$esc"
harmless "an option"
for line in "splat$esc" "log \"$csi\" splat" "include \"none$csi\"" "expect knots == $csi" \
  "ui.click \"$csi\"" "log \"$csi\""; do
  script try "$line"
  "$COASTER" --headless --script "$OUT/try.coaster" --out "$OUT/run" >"$OUT/stdout" 2>"$OUT/stderr"
  grep -qF '\u00' "$OUT/stdout" "$OUT/stderr" || fail "$line: $(cat "$OUT/stderr")"
  harmless "$line"
done
: >"$OUT/file"
expect_code 5 --headless "$SOURCE/tracks/loop.json" --out "$OUT/file/$esc"
harmless "a folder"

# Names from files, in text and in JSON.
sed 's/"name": "[^"]*"/"name": "Two \\u009b31m"/' "$SOURCE/tests/tracks/two_knots.json" >"$OUT/named.json"
grep -q u009b31m "$OUT/named.json" || fail "the track has no name"
for options in "--size 96x54 --frames 1 --out $OUT/run" "--size 96x54 --frames 1 --out $OUT/run --json" --report \
  "--report --json"; do
  # shellcheck disable=SC2086
  expect_code 0 --headless "$OUT/named.json" $options
  expect_text stdout 'Two \u009b31m'
  harmless "a name"
done
sed 's/"name":/"na\\u009b31mme": 1, "name":/' "$SOURCE/tests/tracks/two_knots.json" >"$OUT/unknown.json"
expect_code 0 --validate "$OUT/unknown.json"
harmless "an unknown member"

# A full disk.
for words in --help --version --help-script --help-man --help-completion "--validate $SOURCE/tracks/loop.json" \
  "--report $SOURCE/tracks/loop.json"; do
  "$COASTER" $words >/dev/full 2>"$OUT/stderr"
  check_code $? 5 "coaster $words >/dev/full"
  expect_text stderr "standard output cannot be written: No space left on device"
done
script try 'log "a line"'
"$COASTER" --headless --script "$OUT/try.coaster" --out "$OUT/run" >/dev/full 2>"$OUT/stderr"
check_code $? 5 "log >/dev/full"

# A closed stdout: no file takes its number.
script try 'repeat 3000
log "MISPLACED"
end'
for closed in '>&-' '>&- 2>&-' '<&- >&- 2>&-'; do
  rm -rf "$OUT/run"
  eval '"$COASTER" --headless --script "$OUT/try.coaster" --out "$OUT/run" --record "$OUT/run/r.coaster" '"$closed"
  check_code $? 5 "$closed"
  grep -rqF MISPLACED "$OUT/run" && fail "$closed: what is printed went to a file"
done

# A recording that a full disk ends.
script try 'repeat 3000
move @k2 to 1 9 4
move @k2 to 2 9 4
end'
sed -i '1a load "'"$SOURCE/tests/tracks/two_knots.json"'"' "$OUT/try.coaster"
(
  ulimit -f 20
  "$COASTER" --headless --script "$OUT/try.coaster" --out "$OUT/run" --record "$OUT/run/r.coaster" \
    >"$OUT/stdout" 2>"$OUT/stderr"
)
check_code $? 5 "a recording that cannot be written"
expect_text stderr "r.coaster: the recording cannot be written: File too large"

script try 'expect knots == 77'
"$COASTER" --headless --script "$OUT/try.coaster" --out "$OUT/run" >/dev/full 2>"$OUT/stderr"
check_code $? 1 "a failed expectation"
finish
