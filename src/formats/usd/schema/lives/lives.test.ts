import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { vertexPosition } from '../../../../scene/motion/motion.ts';
import type { Scene } from '../../../../scene/types.ts';
import { probeVertex } from '../../../../scene/view/probe.ts';
import { memorySource } from '../../../files/fileSource.ts';
import type { ReadOptions } from '../../../readOptions.ts';
import { readUsd } from '../../read.ts';
import { writeUsda, writeUsdc } from '../../write/writeUsd.ts';
import { type TrianglesAtTimes, trianglesApart, visibleTriangles } from './fixtures/visibleTriangles.ts';

const fixture = (name: string): Buffer => readFileSync(new URL(`./fixtures/${name}`, import.meta.url));
const read = (text: string, options: ReadOptions = {}) =>
  readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda', options);
const stage = (prims: string): string =>
  `#usda 1.0\n(\n metersPerUnit = 1\n timeCodesPerSecond = 1\n startTimeCode = 0\n endTimeCode = 8\n)\n${prims}`;
const lives = (text: string) =>
  read(stage(text)).then(({ objects }) => objects.map(({ path, lifetime: { birth, death } }) => [path, birth, death]));

const TRIANGLE = `uniform token subdivisionScheme = "none"\nuniform bool doubleSided = 1
  int[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0, 1, 2]\npoint3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]`;
/** A triangle at code 0, two triangles 1 m above at code 2, nothing at code 4. */
const CHANGING = `uniform token subdivisionScheme = "none"
  int[] faceVertexCounts.timeSamples = { 0: [3], 2: [3, 3], 4: [] }
  int[] faceVertexIndices.timeSamples = { 0: [0, 1, 2], 2: [0, 1, 2, 2, 1, 3], 4: [] }
  point3f[] points.timeSamples = { 0: [(0, 0, 0), (1, 0, 0), (0, 1, 0)],
    2: [(0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1)], 4: [] }`;
const VELOCITIES = `vector3f[] velocities.timeSamples = { 0: [(0, 0, 3), (0, 0, 3), (0, 0, 3)],
    2: [(4, 0, 0), (4, 0, 0), (4, 0, 0), (4, 0, 0)], 4: [] }`;
const said = ({ diagnostics }: Awaited<ReturnType<typeof read>>) =>
  diagnostics.map(({ severity, code }) => `${severity} ${code}`);

describe('a stage of usd-core', () => {
  it('shows the same triangles as usd-core at each time', async () => {
    const scene = await readUsd(memorySource({ 'lives.usda': fixture('lives.usda') }), 'lives.usda', {
      chordTolerance: 1e-6,
    });
    const expected = JSON.parse(fixture('lives.expected.json').toString()) as TrianglesAtTimes;
    for (const [code, triangles] of Object.entries(expected)) {
      // Before its first sample a piece with velocities rests here; usd-core lets it come from infinitely far.
      const { '/Water': water, ...others } = visibleTriangles(scene, Number(code) / 24);
      const { '/Water': known, ...rest } = triangles;
      expect(trianglesApart(others, rest), code).toBeLessThan(1e-5);
      if (Number(code) >= 0) expect(trianglesApart({ water }, { water: known }), code).toBeLessThan(1e-5);
    }
    expect(Object.values(expected).flatMap((of) => Object.keys(of)).length).toBeGreaterThan(80);
  });
});

describe('visibility', () => {
  const CUBE = (name: string, samples: string, inside = ''): string =>
    `def Cube "${name}" { ${samples === '' ? '' : `token visibility.timeSamples = { ${samples} }`}\n${inside} }`;

  it('is held from sample to sample, the first one also before it', async () => {
    expect(
      await lives(CUBE('A', '1: "inherited", 2: "invisible", 3: "inherited", 5: "inherited", 7: "invisible"')),
    ).toEqual([
      ['/A/piece1', -Infinity, 2],
      ['/A/piece2', 3, 7],
    ]);
    expect(await lives(CUBE('A', '1: "invisible", 2: "inherited"'))).toEqual([['/A', 2, Infinity]]);
    expect(await lives(CUBE('A', '1: "invisible", 2: "invisible"'))).toEqual([]);
    // A blocked sample is the fallback, inherited.
    expect(await lives(CUBE('A', '1: "invisible", 2: None, 3: "invisible"'))).toEqual([['/A', 2, 3]]);
  });

  it('of more times than a scene has objects is cut, which is said, and quickly', async () => {
    const samples = Array.from({ length: 60_000 }, (_, k) => `${k}: "${k % 2 ? 'invisible' : 'inherited'}"`);
    const children = Array.from({ length: 20 }, (_, k) => `def Cube "C${k}" {}`).join('\n');
    const scene = await read(stage(`def Xform "G" { token visibility.timeSamples = { ${samples} }\n${children} }`));
    expect(scene.objects.length).toBeGreaterThanOrEqual(250_000);
    expect(scene.objects.length).toBeLessThan(250_300);
    expect(said(scene)).toContain('warning usd.too-many-instances');
  });

  it('of prims above, and authored lifetimes, intersect with it', async () => {
    const group = (samples: string, child: string): string =>
      `def Xform "G" { token visibility.timeSamples = { ${samples} }\n${child} }`;
    expect(await lives(group('0: "invisible", 2: "inherited", 6: "invisible"', CUBE('A', '')))).toEqual([
      ['/G/A', 2, 6],
    ]);
    expect(
      await lives(
        group(
          '0: "invisible", 2: "inherited", 6: "invisible"',
          CUBE('A', '0: "inherited", 3: "invisible", 4: "inherited"', 'double slowlight:death = 5'),
        ),
      ),
    ).toEqual([
      ['/G/A/piece1', 2, 3],
      ['/G/A/piece2', 4, 5],
    ]);
  });

  it('of instancers and prototypes intersects with the lives of instances', async () => {
    const text = `def PointInstancer "P" { token visibility.timeSamples = { 0: "inherited", 4: "invisible", 6: "inherited" }
  rel prototypes = [</P/T>]\nint[] protoIndices = [0, 0]\npoint3f[] positions = [(0, 0, 0), (5, 0, 0)]
  int64[] invisibleIds.timeSamples = { 0: [], 2: [1], 7: [] }
  def Cube "T" { token visibility.timeSamples = { 0: "invisible", 1: "inherited" } } }`;
    const found = (await lives(text)).map(([path, ...life]) => [String(path).replace(/\.\d+\]/, ']'), ...life]);
    expect(found.sort((a, b) => (a.join() < b.join() ? -1 : 1))).toEqual([
      ['/P[0]/T/piece1', 1, 4],
      ['/P[0]/T/piece2', 6, Infinity],
      ['/P[1]/T', 1, 2],
      ['/P[1]/T', 7, Infinity],
    ]);
  });

  it('is the lifetime of local lights; others are held at the start, which is said', async () => {
    const blinking = 'token visibility.timeSamples = { 0: "inherited", 2: "invisible", 3: "inherited" }';
    const scene = await read(
      stage(
        `def SphereLight "L" { ${blinking} }\ndef DistantLight "S" { ${blinking} }\ndef Camera "C" { ${blinking} }`,
      ),
    );
    expect(scene.lights.map((light) => [light.path, 'lifetime' in light && light.lifetime.death])).toEqual([
      ['/L/piece1', 2],
      ['/L/piece2', Infinity],
      ['/S', false],
    ]);
    expect(scene.cameras).toHaveLength(1);
    expect(said(scene)).toContain('warning usd.animated-visibility');
  });

  it('of a birth at t₀ is seen after the light has come: t₀ + d/c', async () => {
    const [cube] = (await read(stage(CUBE('A', '0: "invisible", 2: "inherited"')))).objects;
    const [c, d] = [10, 30];
    const near = cube.mesh.positions.findIndex((x, i) => i % 3 === 2 && x === 1);
    const seen = (t: number) =>
      probeVertex(
        cube,
        Math.floor(near / 3),
        { t, position: [cube.mesh.positions[near - 2], cube.mesh.positions[near - 1], 1 + d], u: [0, 0, 0] },
        c,
      )!;
    expect(seen(2 + d / c - 1e-6).visible).toBe(false);
    expect(seen(2 + d / c + 1e-6).visible).toBe(true);
  });
});

describe('topology', () => {
  it('that changes is a sequence of meshes, each alive until the next', async () => {
    const scene = await read(stage(`def Mesh "W" { ${CHANGING} }`));
    expect(scene.objects.map(({ path, pieceOf, lifetime }) => [path, pieceOf, lifetime.birth, lifetime.death])).toEqual(
      [
        ['/W/piece1', '/W', -Infinity, 2],
        ['/W/piece2', '/W', 2, 4],
      ],
    );
    expect(scene.objects.map(({ mesh }) => mesh.indices.length / 3)).toEqual([1, 2]);
    expect(scene.objects.map(({ motion }) => motion.kind)).toEqual(['static', 'static']);
    expect(said(scene)).toEqual(['warning usd.topology']);
  });

  it('with velocities each moves with them, and shows their Doppler shift', async () => {
    const scene = await read(stage(`def Mesh "W" { ${CHANGING}\n${VELOCITIES} }`));
    const [first, second] = scene.objects;
    const c = 5;
    const doppler = (object: typeof first, t: number, u = 0) =>
      probeVertex(object, 0, { t, position: [0, 0, 20], u: [0, 0, u] }, c)!;
    // It comes at 0.6 c: D = √((1 + β)/(1 − β)) = 2. Seen at t = 4.4 s: emitted at t = 1 s at z = 3.
    expect(doppler(first, 4.4)).toMatchObject({ visible: true });
    expect(doppler(first, 4.4).time).toBeCloseTo(1, 6);
    expect(doppler(first, 4.4).doppler).toBeCloseTo(2, 6);
    // Before its first sample it rests.
    expect(doppler(first, 3).doppler).toBeCloseTo(1, 6);
    // Across at 0.8 c, emitted at t = 2 + at x = 0: D = 1/γ = 0.6 where it is abeam.
    expect(doppler(second, 2 + 19 / c).doppler).toBeCloseTo(0.6, 6);
    expect(said(scene)).toEqual(['info usd.topology']);
  });

  it('with accelerations its points are x + v t + a t²/2 at the ends of four straight pieces', async () => {
    const accelerations = `vector3f[] accelerations.timeSamples = { 2: [(0, 0, -2), (0, 0, -2), (0, 0, -2), (0, 0, -2)] }`;
    const scene = await read(stage(`def Mesh "W" { ${CHANGING}\n${VELOCITIES}\n${accelerations} }`));
    for (const t of [2, 2.5, 3, 3.5, 4]) {
      const [x, , z] = vertexPosition(scene.objects[1], 0, t, 100);
      expect([x, z]).toEqual([4 * (t - 2), 1 - (t - 2) ** 2].map((value) => expect.closeTo(value, 5)));
    }
    // Before the sample, and after the next, it goes on with the velocities there.
    expect(vertexPosition(scene.objects[1], 0, 1.5, 100)[2]).toBeCloseTo(1, 5);
    expect(vertexPosition(scene.objects[1], 0, 4.5, 100)[2]).toBeCloseTo(1 - 4 - 4 * 0.5, 5);
  });

  it('that only seems to change stays one mesh with sampled points', async () => {
    const same = `uniform token subdivisionScheme = "none"
  int[] faceVertexCounts.timeSamples = { 0: [3], 2: [3], 4: [3] }\nint[] faceVertexIndices.timeSamples = { 0: [0, 1, 2], 2: [0, 1, 2] }
  point3f[] points.timeSamples = { 0: [(0, 0, 0), (1, 0, 0), (0, 1, 0)], 2: [(0, 0, 1), (1, 0, 1), (0, 1, 1)] }`;
    const scene = await read(stage(`def Mesh "W" { ${same} }`));
    expect(scene.objects).toMatchObject([{ path: '/W', motion: { kind: 'sampled-points' } }]);
    expect(scene.objects[0]).not.toHaveProperty('pieceOf');
    expect(said(scene)).toEqual([]);
  });

  it('of subsets over time has their materials in each piece', async () => {
    const text = `def Mesh "W" { ${TRIANGLE.replace('[3]', '[3, 3]').replace('[0, 1, 2]', '[0, 1, 2, 2, 1, 0]')}
  def GeomSubset "S" { int[] indices.timeSamples = { 0: [0], 3: [1] }\nrel material:binding = </Red> } }
def Material "Red" { token outputs:surface.connect = </Red/S.outputs:surface>
  def Shader "S" { uniform token info:id = "UsdPreviewSurface"; color3f inputs:diffuseColor = (1, 0, 0); token outputs:surface } }`;
    const scene = await read(stage(text));
    const red = scene.materials.findIndex(({ baseColor }) => baseColor.join() === '1,0,0');
    const redFace = ({ mesh }: (typeof scene.objects)[number]) => {
      const { start } = mesh.groups.find(({ material }) => material === red)!;
      return [...mesh.indices.subarray(start, start + 3)].map((v) => mesh.positions[3 * v]);
    };
    expect(scene.objects.map(redFace)).toEqual([
      [0, 1, 0],
      [0, 1, 0],
    ]);
    expect(scene.objects.map(({ lifetime }) => lifetime.death)).toEqual([3, Infinity]);
    expect(said(scene)).toEqual(['info usd.topology']);
  });

  it('normals and colours are those of each sample', async () => {
    const text = `def Mesh "W" { ${CHANGING}
  normal3f[] normals.timeSamples = { 0: [(1, 0, 0), (1, 0, 0), (1, 0, 0)], 2: [(0, 1, 0), (0, 1, 0), (0, 1, 0), (0, 1, 0)], 4: [] }
  color3f[] primvars:displayColor.timeSamples = { 0: [(1, 0, 0)], 2: [(0, 1, 0)] } }`;
    const { objects, materials } = await read(stage(text));
    expect(objects.map(({ mesh }) => [...mesh.normals.subarray(0, 3)])).toEqual([
      [1, 0, 0],
      [0, 1, 0],
    ]);
    expect(objects.map(({ mesh }) => materials[mesh.groups[0].material].baseColor)).toEqual([
      [1, 0, 0],
      [0, 1, 0],
    ]);
  });

  it('is cut by visibility', async () => {
    expect(
      await lives(
        `def Mesh "W" { ${CHANGING}\ntoken visibility.timeSamples = { 0: "inherited", 1: "invisible", 1.5: "inherited", 3: "invisible" } }`,
      ),
    ).toEqual([
      ['/W/piece1', -Infinity, 1],
      ['/W/piece1_2', 1.5, 2],
      ['/W/piece2', 2, 3],
    ]);
  });

  it('has bounds: more pieces than there is room for are thinned, which is said', async () => {
    const n = 5000;
    const samples = (value: (k: number) => string): string =>
      Array.from({ length: n }, (_, k) => `${k}: ${value(k)}`).join();
    const text = `def Mesh "W" { uniform token subdivisionScheme = "none"\nint[] faceVertexCounts = [3]
  int[] faceVertexIndices.timeSamples = { ${samples((k) => (k % 2 ? '[0, 1, 2]' : '[2, 1, 0]'))} }
  point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)] }`;
    const scene = await read(stage(text));
    expect(scene.objects).toHaveLength(4096);
    const deaths = scene.objects.slice(0, -1).map(({ lifetime }) => lifetime.death);
    expect(scene.objects.slice(1).map(({ lifetime }) => lifetime.birth)).toEqual(deaths);
    expect(said(scene)).toContain('warning usd.sample-budget');
  });
});

describe('written and read again', () => {
  it.each([
    ['text', (scene: Scene) => ({ 'b.usda': new TextEncoder().encode(writeUsda(scene)) })],
    ['binary', (scene: Scene) => ({ 'b.usdc': writeUsdc(scene) })],
  ] as const)('as %s, a stage has the same prims with the same lives and shapes', async (_, write) => {
    const options = { chordTolerance: 1e-6 };
    const before = await readUsd(memorySource({ 'lives.usda': fixture('lives.usda') }), 'lives.usda', options);
    const files = write(before) as Record<string, Uint8Array>;
    const after = await readUsd(memorySource(files), Object.keys(files)[0], options);
    const livesOf = ({ objects }: Scene) =>
      objects.map(({ path, pieceOf, lifetime }) => [path, pieceOf, lifetime]).sort();
    expect(livesOf(after)).toEqual(livesOf(before));
    for (let code = -3; code <= 36; code += 1.5) {
      const [a, b] = [after, before].map((scene) => visibleTriangles(scene, code / 24));
      expect(trianglesApart(a, b), `${code}`).toBeLessThan(1e-5);
    }
  });

  it('materials of pieces, lives of lights, and lives of prims with others inside stay', async () => {
    const text = `def Mesh "W" { ${CHANGING}
  def GeomSubset "S" { int[] indices.timeSamples = { 0: [], 2: [1] }\nrel material:binding = </Red> }
  token visibility.timeSamples = { 0: "inherited", 1: "invisible", 1.5: "inherited" } }
def SphereLight "L" { token visibility.timeSamples = { 0: "inherited", 2: "invisible", 3: "inherited" } }
def Cube "A" { double slowlight:birth = 1\ndef Cube "B" { double slowlight:birth = -inf } }
def Material "Red" { token outputs:surface.connect = </Red/S.outputs:surface>
  def Shader "S" { uniform token info:id = "UsdPreviewSurface"; color3f inputs:diffuseColor = (1, 0, 0); token outputs:surface } }`;
    const before = await read(stage(text));
    const after = await read(writeUsda(before));
    const brief = ({ objects, lights, materials }: Scene) => [
      ...objects.map(({ path, lifetime, mesh }) => [
        path,
        lifetime,
        mesh.groups.map(({ start, count, material }) => [start, count, materials[material].baseColor]),
      ]),
      ...lights.map((light) => [light.path, 'lifetime' in light && light.lifetime]),
    ];
    expect(brief(after)).toEqual(brief(before));
    expect(after.objects.filter(({ path }) => path === '/A/B')).toMatchObject([{ lifetime: { birth: -Infinity } }]);
  });
});
