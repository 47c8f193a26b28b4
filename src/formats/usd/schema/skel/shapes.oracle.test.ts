import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../../tests/support/pythonOracles.ts';
import { vertexPosition } from '../../../../scene/motion/motion.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { readUsd } from '../../read.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-skinned-shapes-'));
afterAll(() => rmSync(folder, { recursive: true }));

const TIMES = [0, 3, 6, 10, 12];
/** By path, at each of the times: where usd-core's skinned transforms bring the ends of a shape's axes, in the world. */
const SCRIPT = `
import json, sys
from pxr import Gf, Usd, UsdGeom, UsdSkel
stage = Usd.Stage.Open(sys.argv[1])
root = UsdSkel.Root(stage.GetPrimAtPath('/Root'))
cache = UsdSkel.Cache()
cache.Populate(root, Usd.PrimDefaultPredicate)
skeleton = UsdSkel.Skeleton(stage.GetPrimAtPath('/Root/Rig'))
joints = cache.GetSkelQuery(skeleton)
out = {}
for prim in stage.Traverse():
    if not prim.IsA(UsdGeom.Gprim): continue
    query = cache.GetSkinningQuery(prim)
    out[str(prim.GetPath())] = frames = []
    for t in json.loads(sys.argv[2]):
        skinned = query.ComputeSkinnedTransform(joints.ComputeSkinningTransforms(t), t)
        to_world = skinned * UsdGeom.Xformable(skeleton).ComputeLocalToWorldTransform(t)
        frames.append([list(to_world.Transform(Gf.Vec3d(*p))) for p in [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]])
print(json.dumps(out))
`;

const IDENTITY = '((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))';
const bound = (type: string, joints: string, weights: string, more = ''): string => {
  const size = joints.split(',').length;
  return `def ${type} "${type}" ( prepend apiSchemas = ["SkelBindingAPI"] )
  {
    int[] primvars:skel:jointIndices = [${joints}] ( elementSize = ${size}
      interpolation = "constant" )
    float[] primvars:skel:jointWeights = [${weights}] ( elementSize = ${size}
      interpolation = "constant" )
    matrix4d primvars:skel:geomBindTransform = ((0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 1, 0), (0.5, 2, 1, 1))
    double3 xformOp:translate = (3, 1, 2)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    ${more}
  }`;
};
const STAGE = `#usda 1.0
(
  metersPerUnit = 1
  timeCodesPerSecond = 24
)
def SkelRoot "Root" ( prepend apiSchemas = ["SkelBindingAPI"] )
{
  rel skel:skeleton = </Root/Rig>
  rel skel:animationSource = </Root/Rig/Turn>
  double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 12: (4, 0, 0) }
  uniform token[] xformOpOrder = ["xformOp:translate"]
  def Skeleton "Rig"
  {
    uniform token[] joints = ["a", "a/b"]
    uniform matrix4d[] bindTransforms = [${IDENTITY}, ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 1, 0, 1))]
    uniform matrix4d[] restTransforms = [${IDENTITY}, ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 1, 0, 1))]
    def SkelAnimation "Turn"
    {
      uniform token[] joints = ["a", "a/b"]
      float3[] translations.timeSamples = { 0: [(0, 0, 0), (0, 1, 0)], 12: [(0, 0, 2), (0, 1, 0)] }
      quatf[] rotations.timeSamples = { 0: [(1, 0, 0, 0), (1, 0, 0, 0)], 6: [(0.8, 0.6, 0, 0), (0.6, 0, 0, 0.8)], 12: [(1, 0, 0, 0), (0.96, 0, 0.28, 0)] }
      half3[] scales = [(1, 1, 1), (1, 1, 1)]
    }
  }
  ${bound('Cube', '1', '1')}
  ${bound('Sphere', '0, 1', '0.25, 0.75')}
  ${bound('Capsule', '0, 1', '0.5, 0.5', 'uniform token axis = "X"')}
}
`;

describe.skipIf(!hasUsdCore())('shapes that follow joints', () => {
  it('are where usd-core skins them, also between samples', async () => {
    const file = join(folder, 'shapes.usda');
    writeFileSync(file, STAGE);
    const skinned = JSON.parse(python('-c', SCRIPT, file, JSON.stringify(TIMES))) as Record<string, number[][][]>;
    expect(Object.keys(skinned)).toHaveLength(3);
    const { objects, diagnostics } = await readUsd(
      memorySource({ 'shapes.usda': new TextEncoder().encode(STAGE) }),
      'shapes.usda',
      { chordTolerance: 2e-5 },
    );
    expect(diagnostics).toEqual([]);
    const unmoved = await readUsd(
      memorySource({ 'shapes.usda': new TextEncoder().encode(STAGE.replaceAll('skel:jointIndices', 'skel:none')) }),
      'shapes.usda',
    );
    for (const [path, frames] of Object.entries(skinned)) {
      const object = objects.find((each) => each.path === path)!;
      const still = unmoved.objects.find((each) => each.path === path)!.mesh.positions;
      frames.forEach(([o, x, y, z], i) => {
        for (let v = 0; 3 * v < still.length; v += 7) {
          const place = vertexPosition(object, v, TIMES[i]! / 24, 3e8);
          const [a, b, c] = still.subarray(3 * v, 3 * v + 3);
          const expected = [0, 1, 2].map(
            (k) => o![k]! + a! * (x![k]! - o![k]!) + b! * (y![k]! - o![k]!) + c! * (z![k]! - o![k]!),
          );
          const off = Math.hypot(...place.map((p, k) => p - expected[k]!));
          expect(off, `${path}, vertex ${v} at ${TIMES[i]}`).toBeLessThan(1e-4);
        }
      });
    }
  });
});
