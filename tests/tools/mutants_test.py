"""What tools/mutants draws from a small source, and how it plants it. Usage: mutants_test.py TOOLS"""
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import mutant_drawing as drawing  # noqa: E402
import mutant_trial as trial  # noqa: E402


def lines(body, kind=None, head="int f(int a, int b) {"):
    """What the lines of a function become."""
    return [m.becomes for m in drawing.mutants_of("src/x.cpp", f"{head}\n{body}\n}}\n") if kind in (None, m.kind)]


def expect(body, kind, *expected):
    found = lines(body, kind)
    assert sorted(found) == sorted(expected), f"{body}, {kind}:\n{found}\nexpected\n{list(expected)}"


# Each kind.
expect("g = a + b;", "operator", "g = a - b;")
expect("g = a * b;", "operator", "g = a / b;")
expect("g += a;", "operator", "g -= a;")
expect("return a && b;", "operator", "return a || b;")
expect("return a == b;", "operator", "return a != b;")
expect("return -a;", "sign", "return a;")
expect("return f(-a) + !b;", "sign", "return f(a) + !b;", "return f(-a) + b;")
expect("return std::abs(a);", "sign", "return (a);")
expect("return 7;", "constant", "return 8;", "return 6;")
expect("return 0;", "constant", "return 1;")
expect("return 0x1F'00u;", "constant", "return 0x1f01u;", "return 0x1effu;")
expect("return 0.5f;", "constant", "return 1.0f;", "return 0.25f;")
expect("return 1e-6;", "constant", "return 2e-06;", "return 5e-07;")
expect("return true;", "constant", "return false;")
expect("return a < b;", "limit", "return a <= b;", "return a >= b;")
expect("return std::max(a, b);", "limit", "return std::min(a, b);")
expect("return a + b * c - d;", "dropped term", "return b * c - d;", "return a - d;", "return a + c - d;",
       "return a + b - d;", "return a + b * c ;", "return -d;")
expect("return a < b && c;", "dropped term", "return c;", "return a < b ;")
expect("return a == b || c + d > e;", "dropped term", "return c + d > e;", "return a == b ;",
       "return a == b || d > e;", "return a == b || c > e;")
expect("return (a + g(b, c)) * d;", "dropped term", "return (g(b, c)) * d;", "return (a ) * d;", "return d;",
       "return (a + g(b, c)) ;")
expect("g = a;", "dropped statement", ";")
expect("g(a);", "dropped statement", ";")
expect("s.list[i].push_back(a);", "dropped statement", ";")
expect("++a;", "dropped statement", ";")
expect("if (a) return b;", "dropped statement", "")
expect("for (;;) {\ncontinue;\n}", "dropped statement", ";")
expect("if (a) g(b);", "dropped statement", "if (a) ;")
expect("return g(a, b, c);", "swapped arguments", "return g(b, a, c);", "return g(a, c, b);")

# What is not drawn.
for nothing in ("// a + 1", "/* 3 */", "int x;", "std::vector<double> list;", 'g("a + 1");', "const auto& x = y;",
                "T* const p = q;", "COASTER_CHECK(a < 1, why);", "#define A 1 + 2", "Foo bar(baz);",
                'auto r = R"(1 + 2)";', "f(T&& x);", "for (const auto& x : list) {}"):
    found = [b for b in lines(nothing) if b != ";"]
    assert not found, f"{nothing}: {found}"
expect("std::max(a, b);", "swapped arguments")
expect('return "a" + b;', "operator")
expect("int x = 1;", "dropped statement")
expect("return x;", "dropped statement")

# Functions, and nothing beside them.
SOURCE = """
#include <a>
namespace n {
constexpr double kOne = 1;
enum class E { a = 1, b = 2 };
struct S {
  int x = 3;
  std::array<int, 4> list{1, 2};
  int twice() const { return 2 * x; }
  S(int a) : x(a), list{5, 6} { x += 7; }
  bool operator==(const S& o) const { return x == o.x; }
  bool operator()(int a) { return a > 8; }
};
const std::vector<int> kList = {9, 10};
template <class T, int N = 11>
T Outer::Inner<T>::of(T t) {
  const auto inner = [&](int k) { return k - 12; };
  return inner(t);
}
const Row kRows[] = {{"name", 14, [](const X& x) { return x.a + 15; }}, {"other", 16, [] { return 17; }}};
const auto kSorted = sorted({18}, [](int a) -> bool { return a < 19; });
int plain(int a = 13) noexcept { return a; }
}  // namespace n
"""
found = drawing.mutants_of("src/y.cpp", SOURCE)
constants = sorted({SOURCE[m.begin:m.end] for m in found if m.kind == "constant"})
assert constants == ["12", "15", "17", "19", "2", "7", "8"], constants
functions = {m.function for m in found}
assert functions == {"twice", "S", "operator==", "operator()", "of", "lambda"}, functions
assert [m.function for m in drawing.mutants_of("f", "int A::B::c() { return 1; }\nA::A() : b(2), c{3} { d = 4; }\n"
                                                    "A::~A() { e = 5; }\n")][:2] == ["A::B::c"] * 2

# Each mutant is one change of the source where it says; a draw depends on the seed and on nothing else.
for m in found:
    planted = m.planted(SOURCE)
    assert planted != SOURCE and planted[:m.begin] == SOURCE[:m.begin] and planted.endswith(SOURCE[m.end:]), m
    assert SOURCE.splitlines()[m.line - 1].strip() in m.text, m
assert len({m.id for m in found}) == len(found)
orders = [[m.id for m in drawing.in_order(list(mutants), seed)] for mutants, seed in
          ((found, 1), (reversed(found), 1), (found, 2))]
assert orders[0] == orders[1] != orders[2]
assert len({m.line for m in drawing.in_order(found, 3)}) == len(list(drawing.in_order(found, 3)))
# Other code above does not change what is drawn below.
moved = drawing.mutants_of("src/y.cpp", "int above() { return 1; }\n" + SOURCE)
assert {m.key for m in found} < {m.key for m in moved}

# The functions that a profile has counts of, as llvm-profdata prints them.
SHOWN = """Counters:
  _ZN1a1bEv:
    Hash: 0x0000000000000018
    Counters: 1
    Function count: 3
  y.cpp:_ZN1aL1cEv:
    Hash: 0x0000000000000000
    Counters: 1
    Function count: 1
Instrumentation level: Front-end
"""
assert trial.functions_counted(SHOWN) == ["_ZN1a1bEv", "y.cpp:_ZN1aL1cEv"]
with tempfile.TemporaryDirectory() as name:
    root = pathlib.Path(name)
    (root / "src").mkdir()
    (root / "src/a.cpp").write_text("1")
    before = trial.tree_hash(root)
    (root / "src/a.cpp").write_text("2")
    assert trial.tree_hash(root) != before
