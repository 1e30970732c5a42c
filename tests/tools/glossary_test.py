"""glossary_check finds a banned word, a removed name and an unused exception, and nothing else."""
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import glossary_check  # beside this file

GLOSSARY = """
| term | meaning | not | source | held as |
|---|---|---|---|---|
| train | Cars that move as one. | **cart**, run | `Cart`, `world/train.h` | `carts` |
| closing section | It closes a circuit. | **way home** | | |

| fixed name | held by | source |
|---|---|---|
| `carts`, `way_home` | a track file | `src/file.cpp` |

| allowed | file | in the text | reason |
|---|---|---|---|
| cart | `docs/a.md` | another program's cart | quoted |
"""
# Names, former labels, comments, includes, characters and code are not text; a word may be cut by the end of a line.
GOOD = {
    "src/file.cpp": '#include "cart.h"\nf("carts"); g("{\\"way_home\\": 1}"); // cart\n'
                    'h("Train###Cart", \'"\', "cartoon");',
    "docs/a.md": "another program's cart, `cart`, [a](cart.md)\n\n```\ncart\n```\n\n    cart\n\nand no other\n",
    "tutorials/a.coaster": 'lesson "The train." at "Panel/Cart"  # cart\n',
}
PLANTED = [
    ("src/label.h", 'f("Add", "A " "cart");', 'src/label.h:1: found "cart", expected "train"'),
    ("src/label.h", 'f(R"(two\nCarts)");', 'src/label.h:2: found "Carts", expected "train"'),
    ("docs/b.md", "```\ncart\n```\n\nThe `way` is the way\nhome.\n",
     'docs/b.md:5: found "way home", expected "closing section"'),
    ("tutorials/b.coaster", 'lesson "A cart."', 'tutorials/b.coaster:1: found "cart", expected "train"'),
    ("src/file.cpp", 'f("carts", "way"); // "way_home"', 'src/file.cpp no longer holds the fixed name "way_home"'),
    ("docs/a.md", "Nothing.\n", 'docs/a.md has no "cart" in "another program\'s cart" any more'),
]


class GlossaryCheck(unittest.TestCase):
    def found(self, files):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            for file, text in files.items():
                (root / file).parent.mkdir(parents=True, exist_ok=True)
                (root / file).write_text(text)
            glossary = glossary_check.Glossary(GLOSSARY)
            self.assertEqual(glossary.headers, {"world/train.h": 4})
            return [*glossary_check.missing_names(root, glossary), *glossary_check.banned_words(root, glossary)]

    def test_good_text_passes(self):
        self.assertEqual(self.found(GOOD), [])

    def test_each_planted_fault_is_found(self):
        for file, text, expected in PLANTED:
            found = self.found(GOOD | {file: text})
            self.assertEqual(len(found), 1, f"{file}: {found}")
            self.assertIn(expected, found[0])


if __name__ == "__main__":
    unittest.main()
