import { scale } from '../../math/vec3.ts';
import type { HyperbolicMotion, Lifetime, Pose, SceneHints, UniformMotion } from '../../scene/types.ts';
import { hintsFrom } from '../hints.ts';
import { numberAt, textAt, vec3At } from './attributes.ts';
import { report, type StageContext } from './context.ts';
import type { Layer, PrimSpec } from './layer.ts';

/** What our own attributes (docs/guide/usd.md) say about a prim; descendants have it too, unless they say otherwise. */
export interface Directions {
  readonly motion?: string;
  readonly velocity?: readonly [number, number, number];
  readonly properAcceleration?: readonly [number, number, number];
  readonly t0?: number;
  readonly birth?: number;
  readonly death?: number;
  readonly authoredIn?: string;
}

export function directionsOf(prim: PrimSpec, inherited: Directions): Directions {
  if (!someKey(prim.properties, (name) => name.startsWith('slowlight:'))) return inherited;
  const number = (name: string) => numberAt(prim, `slowlight:${name}`, undefined);
  const vector = (name: string) => vec3At(prim, `slowlight:${name}`, undefined);
  const text = (name: string) => textAt(prim, `slowlight:${name}`, undefined);
  const own = {
    motion: text('motion'),
    velocity: vector('velocity'),
    properAcceleration: vector('properAcceleration'),
    t0: number('t0'),
    birth: number('birth'),
    death: number('death'),
    authoredIn: text('authoredIn'),
  };
  const said = Object.entries(own).filter(([, value]) => value !== undefined);
  return said.length === 0 ? inherited : { ...inherited, ...Object.fromEntries(said) };
}

function someKey(map: ReadonlyMap<string, unknown>, ask: (key: string) => boolean): boolean {
  for (const key of map.keys()) if (ask(key)) return true;
  return false;
}

export const lifetimeOf = ({ birth, death }: Directions): Lifetime => ({
  birth: birth ?? -Infinity,
  death: death ?? Infinity,
});

export const authoredInOf = ({ authoredIn }: Directions): 'world' | 'rest' =>
  authoredIn === 'rest' ? 'rest' : 'world';

/** The world time [s] at which a closed-form motion has its pose; undefined where samples say how the object moves. */
export function poseTimeOf(directions: Directions): number | undefined {
  if (directions.motion === 'uniform') return 0;
  return directions.motion === 'hyperbolic' ? (directions.t0 ?? 0) : undefined;
}

/** The motion that the attributes ask for, from the pose at their pose time. */
export function directedMotion(
  context: StageContext,
  path: string,
  pose: Pose,
  directions: Directions,
): UniformMotion | HyperbolicMotion {
  if (directions.motion === 'uniform')
    return { kind: 'uniform', pose, velocity: scale(needed(context, path, directions, 'velocity'), context.unit) };
  const properAcceleration = scale(needed(context, path, directions, 'properAcceleration'), context.unit);
  return { kind: 'hyperbolic', pose, properAcceleration, t0: directions.t0 ?? 0 };
}

function needed(context: StageContext, path: string, from: Directions, name: 'velocity' | 'properAcceleration') {
  const value = from[name];
  if (value) return value;
  const message = `slowlight:motion is "${from.motion}" without slowlight:${name}, a vector3d; it rests`;
  report(context, 'warning', 'usd.slowlight', path, message);
  return [0, 0, 0] as const;
}

const MOTIONS = new Set([undefined, 'uniform', 'hyperbolic']);

/** Refuses values that mean nothing here, once per prim. */
export function checkDirections(context: StageContext, path: string, directions: Directions): void {
  const { motion, authoredIn } = directions;
  if (!MOTIONS.has(motion))
    report(
      context,
      'warning',
      'usd.slowlight',
      path,
      `slowlight:motion "${motion}" is not uniform or hyperbolic; it is left out`,
    );
  if (authoredIn !== undefined && authoredIn !== 'rest' && authoredIn !== 'world')
    report(
      context,
      'warning',
      'usd.slowlight',
      path,
      `slowlight:authoredIn "${authoredIn}" is not world or rest; world is taken`,
    );
}

/** `customLayerData = { dictionary slowlight = { … } }` */
export function hintsOf(layer: Layer): SceneHints {
  const custom = layer.metadata.get('customLayerData');
  const own = custom?.type === 'dictionary' ? custom.data.get('slowlight') : undefined;
  if (own?.type !== 'dictionary') return {};
  const { data } = own;
  return hintsFrom((name) => {
    const value = data.get(name);
    return value && 'data' in value ? value.data : undefined;
  });
}
