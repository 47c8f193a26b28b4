"""Prints what the authors' own evaluator (PyPI flip-evaluator 1.7) finds for a few pairs of pictures, as JSON:

    python3 flip.py > flip.json

pairs.ts has the same pictures by the same formulas. Without a name of its own each value is of linear light.
With a file of pictures (as flip.oracle.test.ts writes it) in place of the formulas: python3 flip.py pairs.json
"""

import json
import sys

import flip_evaluator
import numpy as np

HEIGHT, WIDTH = 18, 24
Y, X = np.mgrid[0:HEIGHT, 0:WIDTH].astype(np.float64)


def picture(channel):
    return np.stack([channel(X, Y, k) for k in range(3)], axis=-1).astype(np.float32)


def squares(x, y, k):
    return np.where((np.floor(x / 6) + np.floor(y / 6)) % 2 == 0, [1, 0.5, 0][k], [0.125, 0.25, 0.75][k])


def patch(x, y, k):
    return np.where((x >= 8) & (x < 16) & (y >= 5) & (y < 13), [8, 4, 1][k], 0.0)


PAIRS = {
    "noise": (
        "LDR",
        lambda x, y, k: (x * x * 37 + y * 91 + k * 53) % 101 / 100,
        lambda x, y, k: (x * 29 + y * y * 83 + k * 47) % 101 / 100,
    ),
    "darker": (
        "LDR",
        lambda x, y, k: [x / 23, y / 17, 0.5 + 0 * x][k],
        lambda x, y, k: 0.9 * [x / 23, y / 17, 0.5 + 0 * x][k],
    ),
    "shifted": ("LDR", lambda x, y, k: squares(x + 1, y, k), squares),
    "firefly": (
        "LDR",
        lambda x, y, k: np.where((x == 12) & (y == 9), 1.0, 0.2),
        lambda x, y, k: 0.2 + 0 * x,
    ),
    "bright": (
        "HDR",
        lambda x, y, k: 2 ** ((x - y) / 3 - k) * (1 + 0.25 * (x % 3 == 0)),
        lambda x, y, k: 2 ** ((x - y) / 3 - k),
    ),
    "night": ("HDR", lambda x, y, k: patch(x - 2, y, k), patch),
}
PLACES = [(0, 0), (12, 9), (7, 5), (16, 12), (23, 17), (3, 14)]


def evaluate(test, reference, kind):
    errors, mean, used = flip_evaluator.evaluate(reference, test, kind, inputsRGB=False, applyMagma=False)
    found = {"mean": float(mean)}
    if kind == "HDR":
        found["exposures"] = {key: used[f"{key}Exposure"] for key in ("start", "stop")} | {"count": used["numExposures"]}
    return errors[:, :, 0], found


def of_formulas():
    result = {}
    for name, (kind, test, reference) in PAIRS.items():
        errors, found = evaluate(picture(test), picture(reference), kind)
        result[name] = found | {"pixels": [[x, y, float(errors[y, x])] for x, y in PLACES]}
    return result


def of_file(path):
    result = []
    for pair in json.load(open(path)):
        shape = (pair["height"], pair["width"], 3)
        test, reference = (np.array(pair[key], np.float32).reshape(shape) for key in ("test", "reference"))
        errors, found = evaluate(test, reference, pair["kind"])
        result.append(found | {"map": errors.ravel().tolist()})
    return result


print(json.dumps(of_file(sys.argv[1]) if len(sys.argv) > 1 else of_formulas(), indent=1 if len(sys.argv) < 2 else None))
