import { add, addScaled, dot, length, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { type FourVector, spatial } from '../../physics/lorentz/fourVector.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { VIEWS } from '../../scene/views/views.ts';
import type { SightCurve, SpacetimeRay } from '../acceleration/ray.ts';

/** Angle at the eye under which a chord is seen [rad]: where the curve bends, its distance is at most an eighth of the square from it, of that from the eye. */
const CHORD_ANGLE = Math.PI / 96;
/** Tangents of the multiples of `CHORD_ANGLE` within a right angle to both sides. */
const TANGENTS = Array.from({ length: 95 }, (_, k) => Math.tan((k - 47) * CHORD_ANGLE));

/**
 * What is seen in the direction n′ (unit) from `vantage` [m], both in the observer's space. With P(s) = vantage + s n′, of length r(s), the events are
 *
 *     ξ(s) = A P(s) + b r(s),    r² = e² + (s − s₀)²,
 *
 * A linear and b constant: in every view, an event depends on where it is shown by `ViewRecord.rayToward`(n′) r, and all of these are linear in P and r. So it is
 * straight but for r, a hyperbola about the point next to the eye, at s₀ and the distance e. docs/physics.md §10.5.
 */
export function sightCurve(
  { t, position, u }: Pick<ViewPoint, 't' | 'position' | 'u'>,
  vantage: Vec3,
  n: Vec3,
  settings: RenderSettings,
): SightCurve {
  const eventIn = (direction: Vec3): FourVector => VIEWS[settings.view].rayToward(direction, u, settings);
  const middle = -dot(vantage, n);
  const closest = length(addScaled(vantage, n, middle));
  const away = length(vantage);
  const r = (s: number): number => Math.hypot(closest, s - middle);
  const [ahead, behind, toCamera] = [eventIn(n), eventIn(scale(n, -1)), eventIn(scale(vantage, 1 / away))];
  const b = combine((i) => (ahead[i]! + behind[i]!) / 2);
  const along = combine((i) => ahead[i]! - b[i]!);
  const start = combine((i) => (toCamera[i]! - b[i]!) * away);
  /** The straight ray through the event at s, with this change of r. */
  const straight = (s: number, slope: number): SpacetimeRay => {
    const change = combine((i) => along[i]! + b[i]! * slope);
    const origin = combine((i) => start[i]! + b[i]! * (r(s) - slope * s));
    return { t: t + origin[0] / settings.speedOfLight, x: add(position, spatial(origin)), ...parts(change) };
  };
  const isStraight = Math.hypot(...b) < 1e-12 * Math.hypot(...along);
  const knots = isStraight ? [0, Number.POSITIVE_INFINITY] : knotsOf(middle, closest, away);
  return {
    knots,
    chord(k) {
      const [from, to] = [knots[k]!, knots[k + 1]!];
      return straight(from, to === Number.POSITIVE_INFINITY ? 1 : (r(to) - r(from)) / (to - from));
    },
    tangent: (s) => straight(s, r(s) > 0 ? (s - middle) / r(s) : 1),
    lightFrom(s) {
      const P = addScaled(vantage, n, s);
      return { t, x: position, ...parts(eventIn(normalize(P, n))) };
    },
  };
}

/** Those from the camera on, of a line that is `closest` to the eye at s = `middle`; one that leads through it is straight before and behind it. */
function knotsOf(middle: number, closest: number, away: number): readonly number[] {
  const bends = closest > 1e-9 * away ? TANGENTS.map((tangent) => middle + closest * tangent) : [middle];
  return [0, ...bends.filter((s) => s > 0), Number.POSITIVE_INFINITY];
}

const combine = (component: (i: number) => number): FourVector => [
  component(0),
  component(1),
  component(2),
  component(3),
];
const parts = (v: FourVector): Pick<SpacetimeRay, 'dt' | 'dx'> => ({ dt: v[0], dx: spatial(v) });
