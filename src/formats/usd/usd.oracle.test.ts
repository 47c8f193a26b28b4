import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../tests/support/pythonOracles.ts';
import { sphere } from '../../scene/mesh/primitives.ts';
import { vertexPosition } from '../../scene/motion/motion.ts';
import type { Mesh, Scene, SceneObject } from '../../scene/types.ts';
import { memorySource } from '../files/fileSource.ts';
import { layerJson } from './fixtures/layerJson.ts';
import { readUsd } from './read.ts';
import { parseLayer } from './text/parser.ts';
import { writeUsda, writeUsdz } from './write/writeUsd.ts';

const fixture = (name: string): string => fileURLToPath(new URL(`./fixtures/${name}`, import.meta.url));

const available = hasUsdCore();

interface StageJson {
  times: number[];
  prims: Record<string, { matrices: number[][]; points?: number[][]; fovY?: number }>;
}
interface OracleJson {
  layer: Record<string, unknown>;
  stage?: StageJson;
}
const oracle = (path: string): OracleJson => JSON.parse(python(fixture('oracle.py'), path))[path];

const folder = mkdtempSync(join(tmpdir(), 'slowlight-usd-'));
afterAll(() => rmSync(folder, { recursive: true }));

function save(name: string, content: string | Uint8Array): string {
  const path = join(folder, name);
  writeFileSync(path, content);
  return path;
}

const ball: Mesh = sphere(1.5, { segments: 12 });
const pose = { position: [0.1, -2e3, 1 / 3], orientation: [0.5, 0.5, -0.5, 0.5] } as const;
const wave = (k: number): Float32Array => ball.positions.map((x, i) => x * (1 + 0.1 * Math.sin(i + k)));
const object = (path: string, rest: Partial<SceneObject>): SceneObject => ({
  path,
  mesh: ball,
  motion: { kind: 'static', pose },
  lifetime: { birth: -Infinity, death: Infinity },
  authoredIn: 'world',
  ...rest,
});
const scene: Scene = {
  name: 'written',
  upAxis: 'Z',
  metersPerUnit: 1,
  timeCodesPerSecond: 30,
  startTime: 0,
  endTime: 2,
  objects: [
    object('/World/Static', {}),
    object('/World/Static/Nested', {}),
    object('/World/Moving', {
      motion: {
        kind: 'sampled',
        times: Float64Array.of(0, 1 / 3, 2),
        poses: Float64Array.of(0, 0, 0, 0, 0, 0, 1, 1e6 / 3, 0.2, 0.3, 0, 0.6, 0, 0.8, 1, 0, 0, 0, 1, 0, 0),
      },
    }),
    object('/World/Waving', {
      motion: {
        kind: 'sampled-points',
        times: Float64Array.of(0, 0.1, 2),
        origin: [1e5, 0, 0.5],
        points: [wave(0), wave(1), wave(2)],
      },
    }),
  ],
  materials: [
    {
      name: '/Looks/A',
      baseColor: [1, 1, 1],
      emissive: [0, 0, 0],
      roughness: 0.5,
      metallic: 0,
      opacity: 1,
      opacityThreshold: 0,
      reflectance: { first: 4e-7, step: 1e-7, values: [0.1, 0.5, 0.9] },
    },
  ],
  lights: [],
  cameras: [{ path: '/Camera', motion: { kind: 'static', pose }, fovY: 0.75 }],
  hints: { title: 'é "quoted" \\ and\ttabs' },
  diagnostics: [],
};

describe.skipIf(!available)('usd-core', () => {
  it.each(['grammar', 'xforms', 'meshes', 'written'])('reproduces the committed values of %s.usda', (name) => {
    const committed = JSON.parse(readFileSync(fixture(`${name}.expected.json`), 'utf8'));
    expect(oracle(fixture(`${name}.usda`))).toEqual(committed);
  });

  it('reads written points and poses exactly', () => {
    const text = writeUsda(scene);
    const { stage, layer } = oracle(save('written.usda', text));
    expect(layerJson(parseLayer(new TextEncoder().encode(text), 'written.usda'))).toEqual(layer);
    const spec = (path: string): never => layer[path] as never;
    const { timeSamples: points } = spec('/World/Waving.points') as { timeSamples: [number, number[]][] };
    expect(points.map(([t]) => t / 30)).toEqual([0, 0.1, 2]);
    for (const [k, [, values]] of points.entries()) expect(Float32Array.from(values)).toEqual(wave(k));
    const { timeSamples: moves } = spec('/World/Moving.xformOp:translate') as { timeSamples: [number, number[]][] };
    expect(moves.map(([, p]) => p)).toEqual([
      [0, 0, 0],
      [1e6 / 3, 0.2, 0.3],
      [1, 0, 0],
    ]);
    for (const path of ['/World/Static', '/World/Static/Nested'])
      expect(stage!.prims[path].matrices[0].slice(12, 15)).toEqual([...pose.position]);
    expect(stage!.prims['/Camera'].fovY).toBeCloseTo(0.75, 6);
    expect(JSON.stringify(spec('/Looks/A.slowlight:reflectance'))).toContain('spectra/reflectance.csv');
  });

  it('opens a written package', () => {
    const path = save('written.usdz', writeUsdz(scene));
    const script = `
from pxr import Usd, UsdUtils
stage = Usd.Stage.Open(r'${path}')
print(len(list(stage.Traverse())), stage.GetDefaultPrim().GetPath())`;
    expect(python('-c', script).trim()).toBe('9 /World');
  });

  it('agrees with this reader on vertices, at random times', async () => {
    const text = writeUsda(scene);
    const back = await readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda');
    const { stage } = oracle(save('again.usda', text));
    for (const { path, motion, ...rest } of back.objects) {
      const prim = stage!.prims[path];
      stage!.times.forEach((code, k) => {
        const m = prim.matrices[k].map(Number);
        // −0 is encoded as a string in JSON.
        const points = prim.points![k].map(Number);
        for (let i = 0; i < points.length / 3; i += 17) {
          const p = points.slice(3 * i, 3 * i + 3);
          const expected = [0, 1, 2].map((d) => p[0] * m[d] + p[1] * m[4 + d] + p[2] * m[8 + d] + m[12 + d]);
          const actual = vertexPosition({ path, motion, ...rest }, i, code / 30, 3e8);
          // f32 rounding of points near 10⁵ m, and the chord tolerance of a rotating ball.
          expect(Math.hypot(...actual.map((x, d) => x - expected[d])), `${path} ${code}`).toBeLessThan(1e-3);
        }
      });
    }
  });
});
