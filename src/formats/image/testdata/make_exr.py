"""Writes openexr-zip.exr with the reference implementation (PyPI OpenEXR 3.5); exr.test.ts knows the formulas."""

import numpy as np
import OpenEXR

height, width = 20, 5
y, x = np.mgrid[0:height, 0:width]
channels = {
    "R": (x - y / 4).astype(np.float16),
    "position.x": (x + 1000 * y + 0.1).astype(np.float32),
    "object": (x * y * 200_000_000 % 2**32).astype(np.uint32),
}
header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage, "objects": '["/World/Cube"]'}
with OpenEXR.File(header, channels) as file:
    file.write("openexr-zip.exr")
