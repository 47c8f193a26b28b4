"""Writes src/spectrum/tables/*.ts: published colorimetric tables.

Run with the Python of the oracle tests: .cache/venv/bin/python3 scripts/spectrumTables.py && npm run format
With --json it prints the tables instead, by name, for src/spectrum/color.oracle.test.ts to compare.
All numbers come from colour-science (PyPI), which holds them as published.
"""

import json
import re
import sys
import warnings
from pathlib import Path

warnings.filterwarnings("ignore")
import colour  # noqa: E402
from colour.colorimetry import SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES as D_SERIES  # noqa: E402
from colour.recovery import MSDS_BASIS_FUNCTIONS_sRGB_MALLETT2019 as MALLETT_YUKSEL  # noqa: E402

FOLDER = Path(__file__).parent.parent / "src" / "spectrum" / "tables"


def numbers(values, digits=None):
    shown = (f"{v:.{digits}f}".rstrip("0").rstrip(".") if digits is not None else f"{v:.12g}" for v in values)
    return "[" + ", ".join("0" if s in ("-0", "") else s for s in shown) + "]"


files = {}


def write(name, text):
    files[name] = f"// Written by scripts/spectrumTables.py.\n{text}"


cmf = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
assert (cmf.shape.start, cmf.shape.end, cmf.shape.interval) == (360, 830, 1)
write(
    "cie1931",
    "\n".join(
        f"/** {bar} of the CIE 1931 2° standard observer, 360…830 nm in steps of 1 nm. Source: CIE 018:2019, table 6. */\n"
        f"export const {name}: readonly number[] = {numbers(cmf.values[:, i])};\n"
        for i, (bar, name) in enumerate([("x̄", "X_BAR"), ("ȳ", "Y_BAR"), ("z̄", "Z_BAR")])
    ),
)

assert (MALLETT_YUKSEL.shape.start, MALLETT_YUKSEL.shape.end, MALLETT_YUKSEL.shape.interval) == (380, 780, 5)
write(
    "mallettYuksel",
    "\n".join(
        f"/** Share of the {name} of linear sRGB in a reflectance, 380…780 nm in steps of 5 nm."
        " Source: Mallett and Yuksel 2019, supplement. */\n"
        f"export const {name.upper()}: readonly number[] = {numbers(MALLETT_YUKSEL.values[:, i], 8)};\n"
        for i, name in enumerate(["red", "green", "blue"])
    ),
)

daylight = [D_SERIES[name] for name in ("S0", "S1", "S2")]
assert all((s.shape.start, s.shape.end, s.shape.interval) == (300, 830, 5) for s in daylight)
write(
    "daylightSeries",
    "\n".join(
        f"/** S{i}(λ) of the CIE D series, 300…830 nm in steps of 5 nm. Source: CIE 015:2018, table 6. */\n"
        f"export const S{i}: readonly number[] = {numbers(s.values)};\n"
        for i, s in enumerate(daylight)
    ),
)

LAMPS = {
    "FL2": "a fluorescent tube, halophosphate, cool white (4230 K)",
    "FL11": "a fluorescent tube of three narrow bands (4000 K)",
    "LED-B3": "a white LED: blue with a yellow phosphor (4103 K)",
    "HP1": "a high-pressure sodium lamp (1959 K)",
}
lamps = {name: colour.SDS_ILLUMINANTS[name] for name in LAMPS}
assert all((s.shape.start, s.shape.end, s.shape.interval) == (380, 780, 5) for s in lamps.values())
write(
    "lamps",
    "\n".join(
        f"/** CIE illuminant {name}, {LAMPS[name]}, 380…780 nm in steps of 5 nm. Source: CIE 015:2018. */\n"
        f"export const {name.replace('-', '_')}: readonly number[] = {numbers(s.values)};\n"
        for name, s in lamps.items()
    ),
)

if "--json" in sys.argv:
    arrays = (match for text in files.values() for match in re.finditer(r"const (\w+): [^=]*= (\[[^\]]*\])", text))
    print(json.dumps({match[1]: json.loads(match[2]) for match in arrays}))
else:
    for name, text in files.items():
        (FOLDER / f"{name}.ts").write_text(text, encoding="utf8")
