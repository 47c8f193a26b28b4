import { describe, expect, it } from 'vitest';
import { expectClose } from '../../../../../tests/support/physicsArbitraries.ts';
import { rotate } from '../../../../math/quat.ts';
import { distance, type Vec3 } from '../../../../math/vec3.ts';
import { inEnglish } from '../../../../messages/message.ts';
import { poseAt, vertexPosition } from '../../../../scene/motion/motion.ts';
import type { Scene, SceneObject } from '../../../../scene/types.ts';
import { memorySource } from '../../../files/fileSource.ts';
import type { ReadOptions } from '../../../readOptions.ts';
import { saveScene } from '../../../save.ts';
import { readUsd } from '../../read.ts';

/** c [m/s], far above every speed here. */
const C = 3e8;

const read = (body: string, options: ReadOptions = { interpolation: 'cubic' }): Promise<Scene> => {
  const text = `#usda 1.0\n(\nmetersPerUnit = 1\ntimeCodesPerSecond = 10\n)\n${body}\n`;
  return readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda', options);
};
const only = ({ objects: [object] }: Scene): SceneObject => object!;
const samples = (codes: readonly number[], value: (code: number) => string): string =>
  `{ ${codes.map((code) => `${code}: ${value(code)}`).join(', ')} }`;
const tuple = (...x: number[]): string => `(${x.join(', ')})`;

const CODES = [0, 4, 10, 13, 20];
const moving = (kind: string, type: string, value: (code: number) => string): string => `
def Cube "It" {
  ${type} xformOp:${kind}.timeSamples = ${samples(CODES, value)}
  uniform token[] xformOpOrder = ["xformOp:${kind}"]
}`;
const at = (scene: Scene, seconds: number) => poseAt(only(scene).motion, seconds, C);
const tolerance = 2e-4 * Math.sqrt(3);

describe('transforms between samples', () => {
  const parabola = (code: number) => 3 * (code / 10) ** 2 - code / 10;
  it('follow a parabola through the samples', async () => {
    const body = moving('translate', 'double3', (code) => tuple(parabola(code), 0, 1));
    const [cubic, linear] = [await read(body), await read(body, {})];
    for (const code of [0, 2, 7, 11.5, 16, 20]) {
      expectClose(at(cubic, code / 10).position, [parabola(code), 0, 1], tolerance);
      expect(at(linear, code / 10).position[0] - parabola(code)).toBeGreaterThanOrEqual(-1e-9);
    }
    expect(at(linear, 0.7).position[0] - parabola(7)).toBeGreaterThan(0.2);
  });
  it('rotate about one axis by angles on a parabola', async () => {
    const scene = await read(moving('rotateZ', 'float', (code) => String(100 * parabola(code))));
    const angle = (100 * parabola(7) * Math.PI) / 180;
    expectClose(rotate(at(scene, 0.7).orientation, [1, 0, 0]), [Math.cos(angle), Math.sin(angle), 0], 1e-3);
  });

  /** Half-angle about Z by the square of time. */
  const angle = (code: number) => 0.4 * (code / 10) ** 2;
  const turned = (code: number): Vec3 => [Math.cos(angle(code)), Math.sin(angle(code)), 0];
  it('interpolate quaternions along a curve of rotations', async () => {
    const body = moving('orient', 'quatd', (code) => tuple(Math.cos(angle(code) / 2), 0, 0, Math.sin(angle(code) / 2)));
    const [cubic, linear] = [await read(body), await read(body, {})];
    for (const code of [2, 7, 11.5, 16]) {
      expectClose(rotate(at(cubic, code / 10).orientation, [1, 0, 0]), turned(code), 1e-3);
    }
    expect(distance(rotate(at(linear, 0.7).orientation, [1, 0, 0]), turned(7))).toBeGreaterThan(0.02);
  });
  it('decompose matrices', async () => {
    const matrix = (code: number): string => {
      const [x, y] = turned(code).map((v) => 2 * v);
      return `(${tuple(x, y, 0, 0)}, ${tuple(-y, x, 0, 0)}, ${tuple(0, 0, 2, 0)}, ${tuple(parabola(code), 0, 0, 1)})`;
    };
    const scene = await read(moving('transform', 'matrix4d', matrix));
    expect(only(scene).motion.kind).toBe('sampled');
    expectClose(at(scene, 0.7).position, [parabola(7), 0, 0], 3 * tolerance);
    expectClose(rotate(at(scene, 0.7).orientation, [1, 0, 0]), turned(7), 1e-3);
  });
  it('preserve jumps', async () => {
    const value = (code: number) => tuple(code < 10 ? 0 : 5, 0, 0);
    const body = moving('translate', 'double3', value).replace('4: (0, 0, 0),', '4: (0, 0, 0), 9.99: (0, 0, 0),');
    const scene = await read(body);
    for (const t of [0.2, 0.7, 0.99]) expectClose(at(scene, t).position, [0, 0, 0], tolerance);
    for (const t of [1, 1.2, 1.7]) expectClose(at(scene, t).position, [5, 0, 0], tolerance);
  });
  it('fall back to USD’s own rule next to blocked samples', async () => {
    const body = moving('translate', 'double3', (code) => (code === 10 ? 'None' : tuple(code, 0, 0)));
    const scene = await read(body);
    expectClose(at(scene, 0.2).position, [2, 0, 0], tolerance);
    expect(scene.objects).toHaveLength(1);
  });
});

/** A triangle whose corners move with t², and slightly with t. */
const cloth = (more = '', codes = CODES): string => `
def Mesh "It" {
  int[] faceVertexCounts = [3]
  int[] faceVertexIndices = [0, 1, 2]
  uniform token subdivisionScheme = "none"
  point3f[] points.timeSamples = ${samples(codes, (code) => `[(0, 0, ${(code / 10) ** 2}), (1, 0, 0), (0, 1, ${code / 10})]`)}
  ${more}
}`;
const corner = (scene: Scene, seconds: number): Vec3 => vertexPosition(only(scene), 0, seconds, C);

describe('points between samples', () => {
  it('follow a parabola through the samples, to f32', async () => {
    const scene = await read(cloth());
    for (const t of [0, 0.2, 0.7, 1.15, 1.6, 2]) expectClose(corner(scene, t), [0, 0, t * t], 1e-6);
    expectClose(corner(await read(cloth(), {}), 0.2), [0, 0, 0.08], 1e-6);
  });
  it('use the velocities of the file, in units per second', async () => {
    const velocities = (given: readonly number[]) =>
      `vector3f[] velocities.timeSamples = ${samples(given, () => '[(0, 0, 3), (0, 0, 0), (0, 0, 1)]')}`;
    const scene = await read(cloth(velocities([0, 10]), [0, 10]));
    // From 0 to 1 in a second, with the slope 3 at both ends.
    const hermite = (w: number) => w * w * (3 - 2 * w) + 3 * (w * (1 - w) ** 2 - w * w * (1 - w));
    for (const t of [0.25, 0.5, 0.9]) expectClose(corner(scene, t), [0, 0, hermite(t)], 1e-6);
    const other = await read(cloth(velocities([0, 10, 11])));
    expect(other.diagnostics.map(({ code }) => code)).toContain('usd.velocities');
    expectClose(corner(other, 0.7), [0, 0, 0.49], 1e-6);
  });
  it('of a moving mesh are transformed with it', async () => {
    const move = `double3 xformOp:translate.timeSamples = ${samples(CODES, (code) => tuple((code / 10) ** 2, 0, 0))}
  uniform token[] xformOpOrder = ["xformOp:translate"]`;
    const scene = await read(cloth(move));
    for (const t of [0.2, 0.7, 1.6]) expectClose(corner(scene, t), [t * t, 0, t * t], 2e-4);
  });
  it('are reported as undersampled, by prim and metres', async () => {
    for (const interpolation of ['linear', 'cubic'] as const) {
      const { diagnostics } = await read(cloth(), { interpolation });
      const [note] = diagnostics.filter(({ code }) => code === 'usd.between-samples');
      expect(note).toMatchObject({ severity: 'info', place: 'a.usda</It>' });
      // x = t² between samples 0.7 s apart: 0.7²/4.
      expect(inEnglish(note.message)).toContain('up to 0.12 m elsewhere');
    }
    const straight = cloth().replaceAll(/\(0, 0, [\d.]+\)/g, '(0, 0, 0)');
    expect((await read(straight)).diagnostics.map(({ code }) => code)).not.toContain('usd.between-samples');
  });
  it('survive being written and read again', async () => {
    const scene = await read(cloth());
    const { files, diagnostics } = await saveScene(scene, 'b.usda');
    expect(diagnostics.map(({ code }) => code)).toEqual(['convert.interpolation']);
    const again = await readUsd(memorySource(Object.fromEntries(files)), 'b.usda', { interpolation: 'cubic' });
    for (const t of [0.2, 0.7, 1.6]) expectClose(corner(again, t), corner(scene, t), 1e-6);
    const lost = (await saveScene(scene, 'b.glb')).diagnostics.map(({ code }) => code);
    expect(lost).toContain('convert.interpolation');
  });
});
