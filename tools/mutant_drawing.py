"""Draws wrong operators, signs, constants, limits and the like in the functions of C++ sources.

Works on the tokens of sources as clang-format leaves them: binary operators have a space on either side, template
brackets, references and pointers do not. Not drawn: comments, strings, preprocessor lines, COASTER_CHECK and whatever
is outside functions. Results depend on the sources and the seed alone.
"""
import hashlib
import re
from dataclasses import dataclass

TOKEN = re.compile(r"""(?P<skip>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\.)*)
                     | (?P<string>(?:u8|[uUL])?R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"
                                |(?:u8|[uUL])?"(?:[^"\\\n]|\\.)*"|(?:u8|[uUL])?'(?:[^'\\\n]|\\.)*')
                     | (?P<number>\.?\d(?:'?[\w.]|(?<=[eEpP])[+-])*)
                     | (?P<name>[A-Za-z_]\w*)
                     | (?P<mark_token><=>|<<=|>>=|\.\.\.|->\*?|::|\+\+|--|&&|\|\||[-+*/%&|^!=<>]=|<<|>>|.)""",
                   re.VERBOSE | re.DOTALL | re.MULTILINE)
OPENERS, CLOSERS = {"(": ")", "[": "]", "{": "}"}, {")", "]", "}"}
UNDRAWN_CALLS = {"COASTER_CHECK", "assert", "static_assert", "sizeof", "alignas", "decltype"}
# Calls whose arguments may be given in any order.
SYMMETRIC = {"max", "min", "dot", "distance", "hypot", "distance2", "gcd", "lcm", "minmax", "swap"}
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "|=", "&=", "^=", "<<=", ">>="}
KINDS = ("operator", "sign", "constant", "limit", "dropped term", "dropped statement", "swapped arguments")
OPERATORS = {"+": "-", "-": "+", "*": "/", "/": "*", "%": "*", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=",
             "&&": "||", "||": "&&", "==": "!=", "!=": "==", "&": "|", "|": "&", "<<": ">>", ">>": "<<"}
LIMITS = {"<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<")}
# How tightly binary operators bind, as far as terms are dropped.
BINDING = {"*": 5, "/": 5, "%": 5, "+": 4, "-": 4, "&&": 2, "||": 1}
# What ends an operand of any of them: what binds less, or not at all.
LOOSE = {"?", ":", ",", ";", "=", "<", ">", "<=", ">=", "==", "!=", "return", "<<", ">>", "&", "|", "^", "<=>",
         *ASSIGNMENTS, *CLOSERS, *OPENERS}


TIGHTER_THAN_AND = {"<=", ">=", "==", "!=", "&", "|", "^", "<<", ">>", "<=>"}


@dataclass(frozen=True)
class Token:
    kind: str  # string, number, name or mark
    text: str
    begin: int
    end: int


@dataclass(frozen=True)
class Function:
    name: str   # with its class where it names one
    begin: int  # of the tokens of its body, without the braces
    end: int


@dataclass(frozen=True)
class Mutant:
    file: str      # below the root
    function: str
    kind: str
    line: int      # the first of them
    text: str      # the lines that change, without indentation
    becomes: str
    begin: int     # in the file: what is replaced
    end: int
    to: str

    @property
    def key(self):
        """What names it in lists: the same while the function has these lines."""
        return self.file, self.function, self.text, self.becomes

    @property
    def id(self):
        return hashlib.sha256("\0".join(self.key).encode()).hexdigest()[:8]

    def planted(self, source):
        return source[:self.begin] + self.to + source[self.end:]


def tokens_of(source):
    found = []
    for match in TOKEN.finditer(source):
        kind = "mark" if match.lastgroup in ("mark", "mark_token") else match.lastgroup
        if match.group("string"):
            kind = "string"
        if kind != "skip":
            found.append(Token(kind, match.group(), match.start(), match.end()))
    return found


def partners_of(tokens):
    """The index of the closing bracket of each opening one and the reverse."""
    partners, stack = {}, []
    for i, token in enumerate(tokens):
        if token.text in OPENERS and token.kind == "mark":
            stack.append(i)
        elif token.text in CLOSERS and token.kind == "mark" and stack:
            partners[i] = stack.pop()
            partners[partners[i]] = i
    return partners


def functions_of(tokens, partners):
    """The functions with a body at the level of namespaces and classes."""
    found, i, start = [], 0, 0
    while i < len(tokens):
        text = tokens[i].text
        if text in (";", "}") or (text == ":" and tokens[i - 1].text in ("public", "private", "protected")):
            start = i + 1
        elif text in ("(", "["):
            found += lambdas_of(tokens, partners, i)
            i = partners.get(i, i)
        elif text == "{":
            head = [t.text for t in tokens[start:i]]
            if "namespace" in head or (head[:1] == ["extern"] and len(head) == 2):
                start = i + 1
            elif name := function_name(head, tokens, i):
                found.append(Function(name, i + 1, partners.get(i, len(tokens))))
                i = partners.get(i, len(tokens) - 1)
                start = i + 1
            elif is_class(head):
                start = i + 1
            else:  # an initializer or an enumeration
                found += lambdas_of(tokens, partners, i)
                i = partners.get(i, i)
        i += 1
    return found


def lambdas_of(tokens, partners, opening):
    """The lambdas in brackets outside functions, as in the rows of a table."""
    found, i, last = [], opening + 1, partners.get(opening, opening)
    while i < last:
        if tokens[i].text == "]" and tokens[i + 1].text in ("(", "{"):
            k = i + 1
            if tokens[k].text == "(":
                k = partners.get(k, k) + 1
            while k < last and tokens[k].text not in ("{", ",", ";", ")", "}"):
                k += 1
            if tokens[k].text == "{" and k in partners:
                found.append(Function("lambda", k + 1, partners[k]))
                i = partners[k]
        i += 1
    return found


def is_class(head):
    return any(word in head for word in ("class", "struct", "union")) and "enum" not in head and "(" not in head


def outside_brackets(head):
    """The words of a head outside round brackets, with "(" for each pair of them."""
    depth, words = 0, []
    for word in head:
        if word == "(" and depth == 0:
            words.append(word)
        depth += (word == "(") - (word == ")")
        if depth == 0 and word != ")":
            words.append(word)
    return words


def without_template(head):
    """The words of a head behind `template <...>`."""
    if head[:1] != ["template"]:
        return head
    depth = 0
    for i, word in enumerate(head):
        depth += (word == "<") - (word == ">") - 2 * (word == ">>")
        if i > 1 and depth == 0:
            return without_template(head[i + 1:])
    return head


def function_name(head, tokens, brace):
    """The name of the function whose body the brace opens; nothing if it opens something else."""
    head = without_template(head)
    if "(" not in head:
        return None
    words = outside_brackets(head)
    at = words.index("(")
    if words[at - 1:at] == ["operator"]:  # operator()
        return "operator()"
    if "operator" in words[:at]:
        name = "operator" + "".join(words[words.index("operator") + 1:at])
    elif "=" in words[:at] or at == 0:
        return None
    else:
        name = words[at - 1]
    after = words[at + 1:]
    if ":" in after and tokens[brace - 1].kind == "name":  # a member that a constructor initializes
        return None
    if ":" not in after and "=" in after:
        return None
    k = at - 1
    while k >= 2 and words[k - 1] == "::" and re.match(r"\w", words[k - 2]):
        name, k = f"{words[k - 2]}::{name}", k - 2
    return name


def spaced(source, token):
    """Whether a token stands between spaces, as binary operators do."""
    return source[token.begin - 1].isspace() and source[token.end:token.end + 1].isspace()


def other_numbers(text):
    """What a number may become: an integer one more or less, any other twice or half as much."""
    digits = re.match(r"(0[xXbB][\da-fA-F']+|[\d']+)([uUlLzZ]*)$", text)
    if digits:
        prefix = digits.group(1)[:2].lower()
        base = {"0x": 16, "0b": 2}.get(prefix, 10)
        value = int(digits.group(1).replace("'", "").removeprefix(prefix if base != 10 else ""), base)
        written = (lambda n: hex(n)) if base == 16 else str
        return [written(n) + digits.group(2) for n in (value + 1, value - 1) if n >= 0]
    number = re.match(r"([\d.']+(?:[eE][+-]?\d+)?)([fFlL]?)$", text)
    if not number:
        return []
    value = float(number.group(1).replace("'", ""))
    def as_real(v):
        return v if re.search(r"[.e]", v) else v + ".0"
    values = (2 * value, value / 2) if value != 0 else (1.0,)
    return [as_real(repr(v)) + number.group(2) for v in values]


class Body:
    """The mutants of one function."""

    def __init__(self, source, tokens, partners, function):
        self.source, self.tokens, self.partners, self.function = source, tokens, partners, function
        self.found = []
        self.undrawn = self.undrawn_tokens()

    def undrawn_tokens(self):
        """Those in brackets of assertions and of templates, and the conditions of `if constexpr`."""
        out = set()
        for i in range(self.function.begin, self.function.end):
            token = self.tokens[i]
            following = self.tokens[i + 1].text if i + 1 < len(self.tokens) else ""
            opening = None
            if token.text in UNDRAWN_CALLS:
                opening = i + 1
            elif token.text == "if" and following == "constexpr":
                opening = i + 2
            if opening is not None and self.partners.get(opening):
                out.update(range(i, self.partners[opening] + 1))
        return out

    def put(self, kind, first, last, to):
        """Adds the mutant that replaces tokens first to last."""
        if not any(i in self.undrawn for i in range(first, last + 1)):
            self.replace(kind, self.tokens[first].begin, self.tokens[last].end, to)

    def replace(self, kind, begin, end, to):
        if self.source[begin:end] != to:
            self.found.append((kind, begin, end, to))

    def mutants(self):
        for i in range(self.function.begin, self.function.end):
            token = self.tokens[i]
            if token.kind == "number":
                for to in other_numbers(token.text):
                    self.put("constant", i, i, to)
            elif token.text in ("true", "false"):
                self.put("constant", i, i, "false" if token.text == "true" else "true")
            elif token.kind == "name":
                self.of_name(i)
            elif token.kind == "mark":
                self.of_mark(i)
            if i == self.function.begin or self.tokens[i - 1].text in (";", "{", "}") or self.after_condition(i):
                self.of_statement(i)
        return self.found

    def of_mark(self, i):
        text, before = self.tokens[i].text, self.tokens[i - 1]
        if text in ("-", "!") and not spaced(self.source, self.tokens[i]) and (
                before.text in (*OPENERS, ",", "return", "?", ":") or spaced(self.source, before)
                or before.text in ASSIGNMENTS):
            self.put("sign", i, i, "")
        elif text == "(":
            self.of_call(i)
        if not spaced(self.source, self.tokens[i]) or "string" in (before.kind, self.tokens[i + 1].kind):
            return
        if text in OPERATORS:
            self.put("operator", i, i, OPERATORS[text])
        for to in LIMITS.get(text, ()):
            self.put("limit", i, i, to)
        if text in BINDING:
            self.of_term(i)

    def of_name(self, i):
        text = self.tokens[i].text
        following = self.tokens[i + 1].text
        other = {"max": "min", "min": "max", "floor": "ceil", "ceil": "floor"}.get(text)
        if following == "(" and self.tokens[i - 1].text == "::" and other:
            self.put("limit", i, i, other)
        if text == "abs" and following == "(" and self.tokens[i - 1].text == "::":
            first = i - 1
            while self.tokens[first].text == "::" or self.tokens[first - 1].text == "::":
                first -= 1
            self.put("sign", first, i, "")
        if text in ("break", "continue") and following == ";":
            self.put("dropped statement", i, i + 1, ";")

    def operand(self, i, way, binding):
        """The last token of the operand beside operator i on one side."""
        k, last = i + way, None
        while self.function.begin <= k < self.function.end:
            text, kind = self.tokens[k].text, self.tokens[k].kind
            opens = text in OPENERS if way > 0 else text in CLOSERS
            if kind == "mark" and opens and k in self.partners:
                if way > 0 and text == "{" and self.tokens[k - 1].text == ")":
                    return last
                last, k = self.partners[k], self.partners[k] + way
                continue
            ends = kind == "mark" and text in LOOSE or text == "return"
            if ends and (text in TIGHTER_THAN_AND or text in ("<", ">")) and (
                    binding <= 2 or not spaced(self.source, self.tokens[k])):
                ends = False
            if ends and (text != ":" or spaced(self.source, self.tokens[k])):
                return last
            if text in BINDING and spaced(self.source, self.tokens[k]) and (
                    BINDING[text] < binding or (BINDING[text] == binding and way > 0)):
                return last
            last, k = k, k + way
        return last

    def of_term(self, i):
        binding = BINDING[self.tokens[i].text]
        right, left = self.operand(i, 1, binding), self.operand(i, -1, binding)
        if right is not None:
            self.put("dropped term", i, right, "")
        if left is not None and self.tokens[i].text in ("+", "-", "*", "&&", "||"):
            to = "-" if self.tokens[i].text == "-" else ""
            if not any(k in self.undrawn for k in range(left, i + 1)):
                self.replace("dropped term", self.tokens[left].begin, self.tokens[i + 1].begin, to)

    def of_call(self, i):
        """Neighbouring arguments change places."""
        name = self.tokens[i - 1]
        if name.kind != "name" or name.text in SYMMETRIC or name.text in ("if", "while", "switch", "for", "return"):
            return
        arguments, first, k = [], i + 1, i + 1
        while k <= self.partners[i]:
            text = self.tokens[k].text
            if k == self.partners[i] or text == ",":
                if k > first:
                    arguments.append((first, k - 1))
                first = k + 1
            elif text == ";":
                return
            k = self.partners[k] + 1 if text in OPENERS and k != self.partners[i] else k + 1
        texts = [self.source[self.tokens[a].begin:self.tokens[b].end] for a, b in arguments]
        if any(self.tokens[a].kind == "string" for a, _ in arguments):
            return
        for (a, b), one, other in zip(zip(arguments, arguments[1:]), texts, texts[1:]):
            if one != other:
                between = self.source[self.tokens[a[1]].end:self.tokens[b[0]].begin]
                self.put("swapped arguments", a[0], b[1], other + between + one)

    def after_condition(self, i):
        before = self.tokens[i - 1].text
        if before == "else":
            return True
        opening = self.partners.get(i - 1)
        return before == ")" and opening is not None and self.tokens[opening - 1].text in ("if", "for", "while")

    def of_statement(self, i):
        """Drops an assignment, a call or an early return."""
        if self.tokens[i].text == "if" and self.tokens[i + 1].text == "(":
            inner = self.partners[i + 1] + 1
            end = self.end_of_statement(inner)
            leaves = self.tokens[inner].text in ("return", "break", "continue")
            if leaves and end and self.tokens[end + 1].text != "else":
                self.put("dropped statement", i, end, "")
            return
        k = i
        if self.tokens[k].text in ("++", "--"):
            k += 1
        elif self.tokens[k].kind != "name" or self.tokens[k].text in (
                "return", "else", "case", "default", "using", "const", "constexpr", "static", "auto", "break",
                "continue", "throw", "delete", "for", "while", "do", "switch", "try", "struct", "class", "goto"):
            return
        while True:  # a name, its members, calls and indices
            text = self.tokens[k].text
            if text in ("(", "["):
                k = self.partners[k] + 1
            elif text in ("::", ".", "->") or (self.tokens[k].kind == "name" and (k == i or self.tokens[k - 1].text in (
                    "::", ".", "->", "++", "--"))):
                k += 1
            else:
                break
        if text not in ASSIGNMENTS and text not in (";", ",", "++", "--"):
            return  # a declaration
        if self.tokens[i].text in UNDRAWN_CALLS:
            return
        end = self.end_of_statement(k)
        if end and end > i:
            self.put("dropped statement", i, end, ";")

    def end_of_statement(self, k):
        while k < self.function.end:
            text = self.tokens[k].text
            if text == ";":
                return k
            if text in CLOSERS:
                return None
            k = self.partners[k] + 1 if text in OPENERS and k in self.partners else k + 1
        return None


def mutants_of(file, source):
    """All mutants of a source, each once, in the order of its text."""
    tokens = tokens_of(source)
    partners = partners_of(tokens)
    found = {}
    for function in functions_of(tokens, partners):
        for kind, begin, end, to in Body(source, tokens, partners, function).mutants():
            first, last = source.rfind("\n", 0, begin) + 1, source.find("\n", end)
            last = len(source) if last < 0 else last
            text, becomes = (re.sub(r"\s+", " ", t).strip() for t in (
                source[first:last], source[first:begin] + to + source[end:last]))
            if text != becomes:
                found.setdefault((begin, end, to), Mutant(file, function.name, kind, source.count("\n", 0, begin) + 1,
                                                          text, becomes, begin, end, to))
    return [found[place] for place in sorted(found)]


def in_order(mutants, seed):
    """The mutants in the order in which a seed draws them: at most one of each line of the source."""
    def place(m):
        return hashlib.sha256("\0".join((str(seed), *m.key, str(m.begin))).encode()).digest()
    drawn = set()
    for m in sorted(mutants, key=place):
        if (m.file, m.line) not in drawn:
            drawn.add((m.file, m.line))
            yield m
