import { addScaled, dot, length, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import type { FourVector } from '../../physics/lorentz/fourVector.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { VIEWS } from '../../scene/views/views.ts';
import type { SightCurve, SpacetimeRay } from '../acceleration/ray.ts';

/*
 * Knots of a curve, as the angles at the observer's eye between what is seen there and what is seen at infinity. A chord under the angle δ is at most δ²/8 of the distance from the
 * curve, the last one half the square of where it begins.
 */

/** Far away, where the curve is nearly straight: in steps to 0.6 of the angle, to 1.3 · 10⁻⁴ of the distance. */
const FAR = Array.from({ length: 6 }, (_, k) => 0.08 * 0.6 ** k);
/** Near by for a camera that is among what is seen: in steps of 1/32, to as much. */
const NEAR = Array.from({ length: 96 }, (_, k) => 0.08 + (96 - k) / 32).filter((angle) => angle < Math.PI - 0.08);
/** On the way towards the eye, as far away. */
const BEHIND = FAR.map((angle) => Math.PI - angle).reverse();
/** Near by for the two eyes of one head, nearer to each other than to anything: to 5 · 10⁻⁴ from seven times their distance from its middle on, and coarser nearer by. */
const HEAD = [1, 0.5, 0.25, 0.14];

/** Cotangents: distances along the curve from where it is nearest to the eye, over that distance. */
const TANGENTS = { vantage: cotangents([...BEHIND, ...NEAR, ...FAR]), head: cotangents([...HEAD, ...FAR]) } as const;
/** Whether the camera stands aside, or is one of two eyes of the head. */
export type CameraPlace = keyof typeof TANGENTS;

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
  place: CameraPlace,
): SightCurve {
  const eventIn = (direction: Vec3): FourVector => VIEWS[settings.view].rayToward(direction, u, settings);
  const middle = -dot(vantage, n);
  const closest = length(addScaled(vantage, n, middle));
  const away = length(vantage);
  const r = (s: number): number => Math.sqrt(closest * closest + (s - middle) * (s - middle));
  const [ahead, behind, toCamera] = [eventIn(n), eventIn(scale(n, -1)), eventIn(scale(vantage, 1 / away))];
  const b = combine((i) => (ahead[i]! + behind[i]!) / 2);
  const along = combine((i) => ahead[i]! - b[i]!);
  const start = combine((i) => (toCamera[i]! - b[i]!) * away);
  /** The straight ray through the event at s, with this change of r. */
  const straight = (s: number, slope: number): SpacetimeRay => {
    const bent = r(s) - slope * s;
    return {
      t: t + (start[0] + b[0] * bent) / settings.speedOfLight,
      x: [
        position[0] + start[1] + b[1] * bent,
        position[1] + start[2] + b[2] * bent,
        position[2] + start[3] + b[3] * bent,
      ],
      dt: along[0] + b[0] * slope,
      dx: [along[1] + b[1] * slope, along[2] + b[2] * slope, along[3] + b[3] * slope],
    };
  };
  const isStraight = Math.hypot(...b) < 1e-12 * Math.hypot(...along);
  const knots = isStraight ? [0, Number.POSITIVE_INFINITY] : knotsOf(middle, closest, away, TANGENTS[place]);
  return {
    knots,
    chord(k) {
      const [from, to] = [knots[k]!, knots[k + 1]!];
      return straight(from, to === Number.POSITIVE_INFINITY ? 1 : (r(to) - r(from)) / (to - from));
    },
    tangent: (s) => straight(s, r(s) > 0 ? (s - middle) / r(s) : 1),
    lightFrom(s) {
      const P = addScaled(vantage, n, s);
      const [dt, ...dx] = eventIn(normalize(P, n));
      return { t, x: position, dt, dx };
    },
  };
}

/** Those from the camera on, of a line that is `closest` to the eye at s = `middle`; one that leads through it is straight before and behind it. */
function knotsOf(middle: number, closest: number, away: number, tangents: readonly number[]): readonly number[] {
  const bends = closest > 1e-9 * away ? tangents.map((tangent) => middle + closest * tangent) : [middle];
  return [0, ...bends.filter((s) => s > 0), Number.POSITIVE_INFINITY];
}

const combine = (component: (i: number) => number): FourVector => [
  component(0),
  component(1),
  component(2),
  component(3),
];

function cotangents(angles: readonly number[]): readonly number[] {
  return angles.map((angle) => 1 / Math.tan(angle));
}
