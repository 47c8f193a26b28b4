import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../../tests/support/pythonOracles.ts';
import type { Vec3 } from '../../../../math/vec3.ts';
import { applyPose } from '../../../../scene/motion/poses.ts';
import type { LocalLight } from '../../../../scene/types.ts';
import { blackbodyColor } from '../../../../spectrum/color/blackbodyColor.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { readUsd } from '../../read.ts';
import { writeUsda } from '../../write/writeUsd.ts';

const available = hasUsdCore();

const folder = mkdtempSync(join(tmpdir(), 'slowlight-lamps-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** Lights of a file by usd-core: sizes, cone and, in metres, the ends of the axes. */
const SCRIPT = `
import json, sys
from pxr import Gf, Usd, UsdGeom, UsdLux
stage = Usd.Stage.Open(sys.argv[1])
unit = UsdGeom.GetStageMetersPerUnit(stage)
out = {}
for prim in stage.Traverse():
    if not prim.HasAPI(UsdLux.LightAPI): continue
    size = lambda name: prim.GetAttribute('inputs:' + name).Get() if prim.HasAttribute('inputs:' + name) else 0
    cone = UsdLux.ShapingAPI(prim).GetShapingConeAngleAttr().Get() if prim.HasAPI(UsdLux.ShapingAPI) else None
    x = (size('width') or size('length')) / 2 or size('radius')
    y = size('height') / 2 or size('radius')
    to_world = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(0)
    ends = [[unit * c for c in to_world.Transform(Gf.Vec3d(*p))] for p in [(x, 0, 0), (0, y, 0)]]
    front = Gf.Vec3d(to_world.TransformDir(Gf.Vec3d(0, 0, -1))).GetNormalized()
    out[str(prim.GetPath())] = {'ends': ends, 'front': list(front), 'cone': cone}
print(json.dumps(out))
`;

interface Said {
  readonly ends: readonly (readonly number[])[];
  readonly front: readonly number[];
  readonly cone: number | null;
}
function saidByUsd(name: string, text: string): Record<string, Said> {
  const path = join(folder, name);
  writeFileSync(path, text);
  return JSON.parse(python('-c', SCRIPT, path));
}

const placedBy = (angle: number, scale: string): string => `
        double3 xformOp:translate = (${angle}, 20, -3)
        float3 xformOp:rotateXYZ = (${angle}, ${2 * angle}, -30)
        double3 xformOp:scale = ${scale}
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateXYZ", "xformOp:scale"]`;
const STAGE = `#usda 1.0
(
    metersPerUnit = 0.01
)
def Xform "World"
{${placedBy(25, '(2, 2, 2)')}
    def RectLight "Rect"
    {
        float inputs:width = 30
        float inputs:height = 12${placedBy(70, '(3, 0.5, 1)')}
    }
    def DiskLight "Disk"
    {
        float inputs:radius = 7${placedBy(-40, '(1, 1, -1)')}
    }
    def CylinderLight "Tube" (
        prepend apiSchemas = ["ShapingAPI"]
    )
    {
        float inputs:radius = 2
        float inputs:length = 50
        float inputs:shaping:cone:angle = 35${placedBy(110, '(4, 1, 1)')}
    }
}
`;

/** The same of a light as read here; only the sign of its size along Y may differ. */
function ofLamp(lamp: LocalLight) {
  if (lamp.motion.kind !== 'static') throw new Error(lamp.motion.kind);
  const { pose } = lamp.motion;
  const x = lamp.kind === 'rect' ? lamp.width / 2 : lamp.kind === 'cylinder' ? lamp.length / 2 : lamp.radius;
  const y = lamp.kind === 'rect' ? lamp.height / 2 : lamp.radius;
  const at = (v: Vec3) => applyPose(pose, v);
  const front = applyPose({ ...pose, position: [0, 0, 0] }, [0, 0, -1]);
  return { x: at([x, 0, 0]), ys: [at([0, y, 0]), at([0, -y, 0])], front };
}
const near = (v: readonly number[]) => v.map((c) => expect.closeTo(c, 5));

it.runIf(available)('lights are where usd-core has them, also when written', async () => {
  const scene = await readUsd(memorySource({ 'a.usda': new TextEncoder().encode(STAGE) }), 'a.usda');
  expect(scene.lights).toHaveLength(3);
  for (const [name, text] of [
    ['a.usda', STAGE],
    ['written.usda', writeUsda(scene)],
  ]) {
    const said = saidByUsd(name, text);
    for (const light of scene.lights) {
      if (!('motion' in light)) throw new Error(light.kind);
      const { ends, front, cone } = said[light.path];
      const own = ofLamp(light);
      expect(own.x).toEqual(near(ends[0]));
      expect(own.ys).toContainEqual(near(ends[1]));
      expect(own.front).toEqual(near(front));
      if (light.shaping) expect((light.shaping.outer * 180) / Math.PI).toBeCloseTo(cone!, 4);
    }
  }
});

it.runIf(available)(
  'a blackbody has the colour that usd-core gives it, to half a percent of its brightest part',
  () => {
    const temperatures = [1900, 2500, 3000, 4000, 5500, 6500, 8000, 10000];
    const script = `import json\nfrom pxr import UsdLux\nprint(json.dumps([list(UsdLux.BlackbodyTemperatureAsRgb(t)) for t in ${JSON.stringify(temperatures)}]))`;
    const said: number[][] = JSON.parse(python('-c', script));
    temperatures.forEach((T, i) => {
      blackbodyColor(T).forEach((value, k) => {
        expect(Math.abs(value - said[i][k]) / Math.max(...said[i])).toBeLessThan(0.0055);
      });
    });
  },
);
