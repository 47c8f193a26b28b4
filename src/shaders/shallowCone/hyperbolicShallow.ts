import { abs, Break, float, If, int, Loop, max, select, sqrt } from 'three/tsl';
import type { Float, HyperbolicVertexEvent, Vec3, Vec4 } from '../types.ts';
import { hyperbolaVertex } from '../worldLines/hyperbola.ts';
import { hyperbolaEvent, MIN_RAPIDITY_FACTOR } from '../worldLines/hyperbolaEvent.ts';
import { momentCrossing } from '../worldLines/momentCrossing.ts';
import { shallowAnchor, shallowRate, shallowTime } from './linearShallow.ts';
import type { ShallowObserver } from './shallowObserver.ts';

/** Newton's iteration ends at a step below this fraction of the acceleration length or of the parameter, or after `MAX_STEPS`. */
const RELATIVE_STEP = 2e-7;
const MAX_STEPS = 40;

/**
 * The event on the cone ct′ = −λr′ of a vertex in hyperbolic motion: Newton's steps in the parameter η of its hyperbola (hyperbola.ts) from the slice back,
 * replaced by bisection of the rapidity where a step would leave the bracket between the slice and the infinite past. There always is one event, for λ < 1.
 * `anchor` is an event of the cone; the rest as in hyperbolicEmission. docs/physics.md §5.8.
 */
export function hyperbolicShallow(
  anchor: Vec4,
  motion: Vec4,
  w: Float,
  bornRigid: Float,
  offset: Vec3,
  observer: ShallowObserver,
): HyperbolicVertexEvent {
  const { u, gamma, coneSlope } = observer;
  const from = shallowAnchor(anchor, observer);
  const vertex = hyperbolaVertex(motion, w, bornRigid, offset);
  const a = vertex.acceleration;

  // The slice is λr′ later than the anchor.
  const high = momentCrossing(vertex, motion, w, u, gamma, coneSlope.mul(from.w)).toVar();
  const highGrowth = max(a.mul(high).add(1), w.reciprocal().mul(MIN_RAPIDITY_FACTOR)).toVar();
  const lowGrowth = w.reciprocal().mul(MIN_RAPIDITY_FACTOR).toVar();
  const eta = select(high.lessThan(0), high, float(0)).toVar();
  Loop({ start: int(0), end: int(MAX_STEPS), type: 'int', condition: '<' }, () => {
    const { x, s, velocity } = hyperbolaEvent(motion, w, vertex, eta);
    const place = x.toVar();
    const motionThere = velocity.toVar();
    const missed = s.sub(shallowTime(from, place, observer)).toVar();
    const growth = max(a.mul(eta).add(1), 1e-20).toVar();
    If(missed.lessThanEqual(0), () => {
      lowGrowth.assign(max(lowGrowth, growth));
    }).Else(() => {
      highGrowth.assign(growth);
    });
    // ds/dη = (w + 1/(w growth²))/2
    const pace = w.add(w.mul(growth).mul(growth).reciprocal()).mul(0.5);
    const rate = shallowRate(anchor.xyz.add(place), motionThere, observer);
    const newton = eta.sub(missed.div(pace.mul(rate))).toVar();
    const newGrowth = a.mul(newton).add(1);
    const inside = newGrowth.greaterThanEqual(lowGrowth).and(newGrowth.lessThanEqual(highGrowth));
    const middle = sqrt(lowGrowth.mul(highGrowth)).sub(1).div(max(a, 1e-20));
    const next = select(inside, newton, middle).toVar();
    const step = abs(next.sub(eta)).toVar();
    eta.assign(next);
    If(step.lessThanEqual(abs(next).mul(RELATIVE_STEP)), () => {
      Break();
    });
  });
  const { x, ...event } = hyperbolaEvent(motion, w, vertex, eta);
  return { dx: anchor.xyz.add(x), ...event };
}
