# --help, the manual page and the completion name the same options, and the program accepts them.
. "$(dirname "$0")/lib.sh"
expect_code 0 --help
grep -oE '^ +(-h,)?--[a-z-]+' "$OUT/stdout" | grep -oE -- '--[a-z-]+' | sort >"$OUT/help.options"
expect_code 0 --help-man
cp "$OUT/stdout" "$OUT/coaster.6"
expect_code 0 --help-completion
cp "$OUT/stdout" "$OUT/coaster.bash"
sed -n 's/^\\fB\(\(\\-\)\{2\}[a-z\\-]*\)\\fR.*/\1/p' "$OUT/coaster.6" | sed 's/\\//g' | sort >"$OUT/man.options"
# same_options NAME WHAT: compares the options in NAME.options with those of --help.
same_options() {
  cmp -s "$OUT/help.options" "$OUT/$1.options" ||
    fail "--help and the $2 differ: $(diff "$OUT/help.options" "$OUT/$1.options")"
}
same_options man "manual page"
[ "$(wc -l <"$OUT/help.options")" -ge 20 ] || fail "only $(wc -l <"$OUT/help.options") options in --help"
# Every option is accepted: an unknown one would give exit code 2 and its name.
while read -r option; do
  "$COASTER" "$option" --no-such-option >/dev/null 2>"$OUT/stderr"
  grep -q -- "not expected: $option" "$OUT/stderr" && fail "--help names $option, which is unknown"
done <"$OUT/help.options"

version=$("$COASTER" --version | head -n 1)
wanted=$(sed -n 's/^project(coaster VERSION \([0-9.]*\).*/\1/p' "$SOURCE/CMakeLists.txt")
[ "$version" = "coaster $wanted" ] || fail "--version prints $version, expected coaster $wanted"
grep -q "\"$version\"" "$OUT/coaster.6" || fail "the manual page is not for $version"
if command -v groff >/dev/null; then
  groff -man -Tutf8 -ww "$OUT/coaster.6" >"$OUT/man.txt" 2>"$OUT/man.warnings"
  [ ! -s "$OUT/man.warnings" ] || fail "groff: $(head -c 400 "$OUT/man.warnings")"
fi

# The completion, with short replacements for the functions of bash-completion that it uses.
_init_completion() { cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]}; }
_filedir() { filter=${1:-files}; }
. "$OUT/coaster.bash"
complete -p coaster | grep -q "_coaster" || fail "no completion for coaster"
# completed WORDS...: completes the last word into COMPREPLY; the requested pattern of files is in `filter`.
completed() {
  COMP_WORDS=(coaster "$@") COMP_CWORD=$# COMPREPLY=() filter=
  _coaster
}
completed --
printf '%s\n' "${COMPREPLY[@]}" | sort >"$OUT/bash.options"
same_options bash completion
completed --he
[ "${COMPREPLY[*]}" = "--help --headless --help-script --help-man --help-completion" ] ||
  fail "--he becomes ${COMPREPLY[*]}"
completed --camera ""
[ "${COMPREPLY[*]}" = "orbit ride chase fly" ] || fail "cameras: ${COMPREPLY[*]}"
completed --fps 1
[ "${COMPREPLY[*]}" = "10 12 15 120" ] || fail "rates: ${COMPREPLY[*]}"
completed --script ""
[ "$filter" = "@(coaster)" ] || fail "scripts: $filter"
completed --out ""
[ "$filter" = "-d" ] || fail "folders: $filter"
completed ""
case $filter in *json*nltrack*coaster*) ;; *) fail "files: $filter" ;; esac
completed --seed ""
[ -z "$filter${COMPREPLY[*]}" ] || fail "a number was completed"
# The example at the start of docs/script.md runs as it is.
sed -n '/^```$/,/^```$/{/^```$/!p}; /^Run it with/q' "$SOURCE/docs/script.md" >"$OUT/example.coaster"
expect_text example.coaster "coaster-script 1"
run_script 0 example
# The lines of docs/movies-and-sound.md are a script, and the example of docs/track-format.md is one.
{
  printf 'coaster-script 1\nenv size 64x36\nload "%s/tracks/loop.json"\nride.start\n' "$SOURCE"
  sed -n '/^    movie\.start/,/^$/p' "$SOURCE/docs/movies-and-sound.md"
} >"$OUT/movie.coaster"
expect_text movie.coaster "movie.stop"
expect_code 0 --validate "$OUT/movie.coaster"
sed -n '/^```json$/,/^```$/{/^```/!p}' "$SOURCE/docs/track-format.md" >"$OUT/example.json"
expect_text example.json '"coaster-track"'
expect_code 0 --validate "$OUT/example.json"
finish
