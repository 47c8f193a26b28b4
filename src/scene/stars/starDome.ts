import { toHalf } from '../../math/half.ts';
import { scale, type Vec3 } from '../../math/vec3.ts';
import { latLongFromDirection } from '../lights/latLong.ts';
import type { DomeLight, NightSky } from '../types.ts';
import { blackbody } from './blackbody.ts';
import type { Stars } from './brightStars.ts';

/** Size of the map; no star is smaller than one of its pixels at the equator, 2.8°. */
const SIZE = { width: 128, height: 64 } as const;

/** The stars are divided by 1/T, evenly between these, into so many classes: so their shifted light is that of all within 8 % for D of ½ … 2. */
const CLASSES = { coolest: 3400, hottest: 16_000, count: 3 } as const;

const domes = new WeakMap<NightSky, DomeLight>();

/** The light of all stars together as a dome, for what they shine on (docs/physics.md §6.11). Always the same object for the same sky. */
export function starDome(sky: NightSky): DomeLight {
  const dome = domes.get(sky) ?? makeDome(sky);
  domes.set(sky, dome);
  return dome;
}

function makeDome({ stars, path, orientation, gain }: NightSky): DomeLight {
  const { illuminances, directions } = stars;
  const total = illuminances.reduce((sum, E) => sum + E, 0);
  const dark = { kind: 'dome', path, color: [0, 0, 0] } as const;
  if (!(total * gain > 0)) return dark;
  const mean = total / (4 * Math.PI);
  const { width, height } = SIZE;
  const radiances = new Float64Array(width * height);
  for (let i = 0; i < illuminances.length; i++) {
    const direction: Vec3 = [directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]];
    const [u, v] = latLongFromDirection(direction);
    const row = Math.min(Math.floor((1 - v) * height), height - 1);
    const [top, bottom] = [row, row + 1].map((edge) => Math.cos((Math.PI * edge) / height));
    // Near the poles pixels are narrow: as many as are as wide as one at the equator.
    const columns = Math.min(Math.max(Math.round(Math.PI / height / (top - bottom)), 1), width);
    const first = Math.round(u * width - columns / 2) + width;
    const share = illuminances[i] / (columns * ((2 * Math.PI) / width) * (top - bottom));
    for (let k = 0; k < columns; k++) radiances[row * width + ((first + k) % width)] += share / mean;
  }
  const data = Uint16Array.from({ length: 4 * radiances.length }, (_, k) =>
    toHalf(k % 4 === 3 ? 1 : radiances[k >> 2]),
  );
  return {
    ...dark,
    color: [mean * gain, mean * gain, mean * gain],
    blackbodies: blackbodiesOf(stars, total),
    orientation,
    texture: {
      name: 'starlight',
      ...SIZE,
      data,
      colorSpace: 'linear',
      filter: 'linear',
      wrapS: 'repeat',
      wrapT: 'clamp',
    },
  };
}

/** Of each class the share of light, and the mean 1/T, on which to first order the logarithm of shifted light depends. */
function blackbodiesOf({ illuminances, temperatures }: Stars, total: number): NonNullable<DomeLight['blackbodies']> {
  const { coolest, hottest, count } = CLASSES;
  const sums = Array.from({ length: count }, () => ({ E: 0, inverse: 0 }));
  for (let i = 0; i < illuminances.length; i++) {
    const place = (1 / temperatures[i] - 1 / hottest) / (1 / coolest - 1 / hottest);
    const own = sums[Math.min(Math.max(Math.floor(place * count), 0), count - 1)];
    own.E += illuminances[i];
    own.inverse += illuminances[i] / temperatures[i];
  }
  return sums
    .filter(({ E }) => E > 0)
    .map(({ E, inverse }) => {
      const temperature = E / inverse;
      return { color: scale(blackbody(temperature).color, E / total), spectrum: { kind: 'thermal', temperature } };
    });
}
