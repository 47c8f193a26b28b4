import type { OpenFilmFrames } from '../../formats/film/filmFrames.ts';
import { FilmPanorama } from '../../formats/film/filmPanorama.ts';
import { type DomeMeans, domeMaps } from '../../render/lights/sky/domeMaps.ts';
import type { FilmedDome } from '../../scene/film/seenFilm.ts';
import type { FilmReader, SeenDome } from './filmReader.ts';

/** Reads a film in this thread. `means`: see `OpenFilmReader`; `cacheBytes`: see `FilmPanorama`. */
export function makeFilmReader(
  dome: FilmedDome,
  means: DomeMeans | undefined,
  openFrames: OpenFilmFrames,
  cacheBytes?: number,
): FilmReader {
  const panorama = new FilmPanorama(dome, openFrames, cacheBytes);
  let last: SeenDome | undefined;
  return {
    async seenAt(event) {
      const picture = await panorama.seenAt(event);
      if (last?.picture !== picture) last = { picture, ...(means && { maps: domeMaps(picture, means) }) };
      return last;
    },
    close: () => panorama.close(),
  };
}
