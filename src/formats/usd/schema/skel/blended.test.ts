import { describe, expect, it } from 'vitest';
import { fastestVertex, vertexPosition } from '../../../../scene/motion/motion.ts';
import type { BlendedPoints } from '../../../../scene/streaming/blendedPoints.ts';
import { isBlended } from '../../../../scene/streaming/samplePoints.ts';
import type { Scene, SceneObject } from '../../../../scene/types.ts';
import { memorySource } from '../../../files/fileSource.ts';
import type { ReadOptions } from '../../../readOptions.ts';
import { said } from '../../fixtures/said.ts';
import { readUsd } from '../../read.ts';

const read = (body: string, options: ReadOptions = {}): Promise<Scene> => {
  const text = `#usda 1.0\n(\nmetersPerUnit = 1\n)\n${body}\n`;
  return readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda', options);
};

const matrix = (x: number): string => `((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (${x}, 0, 0, 1))`;
const HALF = Math.SQRT1_2;

/** A mesh with the corners (0, 0, 0), (1, 0, 0) and (2, 0, 0); the last two follow the elbow. */
const mesh = (name: string, more = '', weights = '1, 1, 1'): string => `def Mesh "${name}" {
    uniform token subdivisionScheme = "none"
    int[] faceVertexCounts = [3]; int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (2, 0, 0)]
    int[] primvars:skel:jointIndices = [0, 1, 1] ( elementSize = 1; interpolation = "vertex" )
    float[] primvars:skel:jointWeights = [${weights}] ( elementSize = 1; interpolation = "vertex" )
    ${more}
  }`;

/** An elbow at x = 1 that turns by a right angle about z within one second. */
const rig = (meshes: string, more = '', animation = ''): string => `def SkelRoot "Rig" {
  rel skel:skeleton = </Rig/S>; rel skel:animationSource = </Rig/A>
  ${more}
  def Skeleton "S" { uniform token[] joints = ["a", "a/b"]
    uniform matrix4d[] bindTransforms = [${matrix(0)}, ${matrix(1)}]
    uniform matrix4d[] restTransforms = [${matrix(0)}, ${matrix(1)}] }
  def SkelAnimation "A" { uniform token[] joints = ["a/b"]
    float3[] translations = [(1, 0, 0)]
    quatf[] rotations.timeSamples = { 0: [(1, 0, 0, 0)], 24: [(${HALF}, 0, 0, ${HALF})] }
    half3[] scales = [(1, 1, 1)]
    ${animation} }
  ${meshes}
}`;

/** Of an object, of which these are. */
function pointsOf({ motion, path }: SceneObject): BlendedPoints {
  if (motion.kind !== 'sampled-points' || !isBlended(motion.points)) throw new Error(`${path} is baked`);
  return motion.points;
}
const blends = ({ motion }: SceneObject): boolean => motion.kind === 'sampled-points' && isBlended(motion.points);
const times = ({ motion }: SceneObject): Float64Array => (motion.kind === 'sampled-points' ? motion.times : NONE);
const NONE = new Float64Array(0);

const place = (object: SceneObject, vertex: number, t: number): number[] => [...vertexPosition(object, vertex, t, 3e8)];
const near = (x: readonly number[], digits: number): unknown[] => x.map((v) => expect.closeTo(v, digits));

describe('a skeleton', () => {
  it('has one time grid, whose nodes are enough for each of its meshes', async () => {
    const { objects, diagnostics } = await read(rig(mesh('Near') + mesh('Far', LONG)));
    expect(diagnostics).toEqual([]);
    const [a, b] = objects.map(pointsOf);
    expect(b.poses).toBe(a.poses);
    expect(times(objects[0])).toEqual(times(objects[1]));
    for (const t of [0, 0.21, 0.5, 0.77, 1]) {
      const angle = (t * Math.PI) / 2;
      // 10⁻³ of the half diagonal of both.
      const wanted = [1 + 9 * Math.cos(angle), 9 * Math.sin(angle), 0];
      expect(Math.hypot(...place(objects[1], 2, t).map((x, k) => x - wanted[k]))).toBeLessThan(6e-3);
    }
  });
  const LONG = 'matrix4d primvars:skel:geomBindTransform = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (8, 0, 0, 1))';

  it('is carried by what moves it, far from the origin too', async () => {
    const moves = `double3 xformOp:translate.timeSamples = { 0: (1e7, 0, 0), 24: (1e7, 30, 0) }
      float xformOp:rotateY.timeSamples = { 0: 0, 12: 90, 24: 0 }
      uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateY"]`;
    const scene = await read(rig(mesh('M'), moves), { chordTolerance: 1e-4 });
    expect(said(scene)).toEqual([]);
    const [object] = scene.objects;
    for (const t of [0, 0.3, 0.5, 0.8, 1]) {
      const [turn, angle] = [Math.PI * (t < 0.5 ? t : 1 - t), (t * Math.PI) / 2];
      const x = 1 + Math.cos(angle);
      const wanted = [1e7 + x * Math.cos(turn), 30 * t + Math.sin(angle), -x * Math.sin(turn)];
      expect(Math.hypot(...place(object, 2, t).map((at, k) => at - wanted[k]))).toBeLessThan(5e-4);
    }
  });

  it('has what is missing from weights at its origin, moving or at rest', async () => {
    for (const moves of [
      'double3 xformOp:translate.timeSamples = { 0: (5, 0, 0), 24: (5, 8, 0) }',
      'double3 xformOp:translate = (5, 8, 0)',
    ]) {
      const order = 'uniform token[] xformOpOrder = ["xformOp:translate"]';
      const { objects } = await read(rig(mesh('M', '', '1, 1, 0.5'), `${moves}\n${order}`));
      // Half of (1, 1, 0), after the turn.
      expect(place(objects[0], 2, 1)).toEqual(near([5.5, 8.5, 0], 5));
    }
  });

  it('shares its joints among instances, whatever their places and sizes', async () => {
    const scene = await read(`def PointInstancer "Crowd" {
  rel prototypes = </Crowd/Rig>
  int[] protoIndices = [0, 0, 0]
  point3f[] positions = [(10, 0, 0), (0, 20, 0), (0, 0, 30)]
  quath[] orientations = [(1, 0, 0, 0), (0, 0, 0, 1), (1, 0, 0, 0)]
  float3[] scales = [(1, 1, 1), (1, 1, 1), (2, 2, 2)]
  ${rig(mesh('M')).replaceAll('</Rig', '</Crowd/Rig')}
}`);
    expect(said(scene)).toEqual([]);
    const [a, b, c] = scene.objects.map(pointsOf);
    expect(b.poses).toBe(a.poses);
    expect(b.influences).toBe(a.influences);
    expect(c.poses).toBe(a.poses);
    const alone = await read(rig(mesh('M')));
    expect(scene.pathError).toBeCloseTo(2 * alone.pathError!, 9);
    const tips = scene.objects.map((object) => place(object, 2, 1));
    expect(tips).toEqual([near([11, 1, 0], 5), near([-1, 19, 0], 5), near([2, 2, 30], 5)]);
  });

  it('has a grid for its blend shapes too, with nodes where weights pass inbetweens', async () => {
    const shapes = `uniform token[] skel:blendShapes = ["up"]
    rel skel:blendShapeTargets = </Rig/M/Up>
    def BlendShape "Up" { uniform vector3f[] offsets = [(0, 0, 1)]; uniform int[] pointIndices = [0]
      uniform vector3f[] inbetweens:early = [(0, 0, 3)] ( weight = 0.3 ) }`;
    const weights = `uniform token[] blendShapes = ["up"]
    float[] blendShapeWeights.timeSamples = { 0: [0], 20: [1] }`;
    const { objects } = await read(rig(mesh('M', shapes), '', weights));
    const object = objects[0];
    expect([...times(object)].some((t) => Math.abs(t - 6 / 24) < 1e-6)).toBe(true);
    const height = (w: number): number => (w < 0.3 ? (3 * w) / 0.3 : 3 - (2 * (w - 0.3)) / 0.7);
    for (const code of [0, 2, 6, 7, 13, 20])
      expect(place(object, 0, code / 24)).toEqual(near([0, 0, height(code / 20)], 5));
    // Up to 3 m within 6 of 24 codes.
    expect(fastestVertex(object, 3e8).speed).toBeCloseTo(12, 4);
  });
});

it.each<[string, string, ReadOptions]>([
  ['dual quaternions', mesh('M', 'uniform token primvars:skel:skinningMethod = "dualQuaternion"'), {}],
  [
    'points that have samples',
    mesh('M')
      .replace('points =', 'points.timeSamples = { 0: ')
      .replace('(2, 0, 0)]', '(2, 0, 0)], 24: [(0, 0, 0), (1, 0, 0), (3, 0, 0)] }'),
    {},
  ],
  ['a cage that is subdivided', mesh('M').replace('"none"', '"catmullClark"'), {}],
  ['cubic interpolation', mesh('M'), { interpolation: 'cubic' }],
])('%s are baked as before', async (_, body, options) => {
  const [baked] = (await read(rig(body), options)).objects;
  const [plain] = (await read(rig(mesh('M')))).objects;
  expect([blends(baked), blends(plain)]).toEqual([false, true]);
});

it('a mesh that its frame stretches along the way keeps the frame', async () => {
  const scene = await read(`def Mesh "M" {
    uniform token subdivisionScheme = "none"
    int[] faceVertexCounts = [3]; int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0)]
    float3 xformOp:scale.timeSamples = { 0: (1, 1, 1), 24: (3, 1, -1) }
    uniform token[] xformOpOrder = ["xformOp:scale"]
  }`);
  expect(said(scene)).toEqual([]);
  const [object] = scene.objects;
  expect(pointsOf(object).poses.matrices.length).toBe(times(object).length * 2 * 12);
  expect(place(object, 2, 0.5)).toEqual(near([2, 1, 0], 6));
});
