import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import type { Scene } from '../../../../scene/types.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { said } from '../../fixtures/said.ts';
import { readUsd } from '../../read.ts';
import { agreement, type Places } from './fixtures/agreement.ts';

const fixture = (name: string): string =>
  readFileSync(fileURLToPath(new URL(`./fixtures/${name}`, import.meta.url)), 'utf8');

const readText = (text: string): Promise<Scene> =>
  readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda', { chordTolerance: 1e-5 });

describe('point instancers', () => {
  const scene = readText(fixture('instancers.usda'));
  const places: Places = JSON.parse(fixture('instancers.expected.json'));
  const any = (): boolean => true;
  const onStage = (code: number): boolean => code >= 0;

  it.each([
    ['Masked', 'ids, masks, scales, mirrors, and prototypes with prims below', 1e-5, any],
    ['Halves', 'orientations of half precision, which are made unit', 1e-3, any],
    ['Blended', 'values between samples, under a moving prim', 1e-4, any],
    ['Drifting', 'velocities from one sample, for ever', 1e-5, any],
    ['Thrown', 'accelerations and angular velocities, through the range of the stage', 5e-4, onStage],
    ['Carried', 'velocities that lead from sample to sample, through the range of the stage', 5e-4, onStage],
    ['Forest', 'instancers in prototypes of instancers', 1e-5, any],
    ['Particles', 'ids that come and go, at their samples', 1e-5, (code: number) => code % 12 === 0],
  ])('%s agree with usd-core: %s', async (name, _, tolerance, at) => {
    const found = agreement(await scene, places, new RegExp(`^/World/${name}\\[`), at);
    expect(found).toMatchObject({ missing: [], extra: [] });
    expect(found.off).toBeLessThan(tolerance);
  });
});

const TRIANGLE = `int[] faceVertexCounts = [3]
  int[] faceVertexIndices = [0, 1, 2]
  point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]`;
const stage = (body: string, header = ''): Promise<Scene> =>
  readText(`#usda 1.0\n( metersPerUnit = 1\n${header} )\ndef Mesh "Kite" { ${TRIANGLE} }\n${body}`);
const HIDDEN = 'over "P" { def Mesh "Kite" { uniform token subdivisionScheme = "none"\n';
const list = (count: number, item: string): string => `[${new Array(count).fill(item).join(', ')}]`;

describe('instances', () => {
  it('of equal scale share one mesh, whether of instancers or of scene instances', async () => {
    const { objects } = await stage(`
${HIDDEN} ${TRIANGLE} } }
def PointInstancer "I" {
  int[] protoIndices = [0, 0, 0]
  point3f[] positions = [(0, 0, 0), (1, 0, 0), (2, 0, 0)]
  float3[] scales = [(1, 1, 1), (2, 2, 2), (2, 2, 2)]
  quatf[] orientationsf = [(1, 0, 0, 0), (0.6, 0.8, 0, 0), (0, 0.6, 0, 0.8)]
  rel prototypes = </P/Kite>
}
def "Tree" { def Xform "Crown" { def Mesh "Leaf" { ${TRIANGLE}\n rel material:binding = </Tree/Look> } }
  def Material "Look" { token outputs:surface.connect = </Tree/Look/S.outputs:surface>
    def Shader "S" { uniform token info:id = "UsdPreviewSurface"\n color3f inputs:diffuseColor = (1, 0, 0)\n token outputs:surface } } }
def Xform "A" ( references = </Tree>\n instanceable = true ) { double3 xformOp:translate = (1, 0, 0)\n uniform token[] xformOpOrder = ["xformOp:translate"] }
def Xform "B" ( references = </Tree>\n instanceable = true ) { }
def Xform "C" ( references = </Tree> ) { over "Crown" { over "Leaf" { int[] faceVertexIndices = [0, 2, 1] } } }`);
    const mesh = (path: string) => objects.find((o) => o.path === path)?.mesh;
    expect(mesh('/I[1]/Kite')).toBe(mesh('/I[2]/Kite'));
    expect(mesh('/I[1]/Kite')).not.toBe(mesh('/I[0]/Kite'));
    expect(mesh('/A/Crown/Leaf')).toBe(mesh('/B/Crown/Leaf'));
    expect(mesh('/A/Crown/Leaf')).not.toBe(mesh('/C/Crown/Leaf'));
  });

  it('have their own colours if the prototype has none', async () => {
    const { objects, materials } = await stage(`
def PointInstancer "I" {
  int[] protoIndices = [0, 1, 0]
  point3f[] positions = ${list(3, '(0, 0, 0)')}
  color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0), (0, 0, 1)] ( interpolation = "vertex" )
  rel prototypes = [</I/Plain>, </I/Own>]
  def Cube "Plain" {}
  def Cube "Own" { color3f[] primvars:displayColor = [(0.25, 0.5, 0.75)] }
}`);
    const colors = objects.slice(1).map(({ mesh }) => materials[mesh.groups[0].material].baseColor);
    expect(colors).toEqual([
      [1, 0, 0],
      [0.25, 0.5, 0.75],
      [0, 0, 1],
    ]);
    expect(objects[1].mesh.positions).toBe(objects[3].mesh.positions);
  });

  it('move by slowlight:motion of their instancer, or by their velocities for all times', async () => {
    const { objects } = await stage(`
def PointInstancer "I" {
  token slowlight:motion = "uniform"
  vector3d slowlight:velocity = (0, 3, 0)
  int[] protoIndices = [0]
  point3f[] positions = [(7, 0, 0)]
  rel prototypes = </Kite>
}
def PointInstancer "J" {
  int[] protoIndices = [0]
  point3f[] positions.timeSamples = { 24: [(7, 0, 0)] }
  vector3f[] velocities.timeSamples = { 24: [(2, 0, 0)] }
  rel prototypes = </Kite>
}`);
    expect(objects.slice(1).map(({ motion }) => motion)).toMatchObject([
      { kind: 'uniform', velocity: [0, 3, 0], pose: { position: [7, 0, 0] } },
      { kind: 'uniform', velocity: [2, 0, 0], pose: { position: [5, 0, 0] } },
    ]);
  });
});

describe('faults of instancers', () => {
  it('are reported with place and value', async () => {
    const scene = await stage(`
def PointInstancer "Far" { int[] protoIndices = [0, 7, -1]\n point3f[] positions = ${list(3, '(0, 0, 0)')}\n rel prototypes = </Kite> }
def PointInstancer "Short" { int[] protoIndices = [0, 0]\n point3f[] positions = [(0, 0, 0)]\n rel prototypes = </Kite> }
def PointInstancer "Gone" { int[] protoIndices = [0]\n point3f[] positions = [(0, 0, 0)]\n rel prototypes = </Nothing> }
def PointInstancer "Same" { int[] protoIndices = [0, 0]\n int64[] ids = [4, 4]\n point3f[] positions = ${list(2, '(0, 0, 0)')}\n rel prototypes = </Kite> }`);
    expect(scene.objects.map(({ path }) => path)).toEqual(['/Kite', '/Far[0]/Kite', '/Same[0]/Kite', '/Same[1]/Kite']);
    expect(said(scene).filter((text) => text.startsWith('usd.instancer'))).toEqual([
      'usd.instancer a.usda</Far>: protoIndices[1] is 7, but there are 1 prototypes; 2 such instances are left out',
      'usd.instancer a.usda</Short>: positions has 1 values at t = 0, for 2 instances; they are left out',
      'usd.instancer a.usda</Gone>: its prototype <…> is not in the stage; its instances are left out'.replace(
        '…',
        '/Nothing',
      ),
      'usd.instancer a.usda</Same>: two of its ids are the same; its instances are known by their places instead',
    ]);
  });

  it('are told once for each array; empty scales and orientations are none, as in USD', async () => {
    const scene = await stage(`
def PointInstancer "Empty" { int[] protoIndices = [0]\n point3f[] positions = [(1, 0, 0)]\n float3[] scales = []\n quath[] orientations = []\n rel prototypes = </Kite> }
def PointInstancer "Fewer" { int[] protoIndices = [0]\n point3f[] positions = [(1, 0, 0)]\n float3[] scales.timeSamples = { 0: [(1, 1, 1), (1, 1, 1)], 5: [(2, 2, 2), (1, 1, 1)], 9: [(1, 1, 1)] }\n rel prototypes = </Kite> }`);
    expect(said(scene).filter((text) => text.startsWith('usd.instancer'))).toEqual([
      'usd.instancer a.usda</Fewer>: scales has 2 values at t = 0, for 1 instances; scales are left out',
    ]);
    const empty = scene.objects.find(({ path }) => path === '/Empty[0]/Kite')!;
    const kite = scene.objects.find(({ path }) => path === '/Kite')!;
    const size = ({ mesh }: typeof kite) => Math.max(...mesh.positions) - Math.min(...mesh.positions);
    expect(size(empty)).toBeCloseTo(size(kite), 6);
  });

  it('such as 10⁹ instances, or an instancer inside itself, are reported quickly', async () => {
    const nested = (name: string, prototype: string): string =>
      `def PointInstancer "${name}" { int[] protoIndices = ${list(1000, '0')}\n point3f[] positions = ${list(1000, '(0, 0, 0)')}\n rel prototypes = <${prototype}> }`;
    const scene = await stage(`
class "Q" { ${nested('C', '/Kite')}\n ${nested('B', '/Q/C')} }
${nested('A', '/Q/B')}
def PointInstancer "Loop" { int[] protoIndices = [0, 0]\n point3f[] positions = ${list(2, '(0, 0, 0)')}\n rel prototypes = [</Around>] }
over "Around" { def PointInstancer "Back" { int[] protoIndices = [0]\n point3f[] positions = [(0, 0, 0)]\n rel prototypes = </Loop> }\n def Cube "Body" {} }`);
    expect(said(scene)).toContain(
      'usd.too-many-instances a.usda</A>: its instances would be 1.00e+9 objects, and a scene has room for 249999 more; it is left out',
    );
    expect(scene.objects.map(({ path }) => path)).toEqual(['/Kite', '/Loop[0]/Around/Body', '/Loop[1]/Around/Body']);
    expect(said(scene).join()).toContain('</Loop>: it is in one of its own prototypes');
  });
});
