# An installed program: all its files exist, and it finds its data relative to itself, in any folder.
# In, besides: BUILD (the build folder), CMAKE.
. "$(dirname "$0")/lib.sh"
prefix="$OUT/a prefix"
share=$prefix/share
data=$share/coaster
"$CMAKE" --install "$BUILD" --prefix "$prefix" >"$OUT/install.log" 2>&1 ||
  fail "install: $(tail -n 3 "$OUT/install.log")"
[ -s "$prefix/bin/coaster" ] || fail "the program was not installed"
for file in coaster/tracks/loop.json coaster/envelopes/default.json doc/coaster/README.md doc/coaster/CHANGELOG.md \
  doc/coaster/docs/script.md man/man6/coaster.6 bash-completion/completions/coaster; do
  [ -s "$share/$file" ] || fail "share/$file was not installed"
done
[ ! -e "$prefix/include" ] || fail "a plain installation contains the curve library"
for folder in challenges tutorials; do
  diff -r "$SOURCE/$folder" "$data/$folder" >/dev/null || fail "$folder were not installed"
done
for kind in applications/*.desktop metainfo/*.metainfo.xml icons/hicolor/scalable/apps/*.svg; do
  # shellcheck disable=SC2086
  [ "$(cd "$share" && ls $kind 2>/dev/null | wc -l)" = 1 ] || fail "not one share/$kind"
done
# Launcher, icon and entry have the same name; the version is the program's.
id=$(basename "$share"/applications/*.desktop .desktop)
launcher=$share/applications/$id.desktop
entry=$share/metainfo/$id.metainfo.xml
[ -s "$share/icons/hicolor/scalable/apps/$id.svg" ] || fail "launcher and icon have different names"
[ -s "$entry" ] || fail "launcher and AppStream entry have different names"
grep -qx "Icon=$id" "$launcher" || fail "the launcher shows another icon"
version=$("$COASTER" --version | sed -n '1s/coaster //p')
grep -q "version=\"$version\"" "$entry" || fail "the AppStream entry is not for version $version"
diff <("$prefix/bin/coaster" --help-man) "$share/man/man6/coaster.6" >/dev/null ||
  fail "the manual page is for another program"
if command -v desktop-file-validate >/dev/null; then
  desktop-file-validate "$launcher" >"$OUT/log" 2>&1 || fail "launcher: $(cat "$OUT/log")"
fi
if command -v appstreamcli >/dev/null; then
  "$SOURCE"/packaging/check_appstream "$entry" >"$OUT/log" || fail "AppStream: $(cat "$OUT/log")"
fi

# From an empty folder, without the source tree: the sample is the installed one.
COASTER="$prefix/bin/coaster"
mkdir -p "$OUT/empty"
sed -i 's/"name": *"[^"]*"/"name": "The installed one"/' "$data/tracks/loop.json"
cd "$OUT/empty" || exit 1
expect_code 0 --report
expect_text stdout "The installed one"
expect_code 0 --headless "$data/tracks/loop.json" --size 160x90 --frames 2 --out "$OUT/ride"
[ -s "$OUT/ride/ride.png" ] || fail "the installed program drew no picture"
expect_code 0 --report "$data/tracks/loop.json" --envelope "$data/envelopes/default.json"
# COASTER_DATA has priority.
cp -r "$data" "$OUT/data"
sed -i 's/The installed one/Another one/' "$OUT/data/tracks/loop.json"
COASTER_DATA="$OUT/data" expect_code 0 --report
expect_text stdout "Another one"
finish
