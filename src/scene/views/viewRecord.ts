import type { Vec3 } from '../../math/vec3.ts';
import type { LocalizedText, Message } from '../../messages/message.ts';
import type { FourVector } from '../../physics/lorentz/fourVector.ts';
import type { PlacementName } from '../../physics/optics/placement.ts';
import type { HypersurfaceName } from '../../physics/worldLines/hypersurface.ts';
import type { ObserverEvent } from '../../physics/worldLines/kinds/worldLineKind.ts';
import type { NewtonOptions } from '../../physics/worldLines/lightCone.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';

/** An observer's event with its velocity. */
export interface ProbeObserver extends ObserverEvent {
  /** γβ, world frame. */
  readonly u: Vec3;
}

/** The event of a world line that a view shows to an observer. */
export interface ProbedEvent {
  /** World time of the event [s]: of emission, or simultaneous in the observer's or the world's frame. */
  readonly time: number;
  /** Position of the event, world frame [m]. */
  readonly position: Vec3;
  /** World frame, units of c. */
  readonly velocity: Vec3;
  /** Relative to the observer, in his frame (world axes carried by the pure boost) [m]. */
  readonly apparent: Vec3;
  /** D = ν_observed/ν_emitted; 1 in views that are not luminous. */
  readonly doppler: number;
}

/** How the event of a view is found. */
export interface ProbeOptions {
  /** Where these steps of the Newton solver, for comparison, end instead; a view that needs no search ignores it. */
  readonly newton?: NewtonOptions | undefined;
  /** λ of `slice-to-cone`, 0 … 1, by default that of its setting. */
  readonly coneSlope?: number;
}

/** Settings of views. */
export interface ViewToggles {
  /** Effects of light that `light-cone` can omit. */
  readonly lightDelay: boolean;
  readonly aberration: boolean;
  /** λ of `slice-to-cone`, 0 … 1. */
  readonly coneSlope: number;
}

/** A view of spacetime: which events a picture shows, and where. */
export interface ViewRecord {
  readonly title: LocalizedText;
  /** Value of `--view`. */
  readonly summary: LocalizedText;
  /** Part of the sentence that lists the views. */
  readonly help: Message;
  /** Whether it shows light, with Doppler shift and beaming. */
  luminous(toggles: ViewToggles): boolean;
  /** Whether it depends on the observer's velocity. */
  readonly relativistic: boolean;
  hypersurface(toggles: ViewToggles): HypersurfaceName;
  placement(toggles: ViewToggles): PlacementName;
  /** (c dt, dx) per metre of the observer's frame, in the world frame, of the ray on which the events in the unit direction n′ lie. u: the observer's γβ. */
  rayToward(n: Vec3, u: Vec3, toggles: ViewToggles): FourVector;
  /** The event without omitting any effect; undefined if its light never arrives (beyond a horizon). c [m/s]. */
  probe(line: WorldLine, observer: ProbeObserver, c: number, options: ProbeOptions): ProbedEvent | undefined;
}
