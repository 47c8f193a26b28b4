import type { DomeMaps, DomeMeans } from '../../render/lights/sky/domeMaps.ts';
import type { FilmEvent, FilmedDome } from '../../scene/film/seenFilm.ts';
import { isStatic } from '../../scene/motion/motion.ts';
import type { DomePicture, Scene } from '../../scene/types.ts';

/** What is seen of a dome's film. */
export interface SeenDome {
  readonly picture: DomePicture;
  /** What the rasterizer shows of it; absent if it was not asked for. */
  readonly maps?: DomeMaps;
}

/** Makes what events see of a film. */
export interface FilmReader {
  /** The same object for events that see the same. One event at a time. Rejects with a MessageError where a frame cannot be decoded. */
  seenAt(event: FilmEvent): Promise<SeenDome>;
  close(): void;
}

/** `means`: how those of the maps are made; without it there are no maps. */
export type OpenFilmReader = (dome: FilmedDome, means?: DomeMeans) => FilmReader;

/** The means that the rasterizer needs for a scene: only what moves is lit by them. */
export const meansFor = ({ objects }: Scene, detail: 'coarse' | 'fine'): DomeMeans =>
  objects.some(({ motion }) => !isStatic(motion)) ? detail : 'none';
