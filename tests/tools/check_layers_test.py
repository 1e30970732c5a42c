"""check_layers reports a back edge, a stray GL header and a short include, and nothing in a clean tree."""
import pathlib
import subprocess
import sys
import tempfile


def run(tool, files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder, "src", name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        done = subprocess.run([sys.executable, tool, folder], capture_output=True, text=True)
        return done.returncode, done.stdout


tool = sys.argv[1]
assert run(tool, {"world/a.h": '#include "curve/cubic.h"\n#include "base/check.h"\n'})[0] == 0
for files, expected in [
    ({"curve/a.h": '#include "world/document.h"\n'}, "curve/a.h:1: curve may not include world/document.h"),
    ({"sim/a.cpp": "#include <GL/glcorearb.h>\n"}, "GL/glcorearb.h belongs in"),
    ({"query/a.cpp": '#include "query.h"\n'}, 'write "room/file.h"'),
    ({"cellar/a.cpp": "\n"}, "'cellar' is not a room"),
]:
    code, out = run(tool, files)
    assert code == 1 and expected in out, (files, code, out)
