import type { Evaluation } from '../graph/evaluate.ts';
import type { RenderSettings } from '../render/settings.ts';
import type { Picture } from './define.ts';

/** The picture that an evaluation of the output node gave; undefined where it failed. */
export const pictureOf = ({ target }: Evaluation): Picture | undefined =>
  target.status === 'done' ? (target.outputs.image as Picture) : undefined;

/** What the renderer needs of a picture. */
export const renderSettings = (picture: Picture): RenderSettings => ({
  view: picture.view,
  lightDelay: picture.lightDelay,
  aberration: picture.aberration,
  dopplerMix: picture.dopplerMix,
  beaming: picture.beaming,
  solver: picture.solver,
  iterations: picture.iterations,
  damping: picture.damping,
  grid: picture.grid,
  exposure: picture.exposure,
  speedOfLight: picture.speedOfLight,
});
