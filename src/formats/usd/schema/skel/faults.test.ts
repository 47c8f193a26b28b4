import { describe, expect, it } from 'vitest';
import { vertexPosition } from '../../../../scene/motion/motion.ts';
import type { Scene } from '../../../../scene/types.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { said } from '../../fixtures/said.ts';
import { readUsd } from '../../read.ts';

const read = (body: string): Promise<Scene> => {
  const text = `#usda 1.0\n(\nmetersPerUnit = 1\n)\n${body}\n`;
  return readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda');
};

const ONE = '((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))';
/** The elbow, at x = 1 from the shoulder, which is at the origin. */
const AT_1 = '((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (1, 0, 0, 1))';
const HALF = Math.SQRT1_2;

/** An arm from x = 0 to x = 2 whose elbow turns by a right angle about z within one second. */
interface Arm {
  readonly joints?: string;
  readonly bind?: string;
  readonly rest?: string;
  readonly animation?: string;
  readonly mesh?: string;
  readonly rig?: string;
  readonly inner?: string;
}
const INFLUENCES = `int[] primvars:skel:jointIndices = [0, 0, 1, 1, 1, 1] ( elementSize = 1; interpolation = "vertex" )
    float[] primvars:skel:jointWeights = [1, 1, 1, 1, 1, 1] ( elementSize = 1; interpolation = "vertex" )`;
const arm = ({
  joints = '["a", "a/b"]',
  bind = `[${ONE}, ${AT_1}]`,
  rest = `[${ONE}, ${AT_1}]`,
  animation = `uniform token[] joints = ["a/b"]
  float3[] translations = [(1, 0, 0)]
  quatf[] rotations.timeSamples = { 0: [(1, 0, 0, 0)], 24: [(${HALF}, 0, 0, ${HALF})] }
  half3[] scales = [(1, 1, 1)]`,
  mesh = INFLUENCES,
  rig = 'rel skel:skeleton = </Rig/S>; rel skel:animationSource = </Rig/A>',
  inner = '',
}: Arm = {}): string => `def SkelRoot "Rig" {
  ${rig}
  def Skeleton "S" { uniform token[] joints = ${joints}
    uniform matrix4d[] bindTransforms = ${bind}
    uniform matrix4d[] restTransforms = ${rest} }
  def SkelAnimation "A" { ${animation} }
  def Xform "Body" { def Mesh "M" {
    uniform token subdivisionScheme = "none"
    int[] faceVertexCounts = [3, 3]; int[] faceVertexIndices = [0, 1, 2, 3, 4, 5]
    point3f[] points = [(0, 0, 0), (0.5, 0, 0), (1, 0, 0), (1, 0, 0), (2, 0, 0), (1.5, 0.5, 0)]
    ${mesh}
    ${inner}
  } }
}`;

describe('an elbow that turns by 90° between two samples', () => {
  it('preserves the length of the forearm', async () => {
    const [object] = (await read(arm())).objects;
    for (const t of [0, 0.2, 0.37, 0.5, 0.81, 1]) {
      const [x, y] = vertexPosition(object, 4, t, 3e8);
      expect(Math.hypot(x - 1, y)).toBeCloseTo(1, 2);
      expect(Math.atan2(y, x - 1)).toBeCloseTo((t * Math.PI) / 2, 2);
      expect(vertexPosition(object, 1, t, 3e8)).toEqual([0.5, 0, 0]);
    }
  });

  it('bends the one arm, and not another with the same mesh and a skeleton at rest', async () => {
    const other = `def SkelRoot "Other" {
  rel skel:skeleton = </Other/S>
  def Skeleton "S" ( references = </Rig/S> ) {}
  def Xform "Body" ( references = </Rig/Body> ) {}
}`;
    const { objects } = await read(`${arm()}\n${other}`);
    const hand = (path: string) => vertexPosition(objects.find((object) => object.path === path)!, 4, 1, 3e8);
    expect(hand('/Rig/Body/M')).toEqual([expect.closeTo(1, 6), expect.closeTo(1, 6), 0]);
    expect(hand('/Other/Body/M')).toEqual([2, 0, 0]);
  });

  it('rotates rigidly bound meshes as a whole, as poses', async () => {
    const mesh = `int[] primvars:skel:jointIndices = [1] ( elementSize = 1 )
      float[] primvars:skel:jointWeights = [1] ( elementSize = 1 )`;
    const [object] = (await read(arm({ mesh }))).objects;
    expect(object.motion.kind).toBe('sampled');
    const [x, y] = vertexPosition(object, 0, 1, 3e8);
    expect([x, y]).toEqual([expect.closeTo(1, 6), expect.closeTo(-1, 6)]);
  });

  it('ignores the mesh’s own transform, since its skeleton moves it', async () => {
    const moved = arm().replace(
      'def Xform "Body" {',
      `def Xform "Body" { matrix4d xformOp:transform = ${AT_1}
      uniform token[] xformOpOrder = ["xformOp:transform"]\n`,
    );
    const [a, b] = [(await read(arm())).objects[0], (await read(moved)).objects[0]];
    expect(vertexPosition(b, 4, 0.5, 3e8)).toEqual(vertexPosition(a, 4, 0.5, 3e8));
  });

  it('is subdivided in the pose, not posed when subdivided', async () => {
    const smooth = arm().replace('"none"', '"catmullClark"');
    const { objects, diagnostics } = await read(smooth);
    expect(diagnostics).toEqual([]);
    expect(objects[0].motion.kind).toBe('sampled-points');
    expect(objects[0].mesh.indices.length).toBe(2 * 12 * 6 * 4 ** 2);
  });
});

describe('a skeleton in a prototype of instances', () => {
  it('is placed with each instance', async () => {
    const scene = await read(`def PointInstancer "Crowd" {
  rel prototypes = </Crowd/Rig>
  int[] protoIndices = [0, 0]
  point3f[] positions = [(10, 0, 0), (0, 20, 0)]
  ${arm().replaceAll('</Rig', '</Crowd/Rig')}
}`);
    expect(said(scene)).toEqual([]);
    const tips = scene.objects.map((object) => vertexPosition(object, 4, 1, 3e8).map((x) => Math.round(x * 1e3) / 1e3));
    expect(tips).toEqual([
      [11, 1, 0],
      [1, 21, 0],
    ]);
  });

  it('deforms equal meshes each by their own skeleton', async () => {
    const other = arm()
      .replaceAll('"Rig"', '"Other"')
      .replaceAll('</Rig', '</Other')
      .replace(`0, 0, ${HALF})]`, `0, 0, -${HALF})]`);
    const { objects } = await read(`${arm()}\n${other}`);
    const tips = objects.map((object) => Math.round(vertexPosition(object, 4, 1, 3e8)[1] * 1e3) / 1e3);
    expect(tips).toEqual([1, -1]);
  });
});

describe('without an animation', () => {
  it('a skeleton is at rest, with its mesh', async () => {
    const rest = `[${ONE}, ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (1, 3, 0, 1))]`;
    const [object] = (await read(arm({ rest, rig: 'rel skel:skeleton = </Rig/S>' }))).objects;
    expect(object.motion.kind).toBe('static');
    expect(vertexPosition(object, 4, 0, 3e8)).toEqual([2, 3, 0]);
  });
});

describe('blend shapes', () => {
  const shape = `uniform token[] skel:blendShapes = ["smile"]
    rel skel:blendShapeTargets = </Rig/Body/M/Smile>
    def BlendShape "Smile" { uniform vector3f[] offsets = [(0, 0, 2)]; uniform int[] pointIndices = [4] }`;
  const weights = `uniform token[] blendShapes = ["smile"]
    float[] blendShapeWeights.timeSamples = { 0: [0], 24: [1] }`;

  it('deform a mesh without joints, in place', async () => {
    const [object] = (await read(arm({ mesh: '', animation: weights, inner: shape }))).objects;
    expect(vertexPosition(object, 4, 0.5, 3e8)).toEqual([2, 0, 1]);
    expect(vertexPosition(object, 5, 0.5, 3e8)).toEqual([1.5, 0.5, 0]);
  });

  it('deform a mesh whose skeleton has no joints', async () => {
    const scene = await read(arm({ mesh: '', joints: '[]', bind: '[]', rest: '[]', animation: weights, inner: shape }));
    expect(said(scene)).toEqual([]);
    // As UsdSkel bakes it.
    expect(vertexPosition(scene.objects[0], 4, 0.5, 3e8)).toEqual([2, 0, 1]);
  });

  it.each([
    ['offsets = [(0, 0, 2)]', 'offsets = [(0, 0, 2), (0, 0, 1)]', 'offsets has 2 offsets where 1 are needed'],
    ['offsets = [(0, 0, 2)]', 'offsets = [(0, nan, 2)]', 'offsets holds what is no finite number'],
    ['pointIndices = [4]', 'pointIndices = [6]', 'pointIndices[0] is 6 of 6 points'],
    ['pointIndices = [4]', 'pointIndices = [-1]', 'pointIndices[0] is -1 of 6 points'],
    [
      'pointIndices = [4]',
      'pointIndices = [4]; uniform vector3f[] inbetweens:half = [(0, 0, 0)]',
      'inbetweens:half needs a weight other than 0 and 1',
    ],
  ])('%s as %s is reported', async (from, to, message) => {
    const scene = await read(arm({ animation: weights, inner: shape.replace(from, to) }));
    expect(said(scene)).toEqual([
      `usd.blend-shape a.usda</Rig/Body/M/Smile>: ${message}; it does not bend /Rig/Body/M`,
    ]);
    expect(vertexPosition(scene.objects[0], 4, 1, 3e8)).toEqual([2, 0, 0].map((x) => expect.closeTo(x, 5)));
  });
});

describe('invalid bindings are reported, and the mesh stays as authored', () => {
  const indices = (values: string, more = 'elementSize = 1; interpolation = "vertex"'): string =>
    INFLUENCES.replace(/\[0, 0, 1, 1, 1, 1\] \([^)]*\)/, `${values} ( ${more} )`);
  const skin = 'usd.skin a.usda</Rig/Body/M>: ';
  const skeleton = 'usd.skeleton a.usda</Rig/S>: ';
  const stays = '; the mesh stays as it is written';
  const stay = '; its meshes stay as they are written';
  const I = 'primvars:skel:jointIndices';
  const cases: [string, Arm, string][] = [
    ['a joint that is not there', { mesh: indices('[0, 0, 1, 2, 1, 1]') }, `${skin}${I}[3] is 2 of 2 joints${stays}`],
    ['a joint before the first', { mesh: indices('[0, 0, 1, -7, 1, 1]') }, `${skin}${I}[3] is -7 of 2 joints${stays}`],
    [
      'too few indices',
      { mesh: indices('[0, 0]') },
      `${skin}${I} has 2 values, and primvars:skel:jointWeights has 6${stays}`,
    ],
    [
      'a huge element',
      { mesh: indices('[0, 0, 1, 1, 1, 1]', 'elementSize = 2147483647; interpolation = "vertex"') },
      `${skin}${I} has elementSize 2147483647, not 1 to 4096${stays}`,
    ],
    [
      'no element',
      { mesh: indices('[0, 0, 1, 1, 1, 1]', 'elementSize = 0; interpolation = "vertex"') },
      `${skin}${I} has elementSize 0, not 1 to 4096${stays}`,
    ],
    [
      'an element of another size',
      { mesh: indices('[0, 0, 1, 1, 1, 1]', 'elementSize = 2; interpolation = "vertex"') },
      `${skin}${I} has 6 values; with elementSize 2 and interpolation vertex it needs 12${stays}`,
    ],
    [
      'a weight that is no number',
      { mesh: INFLUENCES.replace('[1, 1, 1, 1, 1, 1]', '[1, 1, nan, 1, 1, 1]') },
      `${skin}primvars:skel:jointWeights[2] is NaN${stays}`,
    ],
    [
      'joints of another skeleton',
      { mesh: `${INFLUENCES}\n uniform token[] skel:joints = ["a", "c"]` },
      `${skin}skel:joints names 'c', which is no joint of /Rig/S${stays}`,
    ],
    [
      'a place that is no skeleton',
      { rig: 'rel skel:skeleton = </Rig/Body>' },
      `${skin}skel:skeleton leads to /Rig/Body, where no Skeleton is${stays}`,
    ],
    ['no joints', { joints: '[]' }, `${skeleton}joints is empty${stay}`],
    ['a joint twice', { joints: '["a", "a"]' }, `${skeleton}joints names 'a' twice${stay}`],
    [
      'joints too deep',
      { joints: `["a", "${'b/'.repeat(600)}b"]` },
      `${skeleton}joints[1] is more than 512 joints deep${stay}`,
    ],
    ['too few bind transforms', { bind: `[${ONE}]` }, `${skeleton}bindTransforms has 1 matrices for 2 joints${stay}`],
    [
      'a flat bind transform',
      { bind: `[${ONE}, ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 0, 0), (0, 0, 0, 1))]` },
      `${skeleton}bindTransforms[1] has no inverse${stay}`,
    ],
    [
      'no rest',
      { rest: '[]' },
      `${skeleton}restTransforms has 0 usable matrices for 2 joints, and no animation moves all of them${stay}`,
    ],
  ];
  it.each(cases)('%s', async (_, faulty, message) => {
    const scene = await read(arm(faulty));
    expect(said(scene)).toEqual([message]);
    const [object] = scene.objects;
    expect(object.motion.kind).toBe('static');
    expect(vertexPosition(object, 4, 1, 3e8)).toEqual([2, 0, 0]);
  });

  it.each([
    ['translations = [(1, 0, 0)]', 'translations = []', 'translations has 0 values for 1 joints'],
    ['scales = [(1, 1, 1)]', 'scales = [(1, inf, 1)]', 'scales holds what is no finite number'],
    ['24: [(', '12: [], 24: [(', 'rotations at time 12 has 0 values for 1 joints'],
  ])('an animation with %s as %s: its joints stay at rest', async (from, to, message) => {
    const text = arm();
    expect(text).toContain(from);
    const scene = await read(text.replace(from, to));
    expect(said(scene)).toEqual([`usd.skeleton a.usda</Rig/A>: ${message}; its joints rest`]);
    expect(vertexPosition(scene.objects[0], 4, 1, 3e8)).toEqual([2, 0, 0]);
  });
});
