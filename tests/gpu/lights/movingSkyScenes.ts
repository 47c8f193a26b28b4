import { toHalf } from '../../../src/math/half.ts';
import { fromAxisAngle, IDENTITY, rotate } from '../../../src/math/quat.ts';
import { dot, normalize, scale, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import type { SceneRenderer } from '../../../src/render/renderer.ts';
import { directionFromLatLong, domeAxes, latLongFromDirection } from '../../../src/scene/lights/latLong.ts';
import { DAY_SKY } from '../../../src/scene/lights/sceneLights.ts';
import { gradientAt } from '../../../src/scene/lights/skyGradient.ts';
import { sampleTexture } from '../../../src/scene/materials/sampleTexture.ts';
import { plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import { brightStars } from '../../../src/scene/stars/brightStars.ts';
import { EQUATORIAL } from '../../../src/scene/stars/equatorial.ts';
import type { DomeLight, Material, NightSky } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { dome, GREY, lambert, lit, mirror } from '../../support/lightKit.ts';

// Balls and plates that fly through an observer's view, under skies.

export const SIZE = 24;
/** Every pixel of every so many rows and columns is compared. */
const STEP = 2;

const [W, H] = [128, 64];
const TURN = fromAxisAngle(normalize([0.3, 1, -0.4]), 2.1);

/** A dome with a picture of grey radiance, rotated against the world. */
function pictured(radiance: (n: Vec3) => number): DomeLight {
  return {
    ...dome([1, 1, 1]),
    orientation: TURN,
    texture: {
      name: 'dome',
      width: W,
      height: H,
      data: Uint16Array.from({ length: 4 * W * H }, (_, i) => {
        const [x, y] = [(i >> 2) % W, Math.floor((i >> 2) / W)];
        return toHalf(i % 4 === 3 ? 1 : radiance(rotate(TURN, directionFromLatLong((x + 0.5) / W, 1 - (y + 0.5) / H))));
      }),
      colorSpace: 'linear',
      filter: 'linear',
      wrapS: 'repeat',
      wrapT: 'clamp',
    },
  };
}

/** A disc in the sky, of an angular radius [rad], on a dimmer ground. */
const spot = (at: Vec3, radius: number, brightness: number) =>
  pictured((n) => (dot(n, normalize(at)) > Math.cos(radius) ? brightness : 0.6 + 0.4 * n[1]));

export const SKIES = {
  uniform: dome([0.5, 0.75, 0.25]),
  white: dome([1, 1, 1]),
  day: DAY_SKY,
  'dark ground': { ...dome([1, 1, 1]), gradient: { horizon: [1, 1, 1], ground: ZERO } },
  spot: spot([0.8, 0.6, 0.5], 0.17, 40),
  sun: spot([-0.4, 0.7, 0.5], 0.06, 900),
  clouds: pictured((n) => 1 + Math.sin(7 * n[0] + 3 * n[1]) * Math.cos(6 * n[2])),
} as const satisfies Record<string, DomeLight>;
export type SkyName = keyof typeof SKIES;

export const NIGHT: NightSky = {
  kind: 'stars',
  path: '/Stars',
  stars: brightStars(),
  orientation: EQUATORIAL,
  gain: 1e4,
};

export const MATERIALS = {
  matt: lambert(0.8),
  'rough metal': mirror({ roughness: 1 }),
  metal: mirror({ roughness: 0.5 }),
  'glossy metal': mirror({ roughness: 0.3 }),
} as const satisfies Record<string, Material>;
export type MaterialName = keyof typeof MATERIALS;

export interface SkyFlight {
  readonly sky: SkyName | 'stars';
  readonly material: MaterialName;
  /** [c] */
  readonly velocity: Vec3;
  /** A plate that faces the observer instead of a ball. */
  readonly plate?: boolean;
  /** Whether colours are those of spectra. */
  readonly spectral?: boolean;
}

/** One pixel: linear sRGB, D, the normal in the rest frame, and the direction of the surface in the world. */
export interface SeenPoint {
  readonly light: Vec3;
  readonly D: number;
  readonly normal: Vec3;
  readonly toward: Vec3;
}

/** Draws what is at the middle of the picture. */
export async function seenPoints(
  renderer: SceneRenderer,
  { sky, material, velocity, plate, spectral }: SkyFlight,
): Promise<SeenPoint[]> {
  // Light from the middle has been under way for 3 s.
  const motion = { kind: 'uniform', pose: { position: scale(velocity, 3), orientation: IDENTITY }, velocity } as const;
  const mesh = plate ? plane(1.5, 1.5) : sphere(1, { segments: 64, rings: 32 });
  const things = [{ mesh, material: MATERIALS[material], motion }];
  const { scene } = lit(things, sky === 'stars' ? [] : [SKIES[sky]]);
  const view: ViewPoint = { t: 0, position: [0, 0, 3], u: ZERO, orientation: IDENTITY, lens: perspective(0.8) };
  const settings: RenderSettings = {
    ...GREY,
    grid: false,
    occlusionRadius: 0,
    ...(spectral && { colors: 'spectral', dopplerMix: 1 }),
  };
  await renderer.setScene(sky === 'stars' ? { ...scene, lights: [NIGHT] } : scene);
  renderer.render([view], settings, 1);
  const [light, D, normal, position, object] = await Promise.all(
    (['beauty', 'doppler', 'normal', 'position', 'object'] as const).map((name) => renderer.readAov(name)),
  );
  const points: SeenPoint[] = [];
  for (let y = 0; y < SIZE; y += STEP)
    for (let x = 0; x < SIZE; x += STEP) {
      const i = y * SIZE + x;
      if (object[i] !== 1) continue;
      const at = (values: Float32Array): Vec3 => [values[3 * i], values[3 * i + 1], values[3 * i + 2]];
      const [px, py, pz] = at(position);
      points.push({ light: at(light), D: D[i], normal: normalize(at(normal)), toward: normalize([px, py, pz - 3]) });
    }
  return points;
}

/** Linear sRGB radiance of a sky from a direction of the world. */
export function radianceOf(name: SkyName): (n: Vec3) => Vec3 {
  const sky: DomeLight = SKIES[name];
  const { texture, gradient } = sky;
  if (texture) {
    const [x, y, z] = domeAxes(sky);
    return (n) => {
      const [r, g, b] = sampleTexture(texture, ...latLongFromDirection([dot(n, x), dot(n, y), dot(n, z)]));
      return [r, g, b];
    };
  }
  return gradient ? (n) => gradientAt(n[1], { zenith: sky.color, ...gradient }) : () => sky.color;
}
