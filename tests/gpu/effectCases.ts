import { IDENTITY } from '../../src/math/quat.ts';
import { random } from '../../src/math/random.ts';
import { normalize } from '../../src/math/vec3.ts';
import { properVelocity } from '../../src/physics/boost.ts';
import { Plane, type Taken } from '../../src/reference/effects/frame.ts';
import { applied } from '../../src/reference/effects/library.ts';
import { mixed } from '../../src/reference/effects/mix.ts';
import { DEFAULT_LIGHT } from '../../src/reference/lighting.ts';
import { renderTile } from '../../src/reference/tile.ts';
import { traceable } from '../../src/reference/trace.ts';
import { makeObject, makeScene, restingAt } from '../../src/scene/defaults.ts';
import type { EffectId, MixMode } from '../../src/scene/effects.ts';
import { plane, sphere } from '../../src/scene/primitives.ts';
import { type AovName, DEFAULT_SETTINGS, type ViewPoint } from '../../src/scene/view.ts';

/** What both twins are asked for. */
export interface EffectCase {
  readonly name: string;
  readonly of: EffectId | { readonly mode: MixMode };
  readonly args: readonly number[];
  readonly picture: keyof typeof PICTURES;
  readonly masked?: boolean;
}

const VIEW: ViewPoint = {
  t: 3,
  position: [0.5, 1, 2],
  u: properVelocity([0.1, 0, -0.6]),
  orientation: IDENTITY,
  fovY: 1,
};
const SETTINGS = { ...DEFAULT_SETTINGS, speedOfLight: 1 };
const ZENITH = [0, 1, 0] as const;

/** Light over six decades, and surfaces that have nothing to do with each other, with holes. */
function noise(): Taken {
  const [width, height] = [61, 47];
  const next = random(7);
  const image = Plane.of(width, height, 3, () => [0, 0, 0].map(() => 10 ** (6 * next() - 4)));
  const of = (channels: number, values: () => readonly number[]) =>
    Float32Array.from(Plane.of(width, height, channels, values).values);
  const object = of(1, () => [next() < 0.2 ? 0 : 1 + Math.floor(3 * next())]);
  const aovs = new Map<AovName, Float32Array>([
    ['object', object],
    ['depth', of(1, () => [10 ** (3 * next() - 1)])],
    ['normal', of(3, () => normalize([next() - 0.5, next() - 0.5, next() - 0.5]))],
    ['position', of(3, () => [0, 0, 0].map(() => 20 * (next() - 0.5)))],
  ]);
  return { image, aovs, view: VIEW, settings: SETTINGS, zenith: ZENITH };
}

/** A floor, a resting ball and one that flies by, as the reference renderer sees them from a flying observer. */
function scene(): Taken {
  const [width, height] = [96, 72];
  const objects = [
    makeObject({ path: '/floor', mesh: plane(30, 30), motion: restingAt([0, -1.2, -8]) }),
    makeObject({ path: '/still', mesh: sphere(1), motion: restingAt([-1.5, 0, -6]) }),
    makeObject({
      path: '/fast',
      mesh: sphere(0.8),
      authoredIn: 'rest',
      motion: { kind: 'uniform', pose: { position: [6, 0.5, -7], orientation: IDENTITY }, velocity: [0.6, 0, 0] },
    }),
  ];
  const layers = ['beauty', 'object', 'depth', 'normal', 'position'] as const;
  const request = { view: VIEW, settings: SETTINGS, width, height, layers, samples: 1, seed: 0, light: DEFAULT_LIGHT };
  const data = renderTile(traceable(makeScene({ name: 'balls', objects }), 1), request, {
    x0: 0,
    y0: 0,
    x1: width,
    y1: height,
  });
  const aovs = new Map(layers.map((name) => [name, data[name] ?? new Float32Array()]));
  return {
    image: new Plane(width, height, 3, data.beauty),
    aovs,
    view: VIEW,
    settings: SETTINGS,
    zenith: ZENITH,
  };
}

const PICTURES = { noise, scene };
const taken = new Map<string, Taken>();

export function pictureOf({ picture }: EffectCase): Taken {
  const known = taken.get(picture) ?? PICTURES[picture]();
  taken.set(picture, known);
  return known;
}

/** From nothing at the left to all at the right, and beyond. */
export const maskOf = ({ image }: Taken): Plane => image.map((x) => [(1.4 * x) / image.width - 0.2, 0, 0]);

/** What is laid over a picture: its mirror image, dimmer. */
export const overOf = ({ image }: Taken): Plane =>
  image.map((x, y) => image.at(image.width - 1 - x, y).map((value) => 0.3 * value));

/** In f64. */
export function expected(of: EffectCase): Plane {
  const picture = pictureOf(of);
  const mask = of.masked ? maskOf(picture) : undefined;
  if (typeof of.of === 'string') return applied(of.of, of.args, picture, mask);
  return mixed(of.of.mode, of.args[0] ?? 0, picture.image, overOf(picture), mask);
}

const both = (of: EffectCase['of'], args: readonly number[]): EffectCase[] =>
  (['noise', 'scene'] as const).map((picture) => ({
    name: `${typeof of === 'string' ? of : `mix ${of.mode}`} ${args.join(' ')}, ${picture}`,
    of,
    args,
    picture,
  }));

export const EFFECT_CASES: readonly EffectCase[] = [
  ...both('gaussian-blur', [4, 0]),
  ...both('gaussian-blur', [2.3, 90]),
  ...both('gaussian-blur', [3.1, 30]),
  ...both('gaussian-blur', [0, 45]),
  ...both('bilateral-filter', [2, 0, 0]),
  ...both('bilateral-filter', [2.5, 0.05, 20]),
  ...both('bilateral-filter', [2.5, 0.3, 0]),
  ...both('sky-background', [2, 0.45, 0, 1]),
  ...both('sky-background', [1, 0.8, 12, 0.7]),
  ...both('sharpen', [1.5, 0]),
  ...both('sharpen', [3, 0.5]),
  ...both('bloom', [0.3, 0.7]),
  ...both('bloom', [1, 1]),
  ...both('edge', [0.5, 2, 1, 0.8]),
  ...both('edge', [0, 5, 0, 0]),
  ...both('vignette', [1, 4, 0]),
  ...both('vignette', [0.7, 2, 50]),
  ...both('fog', [8, 0.6, 0.5, 1]),
  ...both('fog', [20, 2, 0, 0.3]),
  ...both('depth-of-field', [4, 300, 12]),
  ...both('depth-of-field', [6, 2000, 24]),
  ...both({ mode: 'normal' }, [0.4]),
  ...both({ mode: 'multiply' }, [1]),
  ...both({ mode: 'add' }, [0.8]),
  ...both({ mode: 'screen' }, [1]),
  ...both({ mode: 'overlay' }, [1]),
  ...both({ mode: 'difference' }, [1]),
  ...both({ mode: 'split' }, [0.35]),
  ...both({ mode: 'wipe' }, [0.5]),
  { name: 'blur under a mask', of: 'gaussian-blur', args: [3, 0], picture: 'scene', masked: true },
  { name: 'bloom under a mask', of: 'bloom', args: [1, 0.5], picture: 'noise', masked: true },
  { name: 'add under a mask', of: { mode: 'add' }, args: [1], picture: 'noise', masked: true },
];
