"""Labels, help, notices and docs use the words of docs/glossary.md. Usage: glossary_check.py SOURCE_FOLDER

1. Each fixed name of the glossary occurs in the source file that its row names, as a string literal.
2. No banned word (bold in the column "not" of a table of terms) occurs in text that users read: string literals of
   src/, lessons, challenges and Markdown without its code. The glossary's table of exceptions names the other places;
   each of them must still be there.
3. Each header that a term names exists.
"""
import re
import sys
from pathlib import Path

# A raw string, a string, a character, a comment.
TOKEN = re.compile(r'R"(\w*)\((.*?)\)\1"|"((?:[^"\\\n]|\\.)*)"'
                   r"|(?<!\w)'(?:[^'\\\n]|\\[^\n][^'\n]*)'|//[^\n]*|/\*.*?\*/", re.S)
INCLUDE = re.compile(r"\s*#include\b")
CODE = (re.compile(r"^```.*?^```", re.S | re.M), re.compile(r"^ {4}.*$", re.M), re.compile(r"`[^`]*`"),
        re.compile(r"\]\([^)]*\)"))
GLOSSARY = "docs/glossary.md"
FORMER = "###"  # "Label###former label": users see the first part


def literals(text):
    """Yields (line, literal); neighbouring literals count as one, as in C++."""
    start, end, joined = 0, None, ""
    for token in TOKEN.finditer(text):
        literal = token[2] if token[2] is not None else token[3]
        before = text[text.rfind("\n", 0, token.start()) + 1:token.start()]
        if literal is None or INCLUDE.match(before):
            continue
        if end is not None and not text[end:token.start()].strip():
            joined += literal
        else:
            if end is not None:
                yield text.count("\n", 0, start) + 1, joined
            start, joined = token.start(), literal
        end = token.end()
    if end is not None:
        yield text.count("\n", 0, start) + 1, joined


def without_code(text):
    """Returns Markdown with its code and the targets of its links left out; lines keep their numbers."""
    for pattern in CODE:
        text = pattern.sub(lambda match: "_" + "\n" * match[0].count("\n"), text)
    return text


def names_in(text):
    """Returns the names that a source file holds as literals: "name", "@name", "a|b", "Label###Former", \\"name\\"."""
    names = set()
    for _, literal in literals(text):
        names |= {literal, *re.split(r"###|[|?@]", literal), *re.findall(r'\\"([^"\\]+)\\"', literal)}
    return names


class Glossary:
    def __init__(self, text):
        self.banned, self.headers, self.fixed, self.exceptions = {}, {}, [], []
        head = []
        for number, line in enumerate(text.splitlines(), 1):
            if not line.startswith("|"):
                head = []
                continue
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if not head:
                head = cells
            elif not set(line) - set("|- "):
                continue
            elif head[0] == "term":
                term = cells[0].strip("*")
                self.banned.update({word.lower(): term for word in re.findall(r"\*\*([^*]+)\*\*", cells[2])})
                self.headers.update({path: number for path in re.findall(r"`([a-z_]+/[a-z_/0-9]+\.\w+)`", cells[3])})
            elif head[0] == "fixed name":
                file = re.findall(r"`([^`]+)`", cells[2])
                self.fixed.append((number, re.findall(r"`([^`]+)`", cells[0]), file[0] if file else ""))
            elif head[0] == "allowed":
                file = re.findall(r"`([^`]+)`", cells[1])
                self.exceptions.append((number, cells[0].lower(), file[0] if file else "", cells[2], cells[3]))


def missing_names(source, glossary):
    for number, names, file in glossary.fixed:
        path = source / file
        if not file or not path.is_file():
            yield f"{GLOSSARY}:{number}: there is no file {file or 'in the third column'} that holds these names"
            continue
        held = names_in(path.read_text())
        for name in names:
            if name not in held:
                yield (f"{GLOSSARY}:{number}: {file} no longer holds the fixed name \"{name}\". Files, links or "
                       "scripts contain it: keep it, or accept both and change the row")


def texts(source):
    """Yields (file, line, text) of all that users read."""
    for path in sorted((source / "src").rglob("*")):
        if path.suffix in (".cpp", ".h"):
            for line, literal in literals(path.read_text()):
                yield path, line, literal.split(FORMER)[0]
    for path in [*sorted(source.glob("tutorials/*.coaster")), *sorted(source.glob("challenges/*.json"))]:
        for number, line in enumerate(path.read_text().splitlines(), 1):
            for text in re.findall(r'"((?:[^"\\]|\\.)*)"', line.split(" at \"")[0]):
                yield path, number, text
    pages = [*sorted(source.glob("*.md")), *sorted((source / "docs").glob("*.md"))]
    for path in pages:
        if path != source / GLOSSARY:
            yield path, 1, without_code(path.read_text())


def banned_words(source, glossary):
    words = sorted(glossary.banned, key=len, reverse=True)
    spelt = "|".join(re.escape(word).replace(r"\ ", r"\s+") for word in words)
    pattern = re.compile(rf"(?<![\w.@/#-])({spelt})s?(?![\w/])(?!\.\w)", re.I)
    fixed = {name for _, names, _ in glossary.fixed for name in names if name.islower()}  # others are former labels
    used = set()
    for path, first, text in texts(source):
        if text in fixed:
            continue
        name = str(path.relative_to(source))
        for match in pattern.finditer(text):
            word = " ".join(match[1].lower().split())
            around = " ".join(text[max(0, match.start() - 60):match.end() + 60].split())
            allowed = {number for number, other, file, part, _ in glossary.exceptions
                       if other == word and file == name and part in around}
            used |= allowed
            if not allowed:
                line = first + text.count("\n", 0, match.start())
                found = " ".join(match[0].split())
                yield f"{name}:{line}: found \"{found}\", expected \"{glossary.banned[word]}\" ({GLOSSARY})"
    for number, word, file, part, reason in glossary.exceptions:
        if not reason:
            yield f"{GLOSSARY}:{number}: the exception has no reason"
        if number not in used:
            yield f"{GLOSSARY}:{number}: {file} has no \"{word}\" in \"{part}\" any more: remove the exception"


def main():
    source = Path(sys.argv[1])
    glossary = Glossary((source / GLOSSARY).read_text())
    wrong = [*missing_names(source, glossary), *banned_words(source, glossary)]
    wrong += [f"{GLOSSARY}:{number}: there is no src/{path}" for path, number in glossary.headers.items()
              if not (source / "src" / path).is_file()]
    counts = {"banned words": len(glossary.banned), "rows of fixed names": len(glossary.fixed)}
    wrong += [f"{GLOSSARY}: only {count} {what} were found" for what, count in counts.items() if count < 20]
    print("\n".join(wrong), end="\n" if wrong else "")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
