import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { outputFolder, scene, slowlight, slowlightJson } from './program.ts';

const folder = outputFolder();

interface Inspection {
  readonly counts: Record<string, number>;
  readonly startTime: number;
  readonly endTime: number;
  readonly fastest: { path: string; speed: number; fractionOfC: number };
  readonly objects: { path: string; motion: string; samples: number; triangles: number }[];
}

test('reports counts, times and the fastest point', async () => {
  const found = await slowlightJson<Inspection>('inspect', scene('movers.usda'));
  expect(found.counts).toMatchObject({ objects: 3, triangles: 36, lights: 1, cameras: 2 });
  expect([found.startTime, found.endTime]).toEqual([0, 2]);
  expect(found.fastest).toMatchObject({ path: '/World/Leaving', speed: 6, fractionOfC: 0.6 });
  expect(found.objects.map(({ motion }) => motion)).toEqual(['static', 'uniform', 'sampled']);
});

test('prints the tree as text', async () => {
  const { code, out } = await slowlight('inspect', scene('movers.usda'));
  expect(code).toBe(0);
  expect(out).toContain('└─ World');
  expect(out).toMatch(/Leaving {2}\(12 triangles, uniform\)/);
  expect(out).toContain('0.600000 c');
});

test('a point faster than light is an error with prim, speed and a remedy', async () => {
  const { code, out, err } = await slowlight('inspect', scene('too-fast.usda'));
  expect(code).toBe(3);
  expect(out).toMatch(/error: .*\/World\/Leaving.*c/);
  expect(err).toContain('an error');
  expect((await slowlight('inspect', scene('too-fast.usda'), '--c', '20')).code).toBe(0);
});

test('undersampled motion is reported, and cubic interpolation is used on request', async () => {
  const file = join(folder, 'cloth.usda');
  const points = [0, 6, 12, 18]
    .map((code) => `${code}: [(0, 0, ${(code / 12) ** 2}), (1, 0, 0), (0, 1, 0)]`)
    .join(', ');
  writeFileSync(
    file,
    `#usda 1.0
(
  metersPerUnit = 1
)
def Mesh "Cloth" {
  uniform token subdivisionScheme = "none"
  int[] faceVertexCounts = [3]
  int[] faceVertexIndices = [0, 1, 2]
  point3f[] points.timeSamples = { ${points} }
}
def Cube "Wheel" {
  float xformOp:rotateZ.timeSamples = { 0: 0, 12: 120 }
  uniform token[] xformOpOrder = ["xformOp:rotateZ"]
}
`,
  );
  const linear = await slowlight('inspect', file);
  expect(linear.out).toMatch(/Cloth {2}\(1 triangle, sampled-points, 4 samples\)/);
  expect(linear.out).toMatch(
    /<\/Cloth>: between its 4 samples its points go straight; along cubics .* up to 0\.\d+ m elsewhere/,
  );
  expect(linear.out).toMatch(/paths between samples are /);
  const cubic = await slowlight('inspect', file, '--interpolation', 'cubic', '--c', '20');
  expect(cubic.code).toBe(0);
  expect(cubic.out).toContain('sampled-points along cubics');
  expect((await slowlight('inspect', file, '--interpolation', 'quintic')).code).toBe(2);
  const at = async (name: string) =>
    (
      await slowlightJson<{ vertices: { velocity: number[] }[] }>(
        ...['probe', file, '--interpolation', name, '--prim', '/Cloth', '--time', '0.3', '--view', 'galilean'],
        ...['--c', '20', '--position', '0,0,5'],
      )
    ).vertices[0]!.velocity[2]! * 20;
  // Velocity of x = (2t)² at 0.3 s: 8t with cubics, that of the chord from 0.25 to 0.5 s without.
  expect(await at('cubic')).toBeCloseTo(2.4, 5);
  expect(await at('linear')).toBeCloseTo(3, 5);
});

test('unreadable files are rejected by name', async () => {
  const empty = join(folder, 'empty.usda');
  writeFileSync(empty, '');
  const cut = join(folder, 'cut.usda');
  writeFileSync(cut, '#usda 1.0\ndef Xform "World" {');
  const other = join(folder, 'picture.bmp');
  writeFileSync(other, 'BM');
  for (const file of [empty, cut, other, join(folder, 'nothing.usda')]) {
    const { code, err } = await slowlight('inspect', file);
    expect(code, err).toBe(3);
    expect(err).toMatch(/^slowlight: \S+\.(usda|bmp)/);
    expect(err).not.toContain('    at ');
  }
});

test('a subdivision surface has the requested levels', async () => {
  const path = join(folder, 'sheet.usda');
  writeFileSync(
    path,
    '#usda 1.0\ndef Mesh "Sheet" { int[] faceVertexCounts = [4]; int[] faceVertexIndices = [0, 1, 2, 3]; point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0)] }\n',
  );
  const triangles = async (...flags: string[]): Promise<number | undefined> =>
    (await slowlightJson<Inspection>('inspect', path, ...flags)).counts.triangles;
  expect(await triangles()).toBe(2 * 256);
  expect(await triangles('--subdivision', '0')).toBe(2);
  expect(await triangles('--subdivision', '3')).toBe(2 * 64);
  expect((await slowlight('inspect', path, '--subdivision', '9')).code).toBe(2);
});
