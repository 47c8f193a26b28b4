import { scale } from '../../../math/vec3.ts';
import { msg } from '../../../messages/message.ts';
import type {
  HyperbolicMotion,
  Lifetime,
  Pose,
  SceneHints,
  StaticMotion,
  UniformMotion,
} from '../../../scene/types.ts';
import { parseSceneHints } from '../../attributes/hints.ts';
import { report } from '../diagnostics.ts';
import { numberAt, textAt, vec3At } from '../layer/attributes.ts';
import type { Layer, PrimSpec } from '../layer/layer.ts';
import type { StageContext } from './context.ts';

/** Values of the `slowlight:` attributes of a prim (docs/guide/usd.md), inherited unless overridden. */
export interface SlowlightAttributes {
  readonly motion?: string;
  readonly velocity?: readonly [number, number, number];
  readonly properAcceleration?: readonly [number, number, number];
  readonly t0?: number;
  readonly birth?: number;
  readonly death?: number;
  readonly authoredIn?: string;
}

export function slowlightAttributesOf(prim: PrimSpec, inherited: SlowlightAttributes): SlowlightAttributes {
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
  const authored = Object.entries(own).filter(([, value]) => value !== undefined);
  return authored.length === 0 ? inherited : { ...inherited, ...Object.fromEntries(authored) };
}

function someKey(map: ReadonlyMap<string, unknown>, ask: (key: string) => boolean): boolean {
  for (const key of map.keys()) if (ask(key)) return true;
  return false;
}

export const lifetimeOf = ({ birth, death }: SlowlightAttributes): Lifetime => ({
  birth: birth ?? -Infinity,
  death: death ?? Infinity,
});

export const authoredInOf = ({ authoredIn }: SlowlightAttributes): 'world' | 'rest' =>
  authoredIn === 'rest' ? 'rest' : 'world';

/** A closed-form motion of the `slowlight:` attributes. */
interface ClosedForm {
  /** World time of its pose [s]. */
  poseTime(directions: SlowlightAttributes): number;
  motion(context: StageContext, path: string, pose: Pose, directions: SlowlightAttributes): MotionAttributes;
}
type MotionAttributes = UniformMotion | HyperbolicMotion;

/** By the value of `slowlight:motion`. */
const CLOSED_FORMS: { readonly [K in MotionAttributes['kind']]: ClosedForm } = {
  uniform: {
    poseTime: () => 0,
    motion: (context, path, pose, directions) => ({
      kind: 'uniform',
      pose,
      velocity: scale(requiredVector(context, path, 'uniform', directions, 'velocity'), context.unit),
    }),
  },
  hyperbolic: {
    poseTime: ({ t0 }) => t0 ?? 0,
    motion: (context, path, pose, directions) => {
      const properAcceleration = scale(
        requiredVector(context, path, 'hyperbolic', directions, 'properAcceleration'),
        context.unit,
      );
      return { kind: 'hyperbolic', pose, properAcceleration, t0: directions.t0 ?? 0 };
    },
  },
};

const isClosedForm = (motion: string | undefined): motion is MotionAttributes['kind'] =>
  motion !== undefined && Object.hasOwn(CLOSED_FORMS, motion);

/** World time [s] of a closed-form motion's pose; undefined if the motion is sampled. */
export const poseTimeOf = (directions: SlowlightAttributes): number | undefined =>
  isClosedForm(directions.motion) ? CLOSED_FORMS[directions.motion].poseTime(directions) : undefined;

/** The motion of the attributes, with the pose at their pose time; static if they have none. */
export const closedFormMotion = (
  context: StageContext,
  path: string,
  pose: Pose,
  directions: SlowlightAttributes,
): MotionAttributes | StaticMotion =>
  isClosedForm(directions.motion)
    ? CLOSED_FORMS[directions.motion].motion(context, path, pose, directions)
    : { kind: 'static', pose };

function requiredVector(
  context: StageContext,
  path: string,
  motion: MotionAttributes['kind'],
  from: SlowlightAttributes,
  name: 'velocity' | 'properAcceleration',
) {
  const value = from[name];
  if (value) return value;
  const message = msg`slowlight:motion is "${motion}" without slowlight:${name}, a vector3d; it rests`;
  report(context, 'warning', 'usd.slowlight', path, message);
  return [0, 0, 0] as const;
}

/** Reports invalid values; called once per prim. */
export function checkSlowlightAttributes(context: StageContext, path: string, directions: SlowlightAttributes): void {
  const { motion, authoredIn } = directions;
  if (motion !== undefined && !isClosedForm(motion))
    report(
      context,
      'warning',
      'usd.slowlight',
      path,
      msg`slowlight:motion "${motion}" is not uniform or hyperbolic; it is left out`,
    );
  if (authoredIn !== undefined && authoredIn !== 'rest' && authoredIn !== 'world')
    report(
      context,
      'warning',
      'usd.slowlight',
      path,
      msg`slowlight:authoredIn "${authoredIn}" is not world or rest; world is taken`,
    );
}

/** `customLayerData = { dictionary slowlight = { … } }` */
export function hintsOf(layer: Layer): SceneHints {
  const custom = layer.metadata.get('customLayerData');
  const own = custom?.type === 'dictionary' ? custom.data.get('slowlight') : undefined;
  if (own?.type !== 'dictionary') return {};
  const { data } = own;
  return parseSceneHints((name) => {
    const value = data.get(name);
    return value && 'data' in value ? value.data : undefined;
  });
}
