import type { Vec3 } from '../../math/vec3.ts';
import type { FourVector } from '../../physics/lorentz/fourVector.ts';
import type { PlacementName } from '../../physics/optics/placement.ts';
import type { HypersurfaceName } from '../../physics/worldLines/hypersurface.ts';
import type { ObserverEvent } from '../../physics/worldLines/kinds/worldLineKind.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import type { Words } from '../settings/setting.ts';

export interface ProbeObserver extends ObserverEvent {
  /** γβ, world frame. */
  readonly u: Vec3;
}

/** The event of a world line that an observer is shown. */
export interface ProbedEvent {
  /** World time of the event that is shown [s]: emission, or the event of the observer's (or the world's) now. */
  readonly time: number;
  /** Of that event, world frame [m]. */
  readonly position: Vec3;
  /** World frame, units of c. */
  readonly velocity: Vec3;
  /** From the observer, in his frame (world axes carried by the pure boost) [m]. */
  readonly apparent: Vec3;
  /** D = ν_observed/ν_emitted; 1 in the views that are not of light. */
  readonly doppler: number;
}

/** Effects that a view of light can leave out. */
export interface ViewToggles {
  readonly lightDelay: boolean;
  readonly aberration: boolean;
}

/** What a picture shows of spacetime. */
export interface ViewRecord {
  readonly title: Words;
  /** Of `--view`. */
  readonly summary: string;
  /** A part of the sentence that tells what views there are. */
  readonly help: Words;
  /** Whether it shows light: then the observer's and the sources' motion shift and beam it. */
  readonly luminous: boolean;
  /** Whether the observer's velocity changes anything. */
  readonly relativistic: boolean;
  hypersurface(toggles: ViewToggles): HypersurfaceName;
  placement(toggles: ViewToggles): PlacementName;
  /** (c dt, dx) per metre in the observer's frame, world frame: along it lies what is seen in the direction n′ (unit). u: the observer's γβ. */
  rayToward(n: Vec3, u: Vec3, toggles: ViewToggles): FourVector;
  /** With no effect left out; undefined where no light ever comes (behind a horizon). c [m/s]. */
  probe(line: WorldLine, observer: ProbeObserver, c: number): ProbedEvent | undefined;
}
