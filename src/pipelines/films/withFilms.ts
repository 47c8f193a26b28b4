import { filmEventOf, filmedDome, withoutFilm } from '../../scene/film/seenFilm.ts';
import type { Scene } from '../../scene/types.ts';
import type { PictureViews } from '../../scene/view/pictureViews.ts';
import { extraBuffers, type RenderSettings } from '../../scene/view/view.ts';
import type { PictureScenes, PipelineSession } from '../pipeline.ts';
import { meansFor, type OpenFilmReader, type SeenDome } from './filmReader.ts';

/** The scenes as pipelines get them: their domes show the first frame until they are told. */
export const withoutFilms = ([first, ...others]: PictureScenes): PictureScenes => [
  withoutFilm(first),
  ...others.map(withoutFilm),
];

/** A session, opened with `withoutFilms`, whose pictures show the films as their first view's event sees them. */
export function withFilms(session: PipelineSession, scenes: PictureScenes, open: OpenFilmReader): PipelineSession {
  const films = scenes.flatMap((scene, index) => filmOf(scene, index, session, open) ?? []);
  if (films.length === 0) return session;
  const show = async (views: PictureViews, settings: RenderSettings): Promise<void> => {
    for (const film of films) await film.show(views, settings);
  };
  const { measureLight } = session;
  return {
    ...session,
    render: async (request, onPart) => {
      await show(request.views, request.settings);
      return session.render(request, onPart);
    },
    ...(measureLight && {
      measureLight: async (views, settings) => {
        await show(views, settings);
        return measureLight(views, settings);
      },
    }),
    close: async () => {
      for (const film of films) film.close();
      await session.close();
    },
  };
}

function filmOf(scene: Scene, index: number, { showDome }: PipelineSession, open: OpenFilmReader) {
  const dome = filmedDome(scene);
  if (!dome || !showDome) return undefined;
  const reader = open(dome, showDome.needsMaps ? meansFor(scene, 'fine') : undefined);
  let shown: SeenDome | undefined;
  return {
    async show([view]: PictureViews, settings: RenderSettings): Promise<void> {
      const own = index === 0 ? undefined : extraBuffers(settings).find((buffer) => buffer.scene === index);
      const seen = await reader.seenAt(filmEventOf(view, { ...settings, ...own }));
      if (seen !== shown) await showDome.show(index, seen);
      shown = seen;
    },
    close: () => reader.close(),
  };
}
