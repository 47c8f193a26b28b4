import { toHalf } from '../../math/half.ts';
import { scale, type Vec3 } from '../../math/vec3.ts';
import { latLongFromDirection } from '../lights/latLong.ts';
import type { DomeLight, NightSky } from '../types.ts';
import { blackbody } from './blackbody.ts';
import type { Stars } from './brightStars.ts';

/** Size of the map; no star is smaller than one of its pixels at the equator, 2.8°. */
const SIZE = { width: 128, height: 64 } as const;

/**
 * The stars are divided by 1/T, evenly between these, into three classes, one for each channel of the map: each is two blackbodies,
 * whose shifted light is that of all within 1 % for D of 0.4 … 2.5.
 */
const CLASSES = { coolest: 3400, hottest: 16_000 } as const;

const domes = new WeakMap<NightSky, DomeLight>();

/** The light of all stars together as a dome, for what they shine on (docs/physics.md §6.11). Always the same object for the same sky. */
export function starDome(sky: NightSky): DomeLight {
  const dome = domes.get(sky) ?? makeDome(sky);
  domes.set(sky, dome);
  return dome;
}

function makeDome({ stars, path, orientation, gain }: NightSky): DomeLight {
  const { illuminances, directions } = stars;
  const dark = { kind: 'dome', path, color: [0, 0, 0] } as const;
  if (!(illuminances.some((E) => E > 0) && gain > 0)) return dark;
  const { totals, blackbodies, classes } = classesOf(stars);
  const means = scale(totals, 1 / (4 * Math.PI));
  const { width, height } = SIZE;
  // Of each pixel the radiance of each class over its mean, and 1.
  const texels = new Float64Array(4 * width * height).map((_, k) => (k % 4 === 3 ? 1 : 0));
  for (let i = 0; i < illuminances.length; i++) {
    const direction: Vec3 = [directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]];
    const [u, v] = latLongFromDirection(direction);
    const row = Math.min(Math.floor((1 - v) * height), height - 1);
    const [top, bottom] = [row, row + 1].map((edge) => Math.cos((Math.PI * edge) / height));
    // Near the poles pixels are narrow: as many as are as wide as one at the equator.
    const columns = Math.min(Math.max(Math.round(Math.PI / height / (top - bottom)), 1), width);
    const first = Math.round(u * width - columns / 2) + width;
    const share = illuminances[i] / (columns * ((2 * Math.PI) / width) * (top - bottom) * means[classes[i]]);
    for (let k = 0; k < columns; k++) texels[4 * (row * width + ((first + k) % width)) + classes[i]] += share;
  }
  return {
    ...dark,
    color: scale(means, gain),
    blackbodies,
    orientation,
    texture: {
      name: 'starlight',
      ...SIZE,
      data: Uint16Array.from(texels, toHalf),
      colorSpace: 'linear',
      filter: 'linear',
      wrapS: 'repeat',
      wrapT: 'clamp',
    },
  };
}

/** Of each star its class, of each class all its light, and the blackbodies of all. */
function classesOf({ illuminances, temperatures }: Stars) {
  const [hottest, coolest] = [1 / CLASSES.hottest, 1 / CLASSES.coolest];
  const totals: [number, number, number] = [0, 0, 0];
  const classes = Array.from(temperatures, (T) => {
    const place = (1 / T - hottest) / (coolest - hottest);
    return Math.min(Math.max(Math.floor(3 * place), 0), 2);
  });
  classes.forEach((own, i) => {
    totals[own] += illuminances[i];
  });
  const blackbodies = totals.flatMap((total, channel) => {
    const mean = (f: (inverse: number) => number): number =>
      classes.reduce((sum, own, i) => (own === channel ? sum + illuminances[i] * f(1 / temperatures[i]) : sum), 0) /
      total;
    return total > 0
      ? gaussNodes(mean).map(({ at, weight }) => ({ ...coloredBlackbody(1 / at, weight), channel }))
      : [];
  });
  return { totals, classes, blackbodies };
}

const coloredBlackbody = (temperature: number, weight: number) => ({
  color: scale(blackbody(temperature).color, weight),
  spectrum: { kind: 'thermal', temperature } as const,
});

/** The Gauss quadrature of two nodes of a distribution that is given by its means: exact for cubics. */
function gaussNodes(mean: (f: (x: number) => number) => number): { at: number; weight: number }[] {
  const middle = mean((x) => x);
  const deviation = Math.sqrt(mean((x) => (x - middle) ** 2));
  if (deviation < 1e-6 * middle) return [{ at: middle, weight: 1 }];
  const skewness = mean((x) => ((x - middle) / deviation) ** 3);
  const root = Math.sqrt(skewness ** 2 + 4);
  return [1, -1].map((sign) => ({
    at: middle + (deviation * (skewness + sign * root)) / 2,
    weight: (root - sign * skewness) / (2 * root),
  }));
}
