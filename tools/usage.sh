# Sourced by the tools before they do anything: --help prints the comment at the head of the tool.
# help_text: prints that comment. $tool is the absolute path of the tool, whatever folder it changes to.
tool=$(realpath "$0")
help_text() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$tool"; }
# refuse ARGUMENT: ends with exit code 2 and the help for an argument that the tool does not take.
refuse() {
  printf "tools/%s: unexpected argument '%s'\n\n" "${tool##*/}" "$1" >&2
  help_text >&2
  exit 2
}
# claim FOLDER: ends with exit code 1 if the folder has files and no tool made it, which the file .made-by-tools marks;
# otherwise makes and marks it. fresh FOLDER: then empties it, too.
claim() {
  if [ ! -e "$1/.made-by-tools" ] && [ -n "$(ls -A "$1" 2>/dev/null)" ]; then
    echo "tools/${tool##*/}: $1 was not made by the tools, so it stays. Move it, or touch $1/.made-by-tools" >&2
    exit 1
  fi
  mkdir -p "$1"
  touch "$1/.made-by-tools"
}
fresh() {
  claim "$1"
  find "$1" -mindepth 1 -maxdepth 1 ! -name .made-by-tools -exec rm -rf {} +
}
case ${1:-} in
  -h | --help) help_text; exit 0 ;;
esac
