# The packages: their metadata, and that the program in them runs from the folder where it is unpacked.
# In, besides: BUILD (the build folder), CMAKE. Without dpkg there is no Debian package to check.
. "$(dirname "$0")/lib.sh"
cpack="$(dirname "$CMAKE")/cpack"
command -v "$cpack" >/dev/null || { echo "skipped: no cpack beside $CMAKE"; exit 0; }
# runs_from FOLDER: runs the program below it, in an empty environment except for the tests' home.
runs_from() {
  local variables=(PATH=/usr/bin:/bin HOME="$HOME" LSAN_OPTIONS="${LSAN_OPTIONS:-}" LP_NUM_THREADS=0
                   MESA_SHADER_CACHE_DISABLE=true)
  env -i "${variables[@]}" "$1/bin/coaster" --headless "$1/share/coaster/tracks/loop.json" --size 160x90 --frames 2 \
    --out "$OUT/ride" >"$OUT/stdout" 2>"$OUT/stderr"
  check_code $? 0 "$1/bin/coaster"
  [ -s "$OUT/ride/ride.png" ] || fail "no picture by $1/bin/coaster"
  rm -rf "$OUT/ride"
}
pack() {
  (cd "$BUILD" && "$cpack" -G "$1" -B "$OUT/packages") >"$OUT/cpack.log" 2>&1 ||
    fail "cpack -G $1: $(tail -n 3 "$OUT/cpack.log")"
  rm -rf "$OUT/packages/_CPack_Packages"
}

pack TGZ
mkdir "$OUT/archive"
tar -xzf "$OUT"/packages/coaster-*.tar.gz -C "$OUT/archive" --strip-components=1 ||
  fail "the archive cannot be unpacked"
runs_from "$OUT/archive"
if command -v ldd >/dev/null; then
  ldd "$OUT/archive/bin/coaster" | grep -q "$OUT/archive/bin/../lib/coaster/libtinyxml2" ||
    fail "the archive's program does not use the archive's libraries"
fi
found=$(find "$OUT/archive/lib" -name 'libc.so*' -o -name 'libstdc++*' -o -name 'libX11*')
[ -z "$found" ] || fail "system libraries are in the archive: $found"

if ! command -v dpkg-shlibdeps >/dev/null || ! command -v dpkg-deb >/dev/null; then
  echo "not checked: the Debian package (no dpkg-dev)"
  finish
fi
pack DEB
deb=$(ls "$OUT"/packages/coaster_*.deb)
field() { dpkg-deb -f "$deb" "$1"; }
# has_field NAME TEXT: checks that a field of the package contains the text.
has_field() { grep -qF "$2" <<<"$(field "$1")" || fail "the package's $1 lacks $2: $(field "$1")"; }
version=$("$COASTER" --version | sed -n '1s/coaster //p')
[ "$(field Version)" = "$version" ] || fail "the package has version $(field Version), expected $version"
for name in libgl1 libc6 libtinyxml2; do has_field Depends "$name"; done
has_field Recommends "libosmesa6 | libegl1"
mkdir "$OUT/debian"
dpkg-deb -x "$deb" "$OUT/debian"
for file in doc/coaster/copyright doc/coaster/changelog.gz man/man6/coaster.6.gz; do
  [ -s "$OUT/debian/usr/share/$file" ] || fail "no $file in the package"
done
writable=$(find "$OUT/debian" ! -user "$(id -un)" -o -perm -g+w ! -type l)
[ -z "$writable" ] || fail "not only the owner may write files of the package: $writable"
runs_from "$OUT/debian/usr"
finish
