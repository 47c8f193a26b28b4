import { fromAxisAngle, IDENTITY, multiply } from '../../../src/math/quat.ts';
import { normalize, type Vec3 } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import type { SceneRenderer } from '../../../src/render/renderer.ts';
import { FOREVER, makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { withMaterial } from '../../../src/scene/mesh/meshOps.ts';
import { box, grid, sphere, torus } from '../../../src/scene/mesh/primitives.ts';
import { brightStars } from '../../../src/scene/stars/brightStars.ts';
import { EQUATORIAL } from '../../../src/scene/stars/equatorial.ts';
import type { Scene, Texture } from '../../../src/scene/types.ts';
import type { Lens } from '../../../src/scene/view/lenses/lenses.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';

const C = 10;
export const SIZE = { width: 120, height: 90 };
export const DIRECT: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: C, antialiasing: false };
export const CAPTURED: RenderSettings = { ...DIRECT, capture: { texels: 512, maxError: 0.5 } };

/** Side of the pattern on the floor [texels]. */
const TILES = 16;
const CHECKER: Texture = {
  name: 'checker',
  colorSpace: 'srgb',
  filter: 'linear',
  wrapS: 'repeat',
  wrapT: 'repeat',
  width: TILES,
  height: TILES,
  data: Uint8Array.from({ length: 4 * TILES * TILES }, (_, i) => {
    const [texel, channel] = [Math.floor(i / 4), i % 4];
    if (channel === 3) return 255;
    return ((texel % TILES) + Math.floor(texel / TILES)) % 2 === 0 ? 220 : 60 + 40 * channel;
  }),
};

const resting = (path: string, position: Vec3, size: number) =>
  makeObject({ path, mesh: box([size, size, size]), motion: restingAt(position) });
/** On all sides, with a sun and a lamp; one glows, one is in flight. */
export const SCENE: Scene = makeScene({
  name: 'around',
  materials: [
    makeMaterial({ name: 'matt', baseColor: [0.6, 0.5, 0.4], roughness: 0.6 }),
    makeMaterial({ name: 'tiles', roughness: 0.8, baseColorTexture: CHECKER }),
    makeMaterial({ name: 'warm', baseColor: [0.1, 0.1, 0.1], emissive: [0.8, 0.5, 0.2], emissionTemperature: 3000 }),
  ],
  lights: [
    { kind: 'distant', path: '/Sun', direction: normalize([0.4, -1, -0.3]), color: [2, 1.9, 1.7] },
    {
      kind: 'sphere',
      path: '/Lamp',
      motion: restingAt([0, 4, 0]),
      radius: 0.1,
      color: [300, 280, 260],
      lifetime: FOREVER,
    },
  ],
  objects: [
    makeObject({ path: '/Floor', mesh: withMaterial(grid(40, 40, 8, 8, 'Y'), 1), motion: restingAt([0, -2, 0]) }),
    resting('/Ahead', [1, 0, -8], 2),
    resting('/Behind', [-1, 1, 7], 2),
    resting('/Right', [6, 1, 1], 2),
    resting('/Above', [0.5, 6, -0.5], 2),
    makeObject({ path: '/Ember', mesh: withMaterial(torus(1, 0.4), 2), motion: restingAt([-5, 0, -2]) }),
    makeObject({
      path: '/Ball',
      mesh: sphere(1.5, { segments: 64, rings: 32 }),
      motion: { kind: 'uniform', pose: { position: [-6, 2, -5], orientation: IDENTITY }, velocity: [0.8 * C, 0, 0] },
    }),
  ],
});

/** With what a capture cannot hold. */
export const LAYERED: Scene = makeScene({
  ...SCENE,
  name: 'layered',
  materials: [
    ...SCENE.materials,
    makeMaterial({ name: 'veil', baseColor: [0.2, 0.4, 0.8], opacity: 0.5 }),
    makeMaterial({
      name: 'lacquer',
      baseColor: [0.7, 0.1, 0.1],
      roughness: 0.6,
      clearcoat: { factor: 1, roughness: 0.2 },
    }),
  ],
  lights: [
    ...SCENE.lights,
    { kind: 'stars', path: '/Stars', stars: brightStars(), orientation: EQUATORIAL, gain: 3e4 },
  ],
  objects: [
    ...SCENE.objects,
    makeObject({ path: '/Veil', mesh: withMaterial(sphere(1), 3), motion: restingAt([0.5, 0, -5]) }),
    makeObject({ path: '/Lacquer', mesh: withMaterial(sphere(1), 4), motion: restingAt([2, 0, -6]) }),
  ],
});

const EVENT = { t: 0.3, position: [0.3, 0.2, 0.5] as Vec3 };
const FORTH = multiply(fromAxisAngle([0, 1, 0], 0.3), fromAxisAngle([1, 0, 0], -0.15));
const BACK = multiply(fromAxisAngle([0, 1, 0], Math.PI), FORTH);
const LENS = perspective(1.2);
const at = (beta: Vec3, orientation = FORTH, lens: Lens = LENS): ViewPoint => ({
  ...EVENT,
  u: properVelocity(beta),
  orientation,
  lens,
});

/** Eleven velocities, directions and lenses of an observer at one event. */
export const VIEWS: Readonly<Record<string, ViewPoint>> = {
  'at rest': at([0, 0, 0]),
  '0.3 c ahead': at([0, 0, -0.3]),
  '0.5 c, looking back': at([0, 0, -0.5], BACK),
  '0.9 c ahead': at([0, 0, -0.9]),
  '0.9 c, looking back': at([0, 0, -0.9], BACK),
  '0.6 c aside': at([0.4, 0.1, -0.43]),
  '0.9 c aside': at([0.8, 0.3, -0.3]),
  '0.99 c ahead': at([0, 0, -0.99]),
  '0.6 c, dome': at([0.3, 0, -0.5], FORTH, { kind: 'fisheye', aperture: Math.PI, elevation: 0.2 }),
  '0.6 c, all around': at([0.3, 0, -0.5], FORTH, { kind: 'equirectangular' }),
  '0.9 c, cube': at([0, 0, -0.9], FORTH, { kind: 'cube', layout: '3x2' }),
};

export interface Picture {
  readonly light: number[];
  readonly object: number[];
  readonly depth: number[];
  readonly doppler: number[];
  readonly normal: number[];
  readonly triangles: number;
}

export async function picture(
  renderer: SceneRenderer,
  view: ViewPoint,
  settings: RenderSettings,
  beforeFrame: () => void,
): Promise<Picture> {
  renderer.setSize(SIZE.width, SIZE.height);
  beforeFrame();
  renderer.render([view], settings, 1);
  const channel = async (name: Parameters<SceneRenderer['readAov']>[0]) => Array.from(await renderer.readAov(name));
  const [light, object, depth, doppler, normal] = [
    await channel('beauty'),
    await channel('object'),
    await channel('depth'),
    await channel('doppler'),
    await channel('normal'),
  ];
  await renderer.readPixels();
  return { light, object, depth, doppler, normal, triangles: renderer.info.triangles };
}

/** The pictures of these views, drawn and, on another renderer of the device, all from one capture; that is drawn before the first, without others. */
export async function agreement(
  renderer: SceneRenderer,
  names: readonly string[],
  beforeFrame: () => void,
): Promise<readonly (Difference & { readonly drawnTriangles: number; readonly capturedTriangles: number })[]> {
  const other = renderer.beside();
  try {
    await other.setScene(SCENE);
    const found = [];
    for (const name of names) {
      const drawn = await picture(renderer, VIEWS[name]!, DIRECT, beforeFrame);
      const captured = await picture(other, VIEWS[name]!, CAPTURED, beforeFrame);
      const triangles = { drawnTriangles: drawn.triangles, capturedTriangles: captured.triangles };
      found.push({ ...difference(drawn, captured), ...triangles });
    }
    return found;
  } finally {
    other.dispose();
  }
}

/** How far a picture from a capture is from one that is drawn. */
export interface Difference {
  /** Share of pixels with the same object. */
  readonly same: number;
  /** Median and 90th percentile, of those, of the relative difference of light. */
  readonly light: number;
  readonly light90: number;
  readonly doppler: number;
  readonly depth: number;
  /** Of normals [rad]. */
  readonly normal: number;
}

export function difference(drawn: Picture, captured: Picture): Difference {
  const [light, doppler, depth, normal]: [number[], number[], number[], number[]] = [[], [], [], []];
  let same = 0;
  const rgb = (values: readonly number[], i: number): readonly number[] => values.slice(3 * i, 3 * i + 3);
  const apart = (a: readonly number[], b: readonly number[]): number => Math.hypot(...a.map((x, k) => x - b[k]!));
  drawn.object.forEach((object, i) => {
    if (object !== captured.object[i]) return;
    same++;
    const there = rgb(drawn.light, i);
    light.push(apart(there, rgb(captured.light, i)) / (Math.hypot(...there) + 1e-9));
    if (object === 0) return;
    doppler.push(Math.abs(captured.doppler[i]! / drawn.doppler[i]! - 1));
    depth.push(Math.abs(captured.depth[i]! / drawn.depth[i]! - 1));
    normal.push(apart(rgb(drawn.normal, i), rgb(captured.normal, i)));
  });
  const quantile = (values: number[], q: number): number =>
    values.sort((a, b) => a - b)[Math.floor(q * (values.length - 1))] ?? 0;
  return {
    same: same / drawn.object.length,
    light: quantile(light, 0.5),
    light90: quantile(light, 0.9),
    doppler: quantile(doppler, 0.99),
    depth: quantile(depth, 0.5),
    normal: quantile(normal, 0.9),
  };
}
