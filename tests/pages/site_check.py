"""What tools/docs/check.py finds in a site: each wrong thing, planted alone, and nothing in a good one.

    site_check.py HOUSE
"""
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "tools/docs"))
import check

GOOD = ('<link rel="stylesheet" href="site.css"><h1 id="top">x</h1><a href="#top">a</a> <a href="other.html#y">b</a> '
        '<a href="https://example.org/">c</a><img src="p.png">')
WRONG = {
    "#none": ('<a href="#none">', "no such anchor"),
    "other.html#z": ('<a href="other.html#z">', "no such anchor"),
    "gone.html": ('<a href="gone.html">', "leads nowhere"),
    "a folder": ('<a href="folder">', "leads nowhere"),
    "q.png": ('<img src="q.png">', "leads nowhere"),
    "script": ('<script src="https://example.org/a.js"></script>', "from the network"),
    "font": ('<link rel="stylesheet" href="//example.org/font.css">', "from the network"),
}


def found(page, style="p { color: red }"):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder).resolve()
        (folder / "index.html").write_text(page)
        (folder / "other.html").write_text('<h1 id="y">y</h1>')
        (folder / "site.css").write_text(style)
        (folder / "p.png").write_bytes(b"")
        (folder / "folder").mkdir()
        return check.site(folder)


assert found(GOOD) == [], found(GOOD)
for name, (wrong, words) in WRONG.items():
    lines = found(GOOD + wrong)
    assert len(lines) == 1 and words in lines[0], (name, lines)
lines = found(GOOD, "@font-face { src: url('https://example.org/f.woff') }")
assert len(lines) == 1 and "from the network" in lines[0], lines
print(f"{len(WRONG) + 1} wrong things found")
