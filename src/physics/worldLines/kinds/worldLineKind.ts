import type { Vec3 } from '../../../math/vec3.ts';
import type { RetardedEvent } from '../emission.ts';
import type { SampledLine } from '../samples.ts';
import type { SimultaneousEvent } from '../slice.ts';

/** The observer's event, in the world frame. */
export interface ObserverEvent {
  /** World time [s]. */
  readonly t: number;
  /** [m] */
  readonly position: Vec3;
}

/** A world line of constant velocity: x = position + velocity t. */
export interface InertialLine {
  /** At t = 0 [m]. */
  readonly position: Vec3;
  /** [m/s] */
  readonly velocity: Vec3;
}

/** All that depends on the kind of a world line. World frame; t: world time [s]; c [m/s]. */
export interface WorldLineKind<W> {
  /** x(t) [m]. */
  positionAt(w: W, t: number, c: number): Vec3;
  /** dx/dt [m/s]. At a sample, the velocity of the piece that starts there. */
  velocityAt(w: W, t: number, c: number): Vec3;
  /** γβ, where it is known to more digits than the velocity gives. */
  properVelocityAt?(w: W, t: number, c: number): Vec3;
  /** Its event on the past light cone of the observer's event; undefined if no light of it reaches that event. docs/physics.md §4. */
  pastLightCone(w: W, observer: ObserverEvent, c: number): RetardedEvent | undefined;
  /** Its event with Δt′ = 0 for an observer with proper velocity u. docs/physics.md §5. */
  simultaneitySlice(w: W, observer: ObserverEvent, u: Vec3, c: number): SimultaneousEvent;
  /** The line in this form where its velocity is constant, else undefined. */
  asInertial(w: W): InertialLine | undefined;
  /** Its samples where it is straight between them, else undefined. */
  asPolyline(w: W): SampledLine | undefined;
  /** Where it is at its reference time [m]: t = 0, the turning point of hyperbolic motion, or the first sample. */
  referencePosition(w: W): Vec3;
  /** Points [m] whose convex hull, with the two ends, contains the path between two times. */
  hullPoints(w: W, from: number, to: number, c: number): readonly Vec3[];
}
