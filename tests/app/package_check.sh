# The packages: their metadata, and that the program in them runs from the folder where it is unpacked.
# In, besides: BUILD (the build folder), CMAKE. Without dpkg there is no Debian package to check.
. "$(dirname "$0")/lib.sh"
cpack="$(dirname "$CMAKE")/cpack"
command -v "$cpack" >/dev/null || { echo "skipped: no cpack beside $CMAKE"; exit 0; }
# runs_from FOLDER: runs the program below it, in an empty environment except for the tests' home.
runs_from() {
  env -i PATH=/usr/bin:/bin HOME="$HOME" LSAN_OPTIONS="${LSAN_OPTIONS:-}" LP_NUM_THREADS=0 MESA_SHADER_CACHE_DISABLE=true "$1/bin/coaster" --headless "$1/share/coaster/tracks/loop.json" --size 160x90 --frames 2 --out "$OUT/ride" >"$OUT/stdout" 2>"$OUT/stderr" ||
    fail "$1/bin/coaster: $(head -c 400 "$OUT/stderr")"
  [ -s "$OUT/ride/ride.png" ] || fail "no picture by $1/bin/coaster"
  rm -rf "$OUT/ride"
}
pack() {
  (cd "$BUILD" && "$cpack" -G "$1" -B "$OUT/packages") >"$OUT/cpack.log" 2>&1 || fail "cpack -G $1: $(tail -n 3 "$OUT/cpack.log")"
  rm -rf "$OUT/packages/_CPack_Packages"
}

pack TGZ
mkdir "$OUT/archive"
tar -xzf "$OUT"/packages/coaster-*.tar.gz -C "$OUT/archive" --strip-components=1 || fail "the archive cannot be unpacked"
runs_from "$OUT/archive"
if command -v ldd >/dev/null; then
  ldd "$OUT/archive/bin/coaster" | grep -q "$OUT/archive/bin/../lib/coaster/libtinyxml2" || fail "the archive's program takes its libraries from elsewhere"
fi
[ -z "$(find "$OUT/archive/lib" -name 'libc.so*' -o -name 'libstdc++*' -o -name 'libX11*')" ] || fail "libraries of the system's are in the archive"

if ! command -v dpkg-shlibdeps >/dev/null || ! command -v dpkg-deb >/dev/null; then
  echo "not checked: the Debian package (no dpkg-dev)"
  finish
fi
pack DEB
deb=$(ls "$OUT"/packages/coaster_*.deb)
field() { dpkg-deb -f "$deb" "$1"; }
[ "$(field Version)" = "$("$COASTER" --version | sed -n '1s/coaster //p')" ] || fail "the package is of version $(field Version)"
for name in libgl1 libc6 libtinyxml2; do case $(field Depends) in *$name*) ;; *) fail "the package does not depend on $name: $(field Depends)" ;; esac; done
case $(field Recommends) in *"libosmesa6 | libegl1"*) ;; *) fail "the package recommends neither OSMesa nor EGL" ;; esac
mkdir "$OUT/debian"
dpkg-deb -x "$deb" "$OUT/debian"
for file in doc/coaster/copyright doc/coaster/changelog.gz man/man6/coaster.6.gz; do [ -s "$OUT/debian/usr/share/$file" ] || fail "no $file in the package"; done
[ -z "$(find "$OUT/debian" ! -user "$(id -un)" -o -perm -g+w ! -type l)" ] || fail "files in the package that others than their owner may write"
runs_from "$OUT/debian/usr"
finish
