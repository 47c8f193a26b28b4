import { dot, int, length, mix, normalize, select, vec3, vec4 } from 'three/tsl';
import type { RigidMotion } from '../../scene/types.ts';
import { hyperbolaEmission } from '../../shaders/emission/hyperbolicEmission.ts';
import { linearEmission } from '../../shaders/emission/linearEmission.ts';
import { polylineEmission } from '../../shaders/emission/polylineEmission.ts';
import type { Bool, Float, Int, Vec3, Vec4 } from '../../shaders/types.ts';
import { pieceAt } from '../geometry/vertexSamples.ts';
import type { Texels } from '../gpu/floatTable.ts';

/** How a light moves, relative to one event of it, its anchor (lightTable.ts). */
export interface LightMotion {
  readonly kind: RigidMotion['kind'];
  /** Absent where it rests. */
  readonly moving?: Moving;
  readonly samples: Texels;
}

interface Moving {
  /** Uniform: (v, 1 − v²); hyperbolic: (axis, a/c² [1/m]); sampled: (first texel of its samples, count, 0, 0). */
  readonly motion: Vec4;
  /** e^φ of hyperbolic motion at the anchor. */
  readonly w: Float;
}

/** The event at which a light sent out the light that meets a surface. */
export interface LightEmissionEvent {
  /** Surface → light [m]. */
  readonly offset: Vec3;
  /** After the anchor's [m of light]; absent where nobody asks. */
  readonly elapsed?: Float;
  /** (v, 1 − v²); absent of what rests. */
  readonly velocity?: Vec4;
  /** How its axes stand; absent where they always stand as in the table. */
  readonly orientation?: Vec4;
  /** Absent where there always is one. */
  readonly exists?: Bool;
}

/**
 * `d`: surface → the light's anchor [m]; `late` [m of light]: so much later than on the surface's past light cone the anchor is; 0: it is on it, or
 * shines at once. The functions that look for a vertex on the observer's light cone look here for the light on the surface's.
 */
export function lightEmissionEvent(
  { kind, moving, samples }: LightMotion,
  d: Vec3,
  lag: Float | undefined,
): LightEmissionEvent {
  if (!moving || !lag) return { offset: d, ...(lag && { elapsed: lag.negate() }) };
  const anchor = vec4(d, length(d)).toVar();
  switch (kind) {
    case 'hyperbolic':
      return hyperbolicEvent(moving, anchor, lag);
    case 'sampled':
      return sampledEvent(moving, samples, anchor, lag);
    default: {
      const { motion: velocity } = moving;
      const elapsed = linearEmission(anchor, velocity, vec4(0, 0, 0, lag)).toVar();
      return { offset: d.add(velocity.xyz.mul(elapsed)).toVar(), elapsed, velocity };
    }
  }
}

function hyperbolicEvent({ motion, w }: Moving, anchor: Vec4, late: Float): LightEmissionEvent {
  // A place that is `late` after the light cone is at (late/w, late·w) in the hyperbola's light-cone coordinates.
  const vertex = { across: vec3(0), plus: late.div(w).toVar(), minus: late.mul(w).toVar(), acceleration: motion.w };
  const { dx, s, velocity, exists } = hyperbolaEmission(anchor, motion, w, vertex);
  return { offset: dx.toVar(), elapsed: s.sub(late), velocity: velocity.toVar(), exists };
}

function sampledEvent({ motion }: Moving, table: Texels, anchor: Vec4, late: Float): LightEmissionEvent {
  const [first, count] = [int(motion.x).toVar(), int(motion.y).toVar()];
  const texel = (index: Int, k: number): Vec4 => table.texel(first.add(index.mul(int(2))).add(int(k))).toVar();
  const { dx, s, velocity } = polylineEmission(anchor, (i) => texel(i, 0).add(vec4(0, 0, 0, late)), count);
  const elapsed = s.sub(late).toVar();
  const { index, fraction } = pieceAt({ count, time: (i) => texel(i, 0).w }, elapsed);
  const [a, b] = [texel(index, 1), texel(index.add(int(1)), 1)];
  const orientation = normalize(mix(a, select(dot(a, b).lessThan(0), b.negate(), b), fraction)).toVar();
  return { offset: dx.toVar(), elapsed, velocity: velocity.toVar(), orientation };
}
