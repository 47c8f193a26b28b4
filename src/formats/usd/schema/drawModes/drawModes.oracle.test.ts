import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../../tests/support/pythonOracles.ts';
import { boundingBox } from '../../../../scene/bounds/bounds.ts';
import { vertexPositions } from '../../../../scene/motion/motion.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { readUsd } from '../../read.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-draw-modes-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** By path of the model: its mode as it is inherited, whether it is applied, and the corners of its own box in the world. */
const SCRIPT = `
import json, sys
from pxr import Gf, Kind, Usd, UsdGeom
stage = Usd.Stage.Open(sys.argv[1])
cache = UsdGeom.BBoxCache(Usd.TimeCode.EarliestTime(), ['default', 'proxy', 'render'], True)
out = {}
for prim in stage.Traverse():
    model = UsdGeom.ModelAPI(prim)
    asked = prim.GetAttribute('model:applyDrawMode')
    applied = asked.Get() if asked and asked.HasAuthoredValue() else Usd.ModelAPI(prim).GetKind() == 'component'
    if not applied: continue
    box = cache.ComputeUntransformedBound(prim).ComputeAlignedBox()
    to_world = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(0)
    corners = [list(to_world.Transform(box.GetCorner(i))) for i in range(8)]
    out[str(prim.GetPath())] = {'mode': model.ComputeModelDrawMode(), 'corners': corners}
print(json.dumps(out))
`;

interface Said {
  readonly mode: string;
  readonly corners: readonly (readonly number[])[];
}

const SHAPES = `
  def Xform "Body"
  {
    double3 xformOp:translate = (1, 2, 3)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    def Sphere "Ball"
    {
      double radius = 0.5
    }
    def Cube "Low"
    {
      uniform token purpose = "proxy"
      double size = 3
    }
    def Cube "Guide"
    {
      uniform token purpose = "guide"
      double size = 30
    }
    def Mesh "Face"
    {
      int[] faceVertexCounts = [3]
      int[] faceVertexIndices = [0, 1, 2]
      point3f[] points = [(0, 0, 0), (4, 0, 0), (0, 5, 0)]
    }
  }`;

/** A model turned and moved. */
const model = (name: string, kind: string, said: string, body = SHAPES): string => `
def Xform "${name}" ( ${kind && `kind = "${kind}"`} )
{
  ${said}
  double3 xformOp:translate = (10, 0, -4)
  double xformOp:rotateY = 30
  uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateY"]
  ${body}
}`;

const STAGE = `#usda 1.0
( metersPerUnit = 1 )
${model('Component', 'component', 'uniform token model:drawMode = "bounds"')}
${model('Group', 'group', 'uniform token model:drawMode = "bounds"', model('Inside', 'component', '') + model('Real', 'component', 'uniform token model:drawMode = "default"'))}
${model('Refused', 'component', 'uniform token model:drawMode = "bounds"\n  uniform bool model:applyDrawMode = false')}
${model('Asked', 'component', 'uniform token model:drawMode = "cards"\n  uniform bool model:applyDrawMode = true\n  uniform token model:cardGeometry = "box"')}
${model('Hinted', 'component', 'uniform token model:drawMode = "bounds"\n  float3[] extentsHint = [(-1, -2, -3), (1, 2, 3), (0, 0, 0), (7, 1, 1), (0, 0, 0), (1, 1, 9), (0, 0, 0), (99, 1, 1)]')}
${model('Authored', 'component', 'uniform token model:drawMode = "cards"\n  uniform token model:cardGeometry = "box"', 'def Sphere "S"\n{\nfloat3[] extent = [(-4, -1, -1), (1, 1, 6)]\n}')}
${model('Plain', 'component', '')}
${model('NoModel', '', 'uniform token model:drawMode = "bounds"\n  uniform bool model:applyDrawMode = true', SHAPES)}
`;

describe.skipIf(!hasUsdCore())('draw modes', () => {
  it('apply where usd-core says so, at the size that it computes', async () => {
    const file = join(folder, 'models.usda');
    writeFileSync(file, STAGE);
    const said = JSON.parse(python('-c', SCRIPT, file)) as Record<string, Said>;
    expect(Object.keys(said)).toHaveLength(8);
    const scene = await readUsd(memorySource({ 'models.usda': new TextEncoder().encode(STAGE) }), 'models.usda');
    for (const [path, { mode, corners }] of Object.entries(said)) {
      const below = scene.objects.filter((object) => object.path.startsWith(`${path}/`));
      const isStandIn = below.every((object) => /\/(bounds|card[XYZ](Pos|Neg))$/.test(object.path));
      expect([path, isStandIn]).toEqual([path, mode !== 'default']);
      if (mode === 'default') continue;
      const drawn = boundingBox(below.flatMap((object) => [...vertexPositions(object, 0, 3e8)]))!;
      const box = boundingBox(corners.flat())!;
      // Lines are as thick as a hundredth of the longest.
      const slack = mode === 'bounds' ? 0.02 * Math.max(...box.max.map((x, k) => x - box.min[k]!)) : 1e-4;
      for (const k of [0, 1, 2]) {
        expect(Math.abs(drawn.min[k]! - box.min[k]!), `${path} ${k}`).toBeLessThan(slack);
        expect(Math.abs(drawn.max[k]! - box.max[k]!), `${path} ${k}`).toBeLessThan(slack);
      }
    }
  });
});
