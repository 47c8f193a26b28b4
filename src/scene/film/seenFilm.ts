import { dot, length, scale, type Vec3 } from '../../math/vec3.ts';
import { directionFromLatLong, domeAxes } from '../lights/latLong.ts';
import type { DomeLight, DomePicture } from '../lights/light.ts';
import { isDomeLight } from '../lights/lightKinds.ts';
import type { Scene } from '../types.ts';
import type { PictureSize } from '../view/pictureSize.ts';
import type { ViewPoint } from '../view/view.ts';
import { hypersurfaceChoice, type ViewSettings } from '../views/views.ts';
import { type DomeFilm, filmDuration, frameAt } from './film.ts';

/** A dome with a film. */
export type FilmedDome = DomeLight & Required<Pick<DomeLight, 'film' | 'texture'>>;

const isFilmed = (dome: DomeLight | undefined): dome is FilmedDome =>
  dome?.film !== undefined && dome.texture !== undefined;

/**
 * The scene's dome if it is filmed.
 * @example
 * filmedDome(makeScene({ name: 'by day' })); // undefined
 */
export function filmedDome({ lights }: Pick<Scene, 'lights'>): FilmedDome | undefined {
  const dome = lights.find(isDomeLight);
  return isFilmed(dome) ? dome : undefined;
}

/** World time that the film of a dome takes [s]; none without a film, nor of one that repeats without an end. */
export function filmTimeOf(scene: Pick<Scene, 'lights'>): Partial<Pick<Scene, 'startTime' | 'endTime'>> {
  const film = filmedDome(scene)?.film;
  return film && !film.repeats ? { startTime: film.start, endTime: film.start + filmDuration(film) } : {};
}

/** The scene with a picture on its dome. */
export const withDomePicture = (scene: Scene, texture: DomePicture): Scene =>
  withDome(scene, (dome) => ({ ...dome, texture }));

/** The scene without its film, of which the first frame stays. */
export const withoutFilm = (scene: Scene): Scene =>
  filmedDome(scene) ? withDome(scene, ({ film: _, ...dome }) => dome) : scene;

function withDome(scene: Scene, change: (dome: DomeLight) => DomeLight): Scene {
  const first = scene.lights.findIndex(isDomeLight);
  const lights = scene.lights.map((light, i) => (i === first && isDomeLight(light) ? change(light) : light));
  return { ...scene, lights };
}

/** An event at which a film is seen, and the speed of light. */
export interface FilmEvent {
  /** World time [s]. */
  readonly t: number;
  /** World frame [m]. */
  readonly position: Vec3;
  /** [m/s]; ∞: light takes no time. */
  readonly speedOfLight: number;
}

/** Where an observer sees films. Of pictures of one instant of the world, and of the Galilean view, light takes no time. */
export function filmEventOf(
  { t, position }: Pick<ViewPoint, 't' | 'position'>,
  settings: ViewSettings & { readonly speedOfLight: number },
): FilmEvent {
  const isInstant = hypersurfaceChoice(settings).hypersurface === 'now';
  return { t, position, speedOfLight: isInstant ? Number.POSITIVE_INFINITY : settings.speedOfLight };
}

/** The one frame that an event sees in all directions; undefined if it may see several. */
export function onlyFrameSeen(film: DomeFilm, { t, position, speedOfLight }: FilmEvent): number | undefined {
  const delay = length(position) / speedOfLight;
  const frame = frameAt(film, t - delay);
  if (frame !== frameAt(film, t + delay)) return undefined;
  const { times, end } = film.track;
  // One that repeats might come round to the same frame.
  const others = end - times[0]! - ((times[frame + 1] ?? end) - times[frame]!);
  return film.repeats && 2 * delay * film.speed >= others ? undefined : frame;
}

/** Which texels of a dome's picture show which frame. */
export interface SeenFrames {
  /** The frames, rising. */
  readonly frames: readonly number[];
  /** Texels by frame, those of `frames[i]` from `first[i]` up to `first[i + 1]`. */
  readonly texels: Uint32Array;
  readonly first: Uint32Array;
}

/** The frames that an event sees, by the texels of a picture by latitude and longitude: τ = t + n·x/c. */
export function framesSeen(dome: FilmedDome, event: FilmEvent, { width, height }: PictureSize): SeenFrames {
  const { t, position, speedOfLight } = event;
  const [right, up, ahead] = domeAxes(dome);
  const delays = scale(position, 1 / speedOfLight);
  const own: Vec3 = [dot(right, delays), dot(up, delays), dot(ahead, delays)];
  const frameOf = new Uint32Array(width * height);
  const counts = new Map<number, number>();
  const columns = Array.from({ length: width }, (_, x) => directionFromLatLong((x + 0.5) / width, 0.5));
  for (let y = 0, i = 0; y < height; y++) {
    const angle = (Math.PI * (y + 0.5)) / height;
    const [level, above] = [Math.sin(angle), Math.cos(angle) * own[1]];
    for (let x = 0; x < width; x++, i++) {
      const column = columns[x]!;
      const frame = frameAt(dome.film, t + above + level * (column[0] * own[0] + column[2] * own[2]));
      frameOf[i] = frame;
      counts.set(frame, (counts.get(frame) ?? 0) + 1);
    }
  }
  const frames = [...counts.keys()].sort((a, b) => a - b);
  const first = new Uint32Array(frames.length + 1);
  frames.forEach((frame, i) => {
    first[i + 1] = first[i]! + counts.get(frame)!;
  });
  const next = new Map(frames.map((frame, i) => [frame, first[i]!]));
  const texels = new Uint32Array(width * height);
  for (let i = 0; i < frameOf.length; i++) {
    const at = next.get(frameOf[i]!)!;
    texels[at] = i;
    next.set(frameOf[i]!, at + 1);
  }
  return { frames, texels, first };
}
