import type { FlightControls } from '../../flight/controls.ts';
import type { HeldCamera } from '../../flight/hold.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';

/** Walks about in what is held still; loaded when something is held for the first time. */
export interface HeldWalk {
  readonly camera: HeldCamera;
  readonly walk: (controls: FlightControls, dt: number, picture: PictureSpec) => void;
  /** Back to the observer's eye. */
  readonly end: () => void;
}
