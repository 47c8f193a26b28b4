import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../../tests/support/pythonOracles.ts';
import { skinnedScene } from '../../../../../tests/support/skinnedScene.ts';
import { pointSamples, vertexPosition } from '../../../../scene/motion/motion.ts';
import { isBlended } from '../../../../scene/streaming/samplePoints.ts';
import { saveScene } from '../../../save.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-skeletons-'));
afterAll(() => rmSync(folder, { recursive: true }));
const BAKE = fileURLToPath(new URL('../../schema/skel/fixtures/oracle.py', import.meta.url));
/** What usd-core's validators say of a stage, and the points of its meshes with animated transforms [units]. */
const CHECK = `
import json, sys
from pxr import Gf, Usd, UsdGeom, UsdSkel, UsdValidation
stage = Usd.Stage.Open(sys.argv[1])
known = UsdValidation.ValidationRegistry()
names = [m.name for m in known.GetAllValidatorMetadata() if 'UsdSkel' in m.name or 'usdSkel' in m.name]
context = UsdValidation.ValidationContext([known.GetOrLoadValidatorByName(n) for n in names])
print(json.dumps([names, [str(e.GetMessage()) for e in context.Validate(stage)]]))
`;

describe.skipIf(!hasUsdCore())('usd-core', () => {
  it.each([
    ['a.usda', 'Z', 0.01],
    ['a.usdc', 'Y', 1],
  ] as const)('bakes the skeletons of a written %s to the same points', async (name, upAxis, metersPerUnit) => {
    const scene = skinnedScene({ upAxis, metersPerUnit });
    const { files } = await saveScene(scene, name);
    const path = join(folder, name);
    writeFileSync(path, files.get(name)!);
    const times = [scene.startTime, 0.25, 1, 2.5];
    const codes = times.map((t) => `${t * scene.timeCodesPerSecond}`);
    const baked: Record<string, { readonly points: number[] }[]> = JSON.parse(python(BAKE, 'file', path, ...codes));
    let compared = 0;
    for (const object of scene.objects) {
      const samples = pointSamples(object.motion);
      if (!samples || !isBlended(samples.points)) continue;
      const own = baked[object.path] ?? baked[`${object.path}/Mesh`];
      times.forEach((t, i) => {
        for (let v = 0; v < object.mesh.positions.length / 3; v += 5) {
          const p = vertexPosition(object, v, t, 1e9);
          const off = Math.hypot(...p.map((x, axis) => x - metersPerUnit * own[i].points[3 * v + axis]));
          expect(off, `${object.path}, point ${v} at ${t} s`).toBeLessThan(1e-3);
        }
        compared++;
      });
    }
    expect(compared).toBe(4 * 6);
  });

  it('finds nothing wrong with them', async () => {
    const { files } = await saveScene(skinnedScene(), 'b.usda');
    const path = join(folder, 'b.usda');
    writeFileSync(path, files.get('b.usda')!);
    const [names, errors]: [string[], string[]] = JSON.parse(python('-c', CHECK, path));
    expect(names.length).toBeGreaterThan(0);
    expect(errors).toEqual([]);
  });
});
