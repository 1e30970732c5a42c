"""check_layers reports a back edge between rooms and sub-rooms, a stray GL header, a short include and a folder that no
table names, and nothing in a clean tree."""
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
for clean in [
    {"world/a.h": '#include "curve/cubic.h"\n#include "base/check.h"\n'},
    {"sim/study/a.h": '#include "sim/shape/derived_track.h"\n#include "world/document.h"\n'},
    {"ui/tools/a.cpp": '#include "ui/tools/keys_detail.h"\n'},
    {"exchange/formats.cpp": '#include "exchange/formats.h"\n#include "exchange/own/track_file.h"\n'},
]:
    assert run(tool, clean) == (0, "layers: clean\n"), clean
for files, expected in [
    ({"curve/a.h": '#include "world/document.h"\n'}, "curve/a.h:1: curve may not include world/document.h"),
    ({"world/a.cpp": "#include <GL/glcorearb.h>\n"}, "GL/glcorearb.h belongs in"),
    ({"query/a.cpp": '#include "query.h"\n'}, 'write "room/file.h"'),
    ({"sim/shape/a.h": '#include "sim/ride/ride.h"\n'}, "sim/shape/a.h:1: sim/shape may not include sim/ride/ride.h"),
    ({"ui/widgets/a.cpp": '#include "ui/host/host.h"\n'}, "ui/widgets may not include ui/host/host.h"),
    ({"exchange/own/a.cpp": '#include "exchange/formats.h"\n'}, "exchange/own may not include exchange/formats.h"),
    ({"sim/attic/a.h": "\n"}, "'attic' is not a sub-room of sim"),
    ({"sim/a.h": "\n"}, "'' is not a sub-room of sim"),
    ({"curve/attic/a.h": "\n"}, "'attic' is not a sub-room of curve"),
    ({"cellar/a.cpp": "\n"}, "'cellar' is not a room"),
    ({"ui/lab/a.cpp": '#include "ui/tools/keys_detail.h"\n'}, "ui/tools/keys_detail.h is private to its folder"),
]:
    code, out = run(tool, files)
    assert code == 1 and expected in out, (files, code, out)
