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
case ${1:-} in
  -h | --help) help_text; exit 0 ;;
esac
