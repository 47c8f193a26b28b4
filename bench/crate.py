"""`python3 crate.py write FOLDER`: two crates by usd-core, points.usdc of meshes and prims.usdc of many small prims.
`python3 crate.py read FILE`: seconds that usd-core takes to open it, and to ask for every value as well, as JSON."""
import json
import sys
import time

import numpy as np
from pxr import Gf, Sdf, Vt


def mesh(layer, path, side, frames):
    spec = Sdf.CreatePrimInLayer(layer, path)
    spec.specifier, spec.typeName = Sdf.SpecifierDef, "Mesh"
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    faces = np.stack([corner, corner + 1, corner + side + 1, corner + side], axis=1).astype(np.int32)
    counts = np.full(len(faces), 4, dtype=np.int32)
    types = Sdf.ValueTypeNames
    Sdf.AttributeSpec(spec, "faceVertexCounts", types.IntArray).default = Vt.IntArrayFromBuffer(counts)
    Sdf.AttributeSpec(spec, "faceVertexIndices", types.IntArray).default = Vt.IntArrayFromBuffer(faces.ravel())
    points = Sdf.AttributeSpec(spec, "points", types.Point3fArray)
    rng = np.random.default_rng(1)
    for frame in range(frames):
        values = Vt.Vec3fArrayFromBuffer(rng.random((side * side, 3), dtype=np.float32))
        if frames == 1:
            points.default = values
        else:
            layer.SetTimeSample(points.path, frame, values)


def write_points(path):
    layer = Sdf.Layer.CreateNew(path)
    mesh(layer, "/World/Still", 400, 1)
    mesh(layer, "/World/Moving", 100, 60)
    layer.Save()


def write_prims(path):
    layer = Sdf.Layer.CreateNew(path)
    types = Sdf.ValueTypeNames
    with Sdf.ChangeBlock():
        for i in range(60000):
            spec = Sdf.CreatePrimInLayer(layer, f"/World/Group{i // 100}/Prim{i}")
            spec.specifier, spec.typeName = Sdf.SpecifierDef, "Xform"
            Sdf.AttributeSpec(spec, "xformOp:translate", types.Double3).default = Gf.Vec3d(i / 7, i, 0.1)
            Sdf.AttributeSpec(spec, "xformOpOrder", types.TokenArray).default = ["xformOp:translate"]
            Sdf.AttributeSpec(spec, "userProperties:label", types.String).default = f"prim {i}"
    layer.Save()


def read(path):
    began = time.perf_counter()
    layer = Sdf.Layer.OpenAsAnonymous(path)
    opened = time.perf_counter() - began

    def visit(at):
        spec = layer.GetObjectAtPath(at)
        if isinstance(spec, Sdf.AttributeSpec):
            spec.default
            for t in layer.ListTimeSamplesForPath(at):
                layer.QueryTimeSample(at, t)

    layer.Traverse("/", visit)
    return {"opened": opened, "asked": time.perf_counter() - began}


if __name__ == "__main__":
    command, place = sys.argv[1:]
    if command == "write":
        write_points(place + "/points.usdc")
        write_prims(place + "/prims.usdc")
    else:
        print(json.dumps(read(place)))
