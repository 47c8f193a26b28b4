import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import { normalize, type Vec3 } from '../../math/vec3.ts';
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

/** What a ray straight down onto a square of 4 m finds at the origin, at t = 0; light is so slow that the square's speed counts. */
function below(material: Partial<Material>, object: Partial<SceneObject> = {}, mesh: Mesh = plane(4, 4)) {
  const thing = makeObject({ path: '/Square', mesh, ...object });
  const made = makeMaterial({ name: 'm', ...material });
  const traced = createTracedScene(makeScene({ name: 'square', objects: [thing], materials: [made] }), 1);
  const hit = nearestHit(traced, { t: 1, x: [0.1, 0.2, 1], dt: -1, dx: [0, 0, -1] });
  if (!hit) throw new Error('nothing is met');
  return surfaceAt(traced, hit);
}
const near = (v: Vec3) => v.map((x) => expect.closeTo(x, 9));

/** Along u by 0.6, out by 0.8: 127.5 · 1.6, 127.5 · 1.8. */
const LEANING = { texture: one(204, 128, 230, 255), strength: [1, 0] } as const;
const [S, C] = normalize([204 / 127.5 - 1, 0, 230 / 127.5 - 1]).filter((x) => x !== 0);
/** 0.8 c along x: γ = 5/3. */
const FLYING = {
  motion: { kind: 'uniform', pose: { position: [0, 0, 0], orientation: IDENTITY }, velocity: [0.8, 0, 0] },
} as const;
const GAMMA = 5 / 3;

describe('a picture of normals', () => {
  it('leans along rising u, or with its strength the other way', () => {
    expect(below({ normalTexture: LEANING }).normal).toEqual(near([S, 0, C]));
    expect(below({ normalTexture: { ...LEANING, strength: [-1, 0] } }).normal).toEqual(near([-S, 0, C]));
  });

  it('leans along rising v, which is up in the picture', () => {
    const texture = one(128, 204, 230, 255);
    expect(below({ normalTexture: { texture, strength: [0, 1] } }).normal).toEqual(near([0, S, C]));
    const upsideDown = { ...plane(4, 4), uvs: plane(4, 4).uvs.map((x, i) => (i % 2 === 0 ? x : -x)) };
    expect(below({ normalTexture: { texture, strength: [0, 1] } }, {}, upsideDown).normal).toEqual(near([0, -S, C]));
  });

  it('leans in the rest frame, in which what the world sees contracted is longer along the motion', () => {
    const square = plane(4, 4);
    const aslant = {
      ...square,
      uvs: square.uvs.map((x, i) => (i % 2 === 0 ? x + square.uvs[i + 1] : x - square.uvs[i - 1])),
    };
    // u rises along (1, 1) of what is written.
    const along = (stretch: number): Vec3 => {
      const [x, y] = normalize([stretch, 1, 0]);
      return [S * x, S * y, C];
    };
    expect(below({ normalTexture: LEANING }, FLYING, aslant).normal).toEqual(near(along(GAMMA)));
    expect(below({ normalTexture: LEANING }, { ...FLYING, authoredIn: 'rest' }, aslant).normal).toEqual(near(along(1)));
  });

  it('leaves the normal of a surface without uvs as it is', () => {
    const bare = { ...plane(4, 4), uvs: new Float32Array(8) };
    expect(below({ normalTexture: LEANING }, {}, bare).normal).toEqual([0, 0, 1]);
  });
});

it('roughness and metalness are those of the texel, held within 0 … 1', () => {
  const texture = one(51, 102, 204, 255);
  const point = below({
    roughnessTexture: { texture, channel: 1, scale: 0.5, bias: 0.25 },
    metallicTexture: { texture, channel: 2, scale: 2, bias: 0 },
  });
  expect(point).toMatchObject({ roughness: expect.closeTo(0.45, 12), metallic: 1 });
});

it('invisible light is reflected as the material tells, or as its colour ends', () => {
  const { filter } = below({ baseColor: [0.5, 0.5, 0.5], ir: 0.875 });
  expect(filter).toMatchObject({ rgb: [0.5, 0.5, 0.5], uv: expect.closeTo(0.5, 6), ir: 0.875 });
});
