import { SceneRenderer } from '../../../src/render/renderer.ts';
import { type FilmDomeCase, type FilmDomePictures, filmDomePictures, SIZE } from './filmDomeScenes.ts';

declare global {
  interface Window {
    /** Pictures of a film's dome on WebGL2. */
    filmDomePictures: (given: FilmDomeCase) => Promise<FilmDomePictures>;
  }
}

let opened: Promise<SceneRenderer> | undefined;

window.filmDomePictures = async (given) => {
  opened ??= SceneRenderer.create({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const renderer = await opened;
  renderer.setSize(SIZE, SIZE);
  return filmDomePictures(renderer, given);
};
