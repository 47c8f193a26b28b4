import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import { distance, normalize, type Vec3 } from '../../math/vec3.ts';
import { makeMaterial, makeObject, makeScene } from '../../scene/defaults.ts';
import { plane } from '../../scene/mesh/primitives.ts';
import type { Material, Mesh, SceneObject, Texture } from '../../scene/types.ts';
import { createTracedScene, nearestHit } from '../intersection/tracedScene.ts';
import { surfaceAt } from './surface.ts';

const one = (...texel: readonly [number, number, number, number]): Texture => ({
  name: 'one',
  width: 1,
  height: 1,
  data: Uint8Array.from(texel),
  colorSpace: 'linear',
  filter: 'nearest',
  wrapS: 'repeat',
  wrapT: 'repeat',
});

/** The surface hit at t = 0 near the origin by a ray straight down onto a square of 4 m; c = 1 m/s. */
function below(material: Partial<Material>, object: Partial<SceneObject> = {}, mesh: Mesh = plane(4, 4)) {
  const square = makeObject({ path: '/Square', mesh, ...object });
  const made = makeMaterial({ name: 'm', ...material });
  const traced = createTracedScene(makeScene({ name: 'square', objects: [square], materials: [made] }), 1);
  const hit = nearestHit(traced, { t: 1, x: [0.1, 0.2, 1], dt: -1, dx: [0, 0, -1] });
  if (!hit) throw new Error('nothing is met');
  return surfaceAt(traced, hit);
}
const near = (v: Vec3) => v.map((x) => expect.closeTo(x, 9));

/** A normal of about 0.6 along u and 0.8 outwards: 127.5 · 1.6, 127.5 · 1.8. */
const TILTED = { texture: one(204, 128, 230, 255), strength: [1, 0] } as const;
const [S, C] = normalize([204 / 127.5 - 1, 0, 230 / 127.5 - 1]).filter((x) => x !== 0);
/** 0.8 c along x: γ = 5/3. */
const FLYING = {
  motion: { kind: 'uniform', pose: { position: [0, 0, 0], orientation: IDENTITY }, velocity: [0.8, 0, 0] },
} as const;
const GAMMA = 5 / 3;

describe('a normal map', () => {
  it('tilts normals along increasing u, or against it with negative strength', () => {
    expect(below({ normalTexture: TILTED }).normal).toEqual(near([S, 0, C]));
    expect(below({ normalTexture: { ...TILTED, strength: [-1, 0] } }).normal).toEqual(near([-S, 0, C]));
  });

  it('tilts normals along increasing v, which is up in the texture', () => {
    const texture = one(128, 204, 230, 255);
    expect(below({ normalTexture: { texture, strength: [0, 1] } }).normal).toEqual(near([0, S, C]));
    const upsideDown = { ...plane(4, 4), uvs: plane(4, 4).uvs.map((x, i) => (i % 2 === 0 ? x : -x)) };
    expect(below({ normalTexture: { texture, strength: [0, 1] } }, {}, upsideDown).normal).toEqual(near([0, -S, C]));
  });

  it('tilts normals in the rest frame, where the surface is longer along the motion', () => {
    const square = plane(4, 4);
    const aslant = {
      ...square,
      uvs: square.uvs.map((x, i) => (i % 2 === 0 ? x + square.uvs[i + 1] : x - square.uvs[i - 1])),
    };
    // u increases along (1, 1) of the mesh as authored.
    const along = (stretch: number): Vec3 => {
      const [x, y] = normalize([stretch, 1, 0]);
      return [S * x, S * y, C];
    };
    expect(below({ normalTexture: TILTED }, FLYING, aslant).normal).toEqual(near(along(GAMMA)));
    expect(below({ normalTexture: TILTED }, { ...FLYING, authoredIn: 'rest' }, aslant).normal).toEqual(near(along(1)));
  });

  it('does not change the normal of a surface without uvs', () => {
    const bare = { ...plane(4, 4), uvs: new Float32Array(8) };
    expect(below({ normalTexture: TILTED }, {}, bare).normal).toEqual([0, 0, 1]);
  });
});

it('roughness and metalness come from the texel, clamped to 0 … 1', () => {
  const texture = one(51, 102, 204, 255);
  const point = below({
    roughnessTexture: { texture, channel: 1, scale: 0.5, bias: 0.25 },
    metallicTexture: { texture, channel: 2, scale: 2, bias: 0 },
  });
  expect(point).toMatchObject({ roughness: expect.closeTo(0.45, 12), metallic: 1 });
});

it('reflectance of invisible light is the material’s `uv` and `ir`, or continues the colour', () => {
  const { filter } = below({ baseColor: [0.5, 0.5, 0.5], ir: 0.875 });
  expect(filter).toMatchObject({ rgb: [0.5, 0.5, 0.5], uv: expect.closeTo(0.5, 6), ir: 0.875 });
});

it('grooves lie along u, turned towards v by their rotation and their texture, in the rest frame', () => {
  // About v, and no strength beyond a half.
  const directionTexture = one(128, 255, 128, 255);
  const along = (anisotropy: Material['anisotropy'], object: Partial<SceneObject> = {}): Vec3 =>
    below({ anisotropy: anisotropy! }, object).grooves!.along;
  const isNear = (a: Vec3, b: Vec3): void => {
    expect(distance(a, b)).toBeLessThan(0.01);
  };
  isNear(along({ strength: 1, rotation: 0 }), [1, 0, 0]);
  isNear(along({ strength: 1, rotation: Math.PI / 3 }), [0.5, Math.sqrt(0.75), 0]);
  isNear(along({ strength: 1, rotation: 0, directionTexture }), [0, 1, 0]);
  isNear(along({ strength: 1, rotation: Math.PI / 2, directionTexture }), [-1, 0, 0]);
  expect(below({ anisotropy: { strength: 0.5, rotation: 0, directionTexture } }).grooves!.strength).toBeCloseTo(
    0.25,
    2,
  );
  // The angle is that of the rest frame.
  isNear(along({ strength: 1, rotation: Math.PI / 4 }, FLYING), [Math.SQRT1_2, Math.SQRT1_2, 0]);
  // Without uvs there is no direction.
  const mesh = plane(4, 4);
  const bare = { ...mesh, uvs: new Float32Array(mesh.uvs.length) };
  expect(below({ anisotropy: { strength: 1, rotation: 0 } }, {}, bare).grooves).toBeUndefined();
});
