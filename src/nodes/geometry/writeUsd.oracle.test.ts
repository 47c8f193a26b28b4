import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { add, build, connect, edited, set } from '../../../tests/support/graphKit.ts';
import { hasUsdCore, python } from '../../../tests/support/pythonOracles.ts';
import { readFont } from '../../cli/files/fonts.ts';
import { Evaluator } from '../../graph/evaluation/evaluator.ts';
import { nodeLibrary } from '../library.ts';
import { exportSceneFile } from '../project/exportSceneFile.ts';
import { fileNodesIn, requestedFiles } from '../project/fileNodes.ts';
import type { SceneOutput } from '../project/outputFiles.ts';
import { type LoadedScene, workerServices } from '../services.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-nodes-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** World points of a mesh at time codes, read by usd-core. */
const pointsAt = (file: string, path: string, codes: readonly number[]): number[][] =>
  JSON.parse(
    python(
      '-c',
      `
import json
from pxr import Usd, UsdGeom
stage = Usd.Stage.Open(r'${file}')
mesh = UsdGeom.Mesh(stage.GetPrimAtPath('${path}'))
def points(code):
    m = UsdGeom.Xformable(mesh).ComputeLocalToWorldTransform(code)
    return [x for p in mesh.GetPointsAttr().Get(code) for x in m.Transform(p)]
print(json.dumps([points(code) for code in ${JSON.stringify(codes)}]))`,
    ),
  );

/** A letter moving at 0.6 c, its shape given at rest, between t = 1 s and t = 3 s. */
const flying = build(
  ...[add('word', 'solid-text'), add('fly', 'motion-uniform'), add('go', 'move'), add('time', 'time')],
  ...[add('usd', 'write-usd'), set('word', 'text', 'B'), set('go', 'authoredIn', 'rest'), set('fly', 'at', 2)],
  { kind: 'set-param', node: 'fly', param: 'velocity', value: [6, 0, 0] },
  ...[set('time', 'from', 1), set('time', 'to', 3), set('usd', 'speedOfLight', 10)],
  ...[
    connect('word.geometry', 'go.geometry'),
    connect('fly.motion', 'go.motion'),
    connect('go.geometry', 'usd.geometry'),
  ],
  connect('time.time', 'usd.time'),
);
const services = { ...workerServices, readFont };

async function asked(motion: 'sampled' | 'exact'): Promise<{ readonly file: SceneOutput; readonly path: string }> {
  const document = edited(flying, set('usd', 'motion', motion));
  const writers = fileNodesIn(document);
  const evaluation = await new Evaluator(nodeLibrary).evaluate(document, [...writers.keys()], services);
  const file = requestedFiles(evaluation, writers).get('usd');
  if (file?.kind !== 'scene') throw new Error('the node asks for no scene');
  const path = join(folder, `${motion}.usda`);
  writeFileSync(path, (await exportSceneFile(file, 'geometry.usda')).files.get('geometry.usda')!);
  return { file, path };
}

describe.skipIf(!hasUsdCore())('Pixar’s usd-core and the node that writes USD', () => {
  it('writes the points of a moving letter in the world frame: contracted, and along their motion', async () => {
    const { path } = await asked('sampled');
    const word = (await new Evaluator(nodeLibrary).evaluate(flying, 'word', services)).target;
    if (word.status !== 'done') throw new Error('no letter');
    const rest = (word.outputs.geometry as LoadedScene).scene.objects[0]!.mesh.positions;
    const [times, codes] = [
      [1, 1.7, 3],
      [24, 40.8, 72],
    ];
    for (const [k, points] of pointsAt(path, '/Text', codes).entries()) {
      expect(points).toHaveLength(rest.length);
      const wanted = Array.from(rest, (x, i) => (i % 3 === 0 ? 0.8 * x + 6 * (times[k]! - 2) : x));
      expect(Math.max(...points.map((x, i) => Math.abs(x - wanted[i]!)))).toBeLessThan(1e-4);
    }
  });

  it('writes the points of the shape itself, to the last bit, with exact motions', async () => {
    const { file, path } = await asked('exact');
    const [points] = pointsAt(path, '/Text', [24]);
    const { mesh, motion } = file.scene.objects[0]!;
    if (motion.kind !== 'uniform') throw new Error(`it moves as ${motion.kind}`);
    const x = motion.pose.position[0];
    expect(points!.map((value, i) => (i % 3 === 0 ? Math.fround(value - x) : value))).toEqual(
      Array.from(mesh.positions),
    );
  });
});
