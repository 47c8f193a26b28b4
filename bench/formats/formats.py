"""`python3 formats.py write FOLDER`: stages by usd-core, and FOLDER/million.usda as a crate and as a package.
`python3 formats.py load FOLDER`: stages like some of other people, for `npm run bench -- load`.
`python3 formats.py read FILE`: what usd-core takes to open it and to tell the values that a picture needs [s, bytes], as JSON.
`python3 formats.py check`: fails without usd-core."""
import json
import os
import sys
import time

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdSkel, UsdUtils, Vt

VERTICES_ASIDE = 316
FRAMES, SKINNED_FRAMES = 250, 100
INSTANCES, CROWD = 1000, 10000
JOINTS = 20
DANCER_MESHES, DANCER_FRAMES = 60, 1300


def stage_at(folder, name, frames=1):
    stage = Usd.Stage.CreateNew(os.path.join(folder, name))
    UsdGeom.SetStageMetersPerUnit(stage, 1)
    stage.SetStartTimeCode(0)
    stage.SetEndTimeCode(frames - 1)
    return stage


def grid(side):
    """A wavy sheet of (side − 1)² quads: points, corners per face, the point of each corner."""
    x, y = np.meshgrid(np.linspace(-1, 1, side), np.linspace(-1, 1, side))
    points = np.stack([x, y, 0.1 * np.sin(5 * x) * np.cos(7 * y)], axis=-1).reshape(-1, 3).astype(np.float32)
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    faces = np.stack([corner, corner + 1, corner + side + 1, corner + side], axis=1).astype(np.int32)
    return points, np.full(len(faces), 4, dtype=np.int32), faces.ravel()


def define_mesh(stage, path, side, scheme="none"):
    mesh = UsdGeom.Mesh.Define(stage, path)
    points, counts, indices = grid(side)
    mesh.CreatePointsAttr(Vt.Vec3fArrayFromBuffer(points))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArrayFromBuffer(counts))
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArrayFromBuffer(indices))
    mesh.CreateSubdivisionSchemeAttr(scheme)
    return mesh, points


def write_moving(folder):
    stage = stage_at(folder, "moving.usdc", FRAMES)
    mesh, points = define_mesh(stage, "/Sheet", VERTICES_ASIDE)
    mesh.GetPointsAttr().Clear()
    for frame in range(FRAMES):
        swell = np.float32(1 + frame / FRAMES)
        mesh.GetPointsAttr().Set(Vt.Vec3fArrayFromBuffer(points * swell), frame)
    stage.Save()


def write_skinned(folder, name="skinned.usdc", frames=SKINNED_FRAMES, sheets=1, side=VERTICES_ASIDE):
    """A chain of joints along x, each turning; every vertex follows the two nearest."""
    stage = stage_at(folder, name, frames)
    UsdSkel.Root.Define(stage, "/Root")
    names = ["/".join(f"j{k}" for k in range(i + 1)) for i in range(JOINTS)]
    step = Gf.Matrix4d().SetTranslate((2 / JOINTS, 0, 0))
    first = Gf.Matrix4d().SetTranslate((-1, 0, 0))
    skeleton = UsdSkel.Skeleton.Define(stage, "/Root/Skeleton")
    skeleton.CreateJointsAttr(names)
    skeleton.CreateRestTransformsAttr([first] + [step] * (JOINTS - 1))
    skeleton.CreateBindTransformsAttr([Gf.Matrix4d().SetTranslate((-1 + 2 * k / JOINTS, 0, 0)) for k in range(JOINTS)])
    animation = UsdSkel.Animation.Define(stage, "/Root/Animation")
    animation.CreateJointsAttr(names)
    animation.CreateTranslationsAttr([Gf.Vec3f(-1, 0, 0)] + [Gf.Vec3f(2 / JOINTS, 0, 0)] * (JOINTS - 1))
    animation.CreateScalesAttr([Gf.Vec3h(1, 1, 1)] * JOINTS)
    rotations = animation.CreateRotationsAttr()
    for frame in range(frames):
        half = 0.05 * np.sin(2 * np.pi * frame / SKINNED_FRAMES)
        rotations.Set([Gf.Quatf(float(np.cos(half)), 0, 0, float(np.sin(half)))] * JOINTS, frame)
    UsdSkel.BindingAPI.Apply(skeleton.GetPrim()).CreateAnimationSourceRel().SetTargets(["/Root/Animation"])
    for k in range(sheets):
        mesh, points = define_mesh(stage, f"/Root/Sheet{k}", side)
        binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
        binding.CreateSkeletonRel().SetTargets(["/Root/Skeleton"])
        along = (points[:, 0] + 1) / 2 * JOINTS
        joint = np.clip(along.astype(np.int32), 0, JOINTS - 2)
        weight = np.clip(along - joint, 0, 1).astype(np.float32)
        joints, weights = np.stack([joint, joint + 1], axis=1).astype(np.int32), np.stack([1 - weight, weight], axis=1)
        binding.CreateJointIndicesPrimvar(False, 2).Set(Vt.IntArrayFromBuffer(joints.ravel()))
        binding.CreateJointWeightsPrimvar(False, 2).Set(Vt.FloatArrayFromBuffer(weights.ravel()))
    stage.Save()


def places(count=INSTANCES):
    k = np.arange(count)
    return np.stack([k % 10, k // 10 % 10, k // 100], axis=1).astype(np.float32) * 3


def write_instances(folder):
    stage = stage_at(folder, "instancer.usdc")
    instancer = UsdGeom.PointInstancer.Define(stage, "/Crowd")
    define_mesh(stage, "/Crowd/Sheet", 72)
    instancer.CreatePrototypesRel().SetTargets(["/Crowd/Sheet"])
    instancer.CreateProtoIndicesAttr([0] * INSTANCES)
    instancer.CreatePositionsAttr(Vt.Vec3fArrayFromBuffer(places()))
    stage.Save()
    stage = stage_at(folder, "instanceable.usdc")
    stage.CreateClassPrim("/Kept")
    define_mesh(stage, "/Kept/Sheet", 72)
    for i, place in enumerate(places().tolist()):
        prim = UsdGeom.Xform.Define(stage, f"/Sheet{i}")
        prim.AddTranslateOp().Set(tuple(place))
        prim.GetPrim().GetReferences().AddInternalReference("/Kept")
        prim.GetPrim().SetInstanceable(True)
    stage.Save()


def write_arrays(folder):
    """About 10 MB of numbers that no coding makes shorter."""
    stage = stage_at(folder, "arrays.usdc", 60)
    rng = np.random.default_rng(1)
    random = lambda side: Vt.Vec3fArrayFromBuffer(rng.random((side * side, 3), dtype=np.float32))
    define_mesh(stage, "/World/Still", 400)[0].GetPointsAttr().Set(random(400))
    moving = define_mesh(stage, "/World/Moving", 100)[0].GetPointsAttr()
    moving.Clear()
    for frame in range(60):
        moving.Set(random(100), frame)
    stage.Save()


def write_prims(folder):
    layer = Sdf.Layer.CreateNew(os.path.join(folder, "prims.usdc"))
    types = Sdf.ValueTypeNames

    def define(path):
        spec = Sdf.CreatePrimInLayer(layer, path)
        spec.specifier, spec.typeName = Sdf.SpecifierDef, "Xform"
        return spec

    with Sdf.ChangeBlock():
        define("/World")
        for i in range(60000):
            if i % 100 == 0:
                define(f"/World/Group{i // 100}")
            spec = define(f"/World/Group{i // 100}/Prim{i}")
            Sdf.AttributeSpec(spec, "xformOp:translate", types.Double3).default = Gf.Vec3d(i / 7, i, 0.1)
            Sdf.AttributeSpec(spec, "xformOpOrder", types.TokenArray).default = ["xformOp:translate"]
            Sdf.AttributeSpec(spec, "userProperties:label", types.String).default = f"prim {i}"
    layer.Save()


def write(folder):
    text, crate, package = (os.path.join(folder, f"million.{kind}") for kind in ("usda", "usdc", "usdz"))
    Sdf.Layer.FindOrOpen(text).Export(crate)
    UsdUtils.CreateNewUsdzPackage(crate, package)
    write_moving(folder)
    write_instances(folder)
    write_arrays(folder)
    write_prims(folder)
    write_skinned(folder)
    stage = stage_at(folder, "subdivision.usdc")
    define_mesh(stage, "/Sheet", VERTICES_ASIDE + 1, "catmullClark")
    stage.Save()


def write_load(folder):
    """A character of many meshes with a long animation; instances of a cage and of a mesh, each with a scale of its own."""
    write_skinned(folder, "dancer.usdc", DANCER_FRAMES, DANCER_MESHES, 24)
    stage = stage_at(folder, "pots.usdc")
    stage.CreateClassPrim("/Kept")
    define_mesh(stage, "/Kept/Sheet", 32, "catmullClark")
    for i, place in enumerate(places().tolist()):
        prim = UsdGeom.Xform.Define(stage, f"/Pot{i}")
        prim.AddTranslateOp().Set(tuple(place))
        prim.AddScaleOp().Set((1 + i / INSTANCES,) * 3)
        prim.GetPrim().GetReferences().AddInternalReference("/Kept")
        prim.GetPrim().SetInstanceable(True)
    stage.Save()
    for name, scales in (("alike.usdc", np.ones(CROWD)), ("own.usdc", 1 + np.arange(CROWD) / CROWD)):
        stage = stage_at(folder, name)
        instancer = UsdGeom.PointInstancer.Define(stage, "/Crowd")
        define_mesh(stage, "/Crowd/Sheet", 23)
        instancer.CreatePrototypesRel().SetTargets(["/Crowd/Sheet"])
        instancer.CreateProtoIndicesAttr([0] * CROWD)
        instancer.CreatePositionsAttr(Vt.Vec3fArrayFromBuffer(places(CROWD)))
        instancer.CreateScalesAttr([Gf.Vec3f(float(s)) for s in scales])
        stage.Save()


def tell(stage):
    """Points and normals at all their times, faces, uvs, world matrices; instances once, and their matrices."""
    kept = []
    matrices = UsdGeom.XformCache()
    prims = [*stage.Traverse(), *(prim for root in stage.GetPrototypes() for prim in Usd.PrimRange(root))]
    for prim in prims:
        if prim.IsA(UsdGeom.Imageable):
            kept.append(np.array(matrices.GetLocalToWorldTransform(prim)))
        if prim.IsA(UsdGeom.Mesh):
            mesh = UsdGeom.Mesh(prim)
            for attribute in (mesh.GetPointsAttr(), mesh.GetNormalsAttr()):
                kept.extend(np.array(attribute.Get(t)) for t in attribute.GetTimeSamples() or [Usd.TimeCode.Default()])
            kept.append(np.array(mesh.GetFaceVertexCountsAttr().Get()))
            kept.append(np.array(mesh.GetFaceVertexIndicesAttr().Get()))
            if UsdGeom.PrimvarsAPI(prim).HasPrimvar("st"):
                kept.append(np.array(UsdGeom.PrimvarsAPI(prim).GetPrimvar("st").ComputeFlattened()))
        elif prim.IsA(UsdGeom.PointInstancer):
            kept.append(np.array(UsdGeom.PointInstancer(prim).ComputeInstanceTransformsAtTime(0, 0)))
    return kept


def memory(which):
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) * 1024 for line in status if line.startswith(which))


def read(path):
    before, began = memory("VmRSS"), time.perf_counter()
    stage = Usd.Stage.Open(path)
    if any(prim.IsA(UsdSkel.Root) for prim in stage.Traverse()):
        UsdSkel.BakeSkinning(stage.Traverse(), Gf.Interval(stage.GetStartTimeCode(), stage.GetEndTimeCode()))
    kept = tell(stage)
    seconds = time.perf_counter() - began
    assert len(kept) > 0
    return {"seconds": seconds, "bytes": memory("VmHWM") - before}


if __name__ == "__main__":
    command, *place = sys.argv[1:]
    if command == "write":
        write(*place)
    elif command == "load":
        write_load(*place)
    elif command == "read":
        print(json.dumps(read(*place)))
