import { roundStep } from '../../diagrams/roundStep.ts';
import { distance, type Vec3 } from '../../math/vec3.ts';
import { exposureForMetering } from '../../nodes/pictures/metering.ts';
import { sceneBounds } from '../../scene/bounds/sceneBounds.ts';
import type { FrameGraph } from '../../scene/frameGraph/frameGraph.ts';
import type { Scene } from '../../scene/types.ts';
import type { LightMeterReadings } from '../../scene/view/metering.ts';
import { type Orbit, type OutsideCamera, orbitCamera } from '../../scene/view/outsideCamera.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';

/** What the outside view shows: the world as it is now, or each point where it was when its light left. */
export type OutsideShows = 'now' | 'seen';

/** How the outside view looks at the world. */
export interface OutsideLook extends Pick<Orbit, 'distance' | 'azimuth' | 'elevation'> {
  readonly shows: OutsideShows;
  /** Contours of the other of the two. */
  readonly contours: boolean;
}

const FOV_Y = 0.8;
/** First distance: this part of the scene's diagonal, or the way of light in so many seconds, if that is less. */
const FIRST_PART = 0.5;
const FIRST_SECONDS = 3;
const USUAL_DISTANCE = 20;
/** Least and greatest elevation [rad]: it does not go over the top. */
export const ELEVATIONS = [-1.5, 1.5] as const;
const RINGS_TO_CAMERA = 4;
const SIZE_OF_OBSERVER = 5;

/** How it looks at first: from behind to the right, from above. c [m/s]. */
export function firstLook(scene: Scene, c: number): OutsideLook {
  const box = sceneBounds(scene, scene.startTime, c);
  const diagonal = box ? distance(box.max, box.min) : 0;
  const away = Math.min(FIRST_PART * diagonal, FIRST_SECONDS * c);
  const look = { azimuth: 0.5, elevation: 0.55, shows: 'now', contours: true } as const;
  return { ...look, distance: away > 0 ? away : USUAL_DISTANCE };
}

/** Time that light takes from one ring to the next [s]: 1, 2 or 5 times a power of ten, so that about four rings are nearer to the observer than the camera. c [m/s]. */
export const ringSeconds = (distance: number, c: number): number => roundStep(distance / c, RINGS_TO_CAMERA);

/** Settings of the outside view beside a picture. `exposure` [EV]: metered. */
export function outsideSettings(
  { frameGraph: _, falseColors: __, ...picture }: RenderSettings,
  look: OutsideLook,
  up: Vec3,
  exposure: number,
): RenderSettings {
  const outside: OutsideCamera = orbitCamera({ ...look, fovY: FOV_Y }, up);
  const seen = look.shows === 'seen';
  const seconds = ringSeconds(look.distance, picture.speedOfLight);
  const marks: FrameGraph = {
    extraBuffers: [],
    passes: [
      { kind: 'light', buffer: 0, shadows: true, occlusion: false },
      { kind: 'tone', tone: 'neutral', exposure, metering: 'manual', image: 0 },
      { kind: 'effect', effect: 'observer-marks', args: [seconds, 0.8, SIZE_OF_OBSERVER], image: 1, buffer: 0 },
    ],
  };
  return {
    ...picture,
    ...{ view: seen ? 'light-cone' : 'galilean', lightDelay: true, aberration: false, dopplerMix: 0, beaming: 0 },
    ...{ ghost: look.contours ? (seen ? 'galilean' : 'light-cone') : 'none', pastFuture: false, grid: false },
    ...{ occlusionRadius: 0, tone: 'linear', exposure: 0, frameGraph: marks, outside },
  };
}

/** Its exposure [EV], of its own light. */
export const outsideExposure = (
  readings: LightMeterReadings,
  view: ViewPoint,
  settings: RenderSettings,
  size: PictureSize,
): number => exposureForMetering('automatic', readings, [view], settings, size);

/** The look after turning by angles to the right and up [rad], and coming nearer by a factor. */
export const turned = (look: OutsideLook, right: number, up: number, nearer = 1): OutsideLook => ({
  ...look,
  azimuth: look.azimuth + right,
  elevation: Math.min(Math.max(look.elevation + up, ELEVATIONS[0]), ELEVATIONS[1]),
  distance: Math.min(Math.max(look.distance / nearer, 1e-3), 1e12),
});
