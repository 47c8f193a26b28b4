"""Writes src/editor/fonts/*.woff2: the page's typeface, Inter, subset to what the page displays before a file is opened.

Run with a Python that has fonttools and brotli (PyPI): python3 scripts/pageFonts.py
The weights stay variable, but only from regular to bold, which omits the masters of thin and black.
Of Greek only the letters of formulas are kept; other characters come from the package's full files.
"""

from io import BytesIO
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont
from fontTools.varLib.instancer import instantiateVariableFont

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "node_modules" / "@fontsource-variable" / "inter"
FOLDER = ROOT / "src" / "editor" / "fonts"

WEIGHTS = (400, 700)
# As in fonts.css.
FORMULAS = "αβγδεθλμνπρστφωΓΔΛΣΩ"


def cut(subset, letters=None):
    font = instantiateVariableFont(TTFont(PACKAGE / "files" / f"inter-{subset}-wght-normal.woff2"), {"wght": WEIGHTS})
    # Lazily loaded tables still refer to the original glyphs: reload the font.
    font.flavor = None
    buffer = BytesIO()
    font.save(buffer)
    font = TTFont(BytesIO(buffer.getvalue()))
    options = Options()
    options.layout_features = ["*"]
    options.name_IDs = ["*"]
    options.ignore_missing_unicodes = False
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=[ord(letter) for letter in letters] if letters else list(font.getBestCmap()))
    subsetter.subset(font)
    # Reproducible output.
    font["head"].modified = font["head"].created
    font.recalcTimestamp = False
    font.flavor = "woff2"
    path = FOLDER / f"inter-{subset}.woff2"
    font.save(path)
    print(f"{path.stat().st_size} bytes: {path.relative_to(ROOT)}")


cut("latin")
cut("greek", FORMULAS)
(FOLDER / "LICENSE").write_text((PACKAGE / "LICENSE").read_text())
