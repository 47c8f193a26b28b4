import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { type Inspection, inspectEvent } from '../../scene/inspection/inspectEvent.ts';
import { type SurfaceEvent, surfaceLine } from '../../scene/inspection/surfaceLine.ts';
import type { Scene, SceneObject } from '../../scene/types.ts';
import type { ProbeObserver } from '../../scene/views/viewRecord.ts';
import type { PicturePosition } from '../viewport/legend/legendState.ts';
import type { PreviewContext } from '../viewport/viewportRenderer.ts';

/** Pause after an inspection, as a multiple of its duration on this thread: large deforming meshes must not slow down the picture. */
const PAUSE_FACTOR = 4;

/** The displayed picture at the moment of a reading. */
export type ReadPicture = Pick<PreviewContext, 'renderer' | 'picture' | 'view'>;

/** A point of a surface in a picture. */
export interface PickedPoint {
  readonly scene: Scene;
  readonly object: SceneObject;
  readonly event: SurfaceEvent;
  readonly observer: ProbeObserver;
  /** [m/s] */
  readonly c: number;
}

/** What is at the aim: a surface with what is known of it, or nothing but sky. */
export interface AimReading {
  readonly place: PicturePosition;
  /** Prim path; undefined for the sky. */
  readonly path: string | undefined;
  readonly inspection: Inspection | undefined;
  /** The observer's world time [s]. */
  readonly now: number;
}

/** The point of a surface at a place of the displayed picture; undefined if there is none. */
export async function pickPoint(
  { renderer, picture, view }: ReadPicture,
  [x, y]: PicturePosition,
): Promise<PickedPoint | undefined> {
  const { width, height } = renderer;
  const pixel = (share: number, size: number) => Math.min(size - 1, Math.max(0, Math.floor(share * size)));
  const found = await renderer.pick?.(pixel(x, width), pixel(y, height));
  const surface = found?.surface;
  const object = surface && picture.scene.objects[surface.objectId - 1];
  if (!object) return undefined;
  const { emissionTime: time, position, velocity } = surface;
  const { viewPoint: observer, settings } = view;
  return { scene: picture.scene, object, event: { time, position, velocity }, observer, c: settings.speedOfLight };
}

/** The world line of a picked point; undefined where it is not known. */
export const lineOf = ({ object, event, c }: PickedPoint): WorldLine | undefined => surfaceLine(object, event, c);

/** Reads what is at the aim again when the aim or the picture changes, one reading at a time. */
export class PointReader {
  private readonly report: (reading: AimReading) => void;
  private known: readonly [place: PicturePosition, view: object] | undefined;
  private busy = false;
  private next = 0;
  private stopped = false;

  constructor(report: (reading: AimReading) => void) {
    this.report = report;
  }

  /** `now` [ms]. Returns the running read, if any. */
  update(picture: ReadPicture, place: PicturePosition, now: number): Promise<void> | undefined {
    const [known, view] = this.known ?? [];
    const isKnown = view === picture.view && known?.[0] === place[0] && known[1] === place[1];
    if (isKnown || this.busy || now < this.next) return undefined;
    this.known = [place, picture.view];
    return this.read(picture, place);
  }

  stop(): void {
    this.stopped = true;
  }

  private async read(picture: ReadPicture, place: PicturePosition): Promise<void> {
    this.busy = true;
    try {
      const point = await pickPoint(picture, place);
      const start = performance.now();
      const inspection = point && inspectEvent(point.object, point.event, point.observer, point.c);
      const end = performance.now();
      this.next = end + PAUSE_FACTOR * (end - start);
      if (!this.stopped) this.report({ place, path: point?.object.path, inspection, now: picture.view.viewPoint.t });
    } finally {
      this.busy = false;
    }
  }
}
