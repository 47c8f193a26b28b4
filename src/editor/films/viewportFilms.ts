import { type FilmReader, meansFor, type SeenDome } from '../../pipelines/films/filmReader.ts';
import type { InteractiveRenderer } from '../../pipelines/interactiveRenderer.ts';
import { type FilmEvent, filmEventOf, filmedDome } from '../../scene/film/seenFilm.ts';
import type { Scene } from '../../scene/types.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { openFilmInWorker } from './openFilmInWorker.ts';

type Renderer = Pick<InteractiveRenderer, 'showDome'>;

interface FollowedFilm {
  readonly index: number;
  readonly reader: FilmReader;
  wanted: FilmEvent | undefined;
  /** The event of the last picture. */
  shown: string | undefined;
  seen: SeenDome | undefined;
  busy: boolean;
}

export interface ViewportFilmsCallbacks {
  /** There is another picture: draw again. */
  readonly onPicture: () => void;
  /** A film cannot be decoded; its last picture stays. */
  readonly onError: (error: Error) => void;
}

/**
 * Films of the scenes in the viewport. They follow the observer: the picture of the latest event is made, those between are left out, and meanwhile the last one is shown, so that flying
 * does not wait.
 */
export class ViewportFilms {
  private readonly renderer: Renderer;
  private readonly callbacks: ViewportFilmsCallbacks;
  private films: readonly FollowedFilm[] = [];

  constructor(renderer: Renderer, callbacks: ViewportFilmsCallbacks) {
    this.renderer = renderer;
    this.callbacks = callbacks;
  }

  /** The scenes that the renderer has now, without pictures of their films. */
  setScenes(scenes: readonly Scene[]): void {
    this.close();
    this.films = scenes.flatMap((scene, index) => {
      const dome = filmedDome(scene);
      if (!dome) return [];
      const reader = openFilmInWorker(dome, meansFor(scene, 'coarse'));
      return [{ index, reader, wanted: undefined, shown: undefined, seen: undefined, busy: false }];
    });
  }

  /** Makes what an observer sees. */
  follow(viewPoint: ViewPoint, settings: RenderSettings): void {
    const event = filmEventOf(viewPoint, settings);
    for (const film of this.films) {
      film.wanted = event;
      if (!film.busy) void this.update(film);
    }
  }

  /** Whether the pictures are those of the last event. */
  get isSettled(): boolean {
    return this.films.every(({ wanted, shown, busy }) => !busy && (!wanted || keyOf(wanted) === shown));
  }

  /** Shows the same in a renderer of the first scene beside. */
  showIn(renderer: Renderer): void {
    for (const { index, seen } of this.films) if (index === 0 && seen?.maps) renderer.showDome?.(seen.maps);
  }

  close(): void {
    for (const { reader } of this.films) reader.close();
    this.films = [];
  }

  private async update(film: FollowedFilm): Promise<void> {
    film.busy = true;
    try {
      while (film.wanted && keyOf(film.wanted) !== film.shown) {
        const event = film.wanted;
        const seen = await film.reader.seenAt(event);
        if (!this.films.includes(film)) return;
        film.shown = keyOf(event);
        if (seen !== film.seen && seen.maps) {
          this.renderer.showDome?.(seen.maps, film.index);
          this.callbacks.onPicture();
        }
        film.seen = seen;
      }
    } catch (error) {
      if (!this.films.includes(film)) return;
      this.films = this.films.filter((each) => each !== film);
      film.reader.close();
      this.callbacks.onError(error as Error);
    } finally {
      film.busy = false;
    }
  }
}

const keyOf = ({ t, position, speedOfLight }: FilmEvent): string => [t, ...position, speedOfLight].join(' ');
