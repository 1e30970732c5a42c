# An installed program: all its files exist, and it finds its data relative to itself, in any folder.
# In, besides: BUILD (the build folder), CMAKE.
. "$(dirname "$0")/lib.sh"
X="$OUT/a prefix"
"$CMAKE" --install "$BUILD" --prefix "$X" >"$OUT/install.log" 2>&1 || fail "install: $(tail -n 3 "$OUT/install.log")"
for file in bin/coaster share/coaster/tracks/loop.json share/coaster/envelopes/default.json share/doc/coaster/README.md share/doc/coaster/CHANGELOG.md \
  share/doc/coaster/docs/script.md share/man/man6/coaster.6 share/bash-completion/completions/coaster; do
  [ -s "$X/$file" ] || fail "$file was not installed"
done
for folder in challenges tutorials; do [ ! -d "$SOURCE/$folder" ] || diff -r "$SOURCE/$folder" "$X/share/coaster/$folder" >/dev/null || fail "$folder were not installed"; done
for kind in applications/*.desktop metainfo/*.metainfo.xml icons/hicolor/scalable/apps/*.svg; do
  # shellcheck disable=SC2086
  [ "$(cd "$X/share" && ls $kind 2>/dev/null | wc -l)" = 1 ] || fail "not one share/$kind"
done
# Launcher, icon and entry have the same name; the version is the program's.
id=$(basename "$X"/share/applications/*.desktop .desktop)
[ -s "$X/share/icons/hicolor/scalable/apps/$id.svg" ] && [ -s "$X/share/metainfo/$id.metainfo.xml" ] || fail "launcher, icon and AppStream entry have different names"
grep -qx "Icon=$id" "$X/share/applications/$id.desktop" || fail "the launcher shows another icon"
grep -q "version=\"$("$COASTER" --version | sed -n '1s/coaster //p')\"" "$X/share/metainfo/$id.metainfo.xml" || fail "the AppStream entry is of another version"
diff <("$X/bin/coaster" --help-man) "$X/share/man/man6/coaster.6" >/dev/null || fail "the manual page is of another program"
if command -v desktop-file-validate >/dev/null; then desktop-file-validate "$X"/share/applications/*.desktop >"$OUT/log" 2>&1 || fail "launcher: $(cat "$OUT/log")"; fi
if command -v appstreamcli >/dev/null; then "$SOURCE"/packaging/check_appstream "$X"/share/metainfo/*.xml >"$OUT/log" || fail "AppStream: $(cat "$OUT/log")"; fi

# From an empty folder, without the source tree: the sample is the installed one.
COASTER="$X/bin/coaster"
mkdir -p "$OUT/empty"
sed -i 's/"name": *"[^"]*"/"name": "The installed one"/' "$X/share/coaster/tracks/loop.json"
cd "$OUT/empty" || exit 1
expect_code 0 --report
expect_text stdout "The installed one"
expect_code 0 --headless "$X/share/coaster/tracks/loop.json" --size 160x90 --frames 2 --out "$OUT/ride"
[ -s "$OUT/ride/ride.png" ] || fail "the installed program drew no picture"
expect_code 0 --report "$X/share/coaster/tracks/loop.json" --envelope "$X/share/coaster/envelopes/default.json"
# COASTER_DATA has priority.
cp -r "$X/share/coaster" "$OUT/data"
sed -i 's/The installed one/Another one/' "$OUT/data/tracks/loop.json"
COASTER_DATA="$OUT/data" expect_code 0 --report
expect_text stdout "Another one"
finish
