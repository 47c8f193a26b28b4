import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { inEnglish } from '../../messages/message.ts';
import { InputError, type Scene } from '../../scene/types.ts';
import { memorySource } from '../files/fileSource.ts';
import { said } from './fixtures/said.ts';
import { readUsd } from './read.ts';

const readText = (body: string, header = 'metersPerUnit = 0.5'): Promise<Scene> => {
  const text = `#usda 1.0\n(\n${header}\n)\n${body}\n`;
  return readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda');
};

describe('slowlight attributes', () => {
  it('give an object and its descendants a closed-form motion, in stage units', async () => {
    const { objects } = await readText(`
def Xform "Train" {
  custom token slowlight:motion = "uniform"
  custom vector3d slowlight:velocity = (2, 0, -4)
  double3 xformOp:translate = (10, 0, 0)
  uniform token[] xformOpOrder = ["xformOp:translate"]
  def Cube "Car" {
    custom double slowlight:birth = -2
    custom double slowlight:death = 8
  }
  def Cube "Rocket" {
    custom token slowlight:authoredIn = "rest"
    custom token slowlight:motion = "hyperbolic"
    custom vector3d slowlight:properAcceleration = (0, 20, 0)
    custom double slowlight:t0 = 3
  }
}`);
    const pose = { position: [5, 0, 0], orientation: [0, 0, 0, 1] };
    expect(objects).toMatchObject([
      {
        path: '/Train/Car',
        motion: { kind: 'uniform', pose, velocity: [1, 0, -2] },
        lifetime: { birth: -2, death: 8 },
        authoredIn: 'world',
      },
      {
        path: '/Train/Rocket',
        motion: { kind: 'hyperbolic', pose, properAcceleration: [0, 10, 0], t0: 3 },
        authoredIn: 'rest',
      },
    ]);
  });

  it('without a velocity, with unknown tokens, or in conflict with time samples, are reported', async () => {
    const scene = await readText(`
def Cube "A" { token slowlight:motion = "uniform" }
def Cube "B" { token slowlight:motion = "sideways"; token slowlight:authoredIn = "moon" }
def Cube "C" {
  token slowlight:motion = "uniform"; vector3d slowlight:velocity = (1, 0, 0)
  double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 24: (2, 0, 0) }
  uniform token[] xformOpOrder = ["xformOp:translate"]
}`);
    expect(said(scene)).toEqual([
      'usd.slowlight a.usda</A>: slowlight:motion is "uniform" without slowlight:velocity, a vector3d; it rests',
      'usd.slowlight a.usda</B>: slowlight:motion "sideways" is not uniform or hyperbolic; it is left out',
      'usd.slowlight a.usda</B>: slowlight:authoredIn "moon" is not world or rest; world is taken',
      'usd.slowlight a.usda</C>: slowlight:motion and time samples both move it; it keeps its pose of t = 0 s and moves as slowlight:motion says',
    ]);
    expect(scene.objects[2].motion).toMatchObject({
      kind: 'uniform',
      pose: { position: [0, 0, 0] },
      velocity: [0.5, 0, 0],
    });
  });

  it('of the layer are hints', async () => {
    const { hints } = await readText(
      '',
      'customLayerData = { dictionary slowlight = { double speedOfLight = 10; string title = "T"; string lookFor = "L"; double3 beta = (0, 0, 0.5); double openAt = 2 } }',
    );
    expect(hints).toEqual({ speedOfLight: 10, title: 'T', lookFor: 'L', beta: [0, 0, 0.5], openAt: 2 });
  });
});

describe('unsupported content is reported, never silently dropped', () => {
  it('arcs without a target, by prim', async () => {
    const scene = await readText(
      `
def Xform "Car" (
  prepend references = [@car.usd@</Body>, </Nowhere>]
  payload = @heavy.usd@
  inherits = </Car/Part>
  prepend variantSets = "color"
) {
  variantSet "color" = { "red" {} "blue" {} }
}
over "Lost" {}
class "_class" {}
`,
      'metersPerUnit = 1\nsubLayers = [@base.usda@]',
    );
    expect(said(scene)).toEqual([
      'usd.missing-layer a.usda: the sublayer @base.usda@ is not there (looked for base.usda); open the folder that holds it',
      'usd.missing-layer a.usda</Car>: its reference @car.usd@ is not there (looked for car.usd); open the folder that holds it',
      'usd.missing-layer a.usda</Car>: its payload @heavy.usd@ is not there (looked for heavy.usd); open the folder that holds it',
      'usd.cycle a.usda</Car>: the inherit of /Car in a.usda to /Car/Part leads back to where it comes from; it is left out',
      'usd.unresolved-prim a.usda</Car>: its reference </Nowhere> leads to /Nowhere, which a.usda does not have',
      "usd.undefined-prim a.usda</Lost>: an 'over' changes this prim, and nothing defines it; it is left out",
      'usd.empty-stage a.usda: there is nothing to see: 3 references to layers that are not there, and nothing else; open the folder that holds them',
    ]);
    const missing = scene.diagnostics.flatMap((d) => d.missing ?? []);
    expect(missing).toEqual(['base.usda', 'car.usd', 'heavy.usd'].map((name) => ({ name, lookedFor: [name] })));
    expect(scene.variants).toEqual([{ set: '/Car{color}', options: ['blue', 'red'], chosen: '' }]);
  });

  it('many arcs to missing layers, by their count in one line', async () => {
    const arcs = Array.from({ length: 40 }, (_, k) => `def "P${k}" ( references = @part${k % 10}.usda@ ) {}`);
    const scene = await readText(`${arcs.join('\n')}\ndef Cube "C" {}`);
    const warnings = scene.diagnostics.filter(({ severity }) => severity === 'warning');
    expect(warnings).toHaveLength(4);
    expect(inEnglish(warnings[3].message)).toMatch(
      /^40 references, payloads and sublayers lead to 10 layers that are not there \(part0\.usda.*part7\.usda.*…\)/,
    );
    // Every file is still known to those who can supply it.
    expect(new Set(scene.diagnostics.flatMap(({ missing }) => missing?.name ?? [])).size).toBe(10);
  });

  it('a stage of which nothing is left, as an error', async () => {
    const scene = await readText('def "P" ( references = @part.usda@ ) {}');
    const errors = scene.diagnostics.filter(({ severity }) => severity === 'error');
    expect(errors.map(({ code }) => code)).toEqual(['usd.empty-stage']);
    expect((await readText('def Xform "P" {}')).diagnostics).toEqual([]);
  });

  it('prims of unsupported types', async () => {
    const scene = await readText(`
def SkelRoot "Man" { def Cube "Bone" {} }
def BasisCurves "Hair" {}
def PortalLight "Window" {}
`);
    expect(scene.diagnostics.map((d) => d.place)).toEqual(['Hair', 'Window'].map((n) => `a.usda</${n}>`));
    expect(scene.objects.map((o) => o.path)).toEqual(['/Man/Bone']);
  });

  it('faults of meshes, materials and textures', async () => {
    const scene = await readText(`
def Mesh "NoPoints" { int[] faceVertexCounts = [3]; int[] faceVertexIndices = [0, 1, 2] }
def Mesh "BadFaces" {
  int[] faceVertexCounts = [3, 2, 3, 3]
  int[] faceVertexIndices = [0, 1, 2, 0, 1, 0, 1, 9, 0]
  point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
  texCoord2f[] primvars:st = [(0, 0)] ( interpolation = "vertex" )
  rel material:binding = </M>
}
def Mesh "Changing" {
  rel material:binding = </Missing>
  int[] faceVertexCounts = [3]
  int[] faceVertexIndices = [0, 1, 2]
  point3f[] points.timeSamples = { 0: [(0, 0, 0), (1, 0, 0), (0, 1, 0)], 1: [(0, 0, 0)] }
}
def Material "M" {
  token outputs:surface.connect = </M/S.outputs:surface>
  def Shader "S" {
    uniform token info:id = "UsdPreviewSurface"
    color3f inputs:diffuseColor.connect = </M/T.outputs:rgb>
    normal3f inputs:normal.connect = </M/T.outputs:rgb>
    token outputs:surface
  }
  def Shader "T" { uniform token info:id = "UsdUVTexture"; asset inputs:file = @tex/none.png@; float3 outputs:rgb }
}`);
    expect(said(scene)).toEqual([
      'usd.empty-mesh a.usda</NoPoints>: the mesh has no points; it is left out',
      'file.missing-texture a.usda</M/T>: the texture tex/none.png is not there (looked for tex/none.png); shown without it',
      'usd.faces a.usda</BadFaces>: 3 of 4 faces have fewer than 3 corners or name points that are not there; they are left out',
      'usd.primvar a.usda</BadFaces>: primvars:st has 1 values where 3 are needed; it is left out',
      'usd.topology a.usda</Changing>: its topology changes: 2 meshes take turns, each alive until the next; 2 of them have no velocities, so they rest while they live and show no Doppler effect of their own (write velocities)',
      'usd.material a.usda</Changing>: its material /Missing is not in this file; its displayColor is drawn',
      'usd.faces a.usda</Changing>: 1 of 1 faces have fewer than 3 corners or name points that are not there; they are left out',
      'usd.empty-mesh a.usda</Changing>: the mesh has no faces; it is left out',
    ]);
    // One triangle, subdivided twice.
    expect(scene.objects[0].mesh.indices.length).toBe(12 * 6 * 4 ** 2);
  });
});

describe('the stage', () => {
  it('has USD’s fallbacks: centimetres, Y up, 24 codes a second', async () => {
    const scene = await readText('def Cube "A" {}', '');
    expect(scene).toMatchObject({ metersPerUnit: 0.01, upAxis: 'Y', timeCodesPerSecond: 24, startTime: 0, endTime: 0 });
    expect(Math.max(...scene.objects[0].mesh.positions)).toBeCloseTo(0.01, 9);
  });

  it('takes its time range from the samples if none is authored', async () => {
    const scene = await readText(`def Cube "A" {
      double3 xformOp:translate.timeSamples = { 12: (0, 0, 0), 48: (2, 0, 0) }
      uniform token[] xformOpOrder = ["xformOp:translate"]
    }`);
    expect([scene.startTime, scene.endTime]).toEqual([0.5, 2]);
  });

  it('has its times under their former names, too; the present ones are stronger', async () => {
    const former = await readText('', 'startFrame = 12\n endFrame = 48\n timeCodesPerSecond = 24');
    expect([former.startTime, former.endTime]).toEqual([0.5, 2]);
    const both = await readText('', 'startFrame = 12\n endFrame = 48\n startTimeCode = 24\n timeCodesPerSecond = 24');
    expect([both.startTime, both.endTime]).toEqual([1, 2]);
  });

  it('rejects invalid units', async () => {
    await expect(readText('', 'metersPerUnit = 0')).rejects.toThrow('metersPerUnit = 0 is not a positive number');
    await expect(readText('', 'timeCodesPerSecond = -1')).rejects.toThrow(InputError);
    await expect(readUsd(memorySource({}), 'b.usda')).rejects.toThrow('b.usda: no such file');
  });
});

const data = fileURLToPath(new URL('../../../../shared/data/usd', import.meta.url));
const present = existsSync(data);
if (!present) console.warn(`${data} is not there: tests on real files are skipped`);

/** Files beside and above a file on disk. */
const onDisk = (path: string) => ({
  read: async (relative: string) => {
    const file = join(dirname(path), relative);
    return existsSync(file) ? new Uint8Array(readFileSync(file)) : undefined;
  },
});

describe.skipIf(!present)('real files', () => {
  const files = present
    ? readdirSync(data, { recursive: true, encoding: 'utf8' }).filter((f) => /\.usd[az]?$/.test(f))
    : [];

  it.each(files)('%s is read', async (file) => {
    const path = join(data, file);
    const { diagnostics } = await readUsd(onDisk(path), path.slice(path.lastIndexOf('/') + 1));
    expect(diagnostics.filter((d) => d.severity === 'error')).toEqual([]);
  });

  it('AnimatedCube, a package of a crate, has its cube, motion and texture', async () => {
    const file = 'AnimatedCube.usdz';
    const { objects, materials } = await readUsd(onDisk(join(data, 'test_assets/USDZ/AnimatedCube', file)), file);
    expect(objects.map((o) => [o.path, o.motion.kind, o.mesh.indices.length])).toEqual([
      ['/AnimatedCube/Geom/AnimatedCube', 'sampled', 36],
    ]);
    expect(materials[0].baseColorTexture?.width).toBe(512);
  });

  it('McUsd has its meshes, materials, textures, lights and camera', async () => {
    const scene = await readUsd(onDisk(join(data, 'full_assets/McUsd/McUsd.usda')), 'McUsd.usda');
    expect(scene.objects.length).toBe(23);
    expect(scene.objects.reduce((n, o) => n + o.mesh.indices.length / 3, 0)).toBe(880);
    expect(scene.materials.every((m) => m.baseColorTexture)).toBe(true);
    expect(scene.lights.map((l) => l.kind)).toEqual(['distant', 'dome']);
    expect(scene.cameras.length).toBe(1);
    expect(scene.diagnostics.filter((d) => d.severity !== 'info')).toEqual([]);
  });
});

describe('motion that is too fast between samples', () => {
  const turning = (kind: string, name: string, degrees: number): string => `
def ${kind} "${name}" {
  float xformOp:rotateY.timeSamples = { 0: 0, 24: ${degrees} }
  uniform token[] xformOpOrder = ["xformOp:rotateY"]
}`;
  const samplesOf = ({ objects, cameras }: Scene): number[] =>
    [...objects, ...cameras].map(({ motion }) => ('times' in motion ? motion.times.length : 0));

  it('is limited to the maximum number of samples of a scene, for any number of objects', async () => {
    const wild = Array.from({ length: 40 }, (_, i) => turning(i % 2 ? 'Camera' : 'Cube', `A${i}`, 1e7 + i)).join('');
    const scene = await readText(wild);
    const counts = samplesOf(scene);
    // Ten evaluations per sample, out of the 2¹⁸ allowed.
    expect(counts.reduce((sum, n) => sum + n)).toBeLessThan(2 ** 18 / 10);
    expect(counts.every((n) => n >= 2)).toBe(true);
    expect(scene.diagnostics.filter((d) => d.code === 'usd.resampling')).toHaveLength(40);
    expect(said(scene)[0]).toMatch(
      /^usd\.resampling a\.usda<\/A0>: .* its 2 samples .*about [\d.e+]+ samples would be needed, \d+ are used, and paths are off by up to [\d.]+ m; write more samples/,
    );
  });

  it('leaves enough samples for ordinary motion', async () => {
    const scene = await readText(turning('Cube', 'Wild', 1e8) + turning('Cube', 'Wheel', 360));
    // A chord over the angle a leaves a circle of radius r by r(1 − cos a/2); the number of pieces is a power of two.
    const pieces = 2 ** Math.ceil(Math.log2(Math.PI / Math.acos(1 - 1e-4)));
    expect(samplesOf(scene)[1]).toBe(pieces + 1);
    expect(scene.diagnostics.filter((d) => d.code === 'usd.resampling').map((d) => d.place)).toEqual(['a.usda</Wild>']);
  });
});
