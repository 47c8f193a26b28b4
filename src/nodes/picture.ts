import type { Evaluation } from '../graph/evaluate.ts';
import type { RenderSettings, ViewPoint } from '../scene/view.ts';
import type { Picture } from './define.ts';
import { stopsOfMotion } from './metering.ts';

/** The picture that an evaluation of the output node gave; undefined where it failed. */
export const pictureOf = ({ target }: Evaluation): Picture | undefined =>
  target.status === 'done' ? (target.outputs.image as Picture) : undefined;

/** What the renderer needs of a picture that is taken from a place; `aspect`: width over height. */
export const renderSettings = (picture: Picture, from: ViewPoint, aspect: number): RenderSettings => ({
  view: picture.view,
  lightDelay: picture.lightDelay,
  aberration: picture.aberration,
  dopplerMix: picture.dopplerMix,
  beaming: picture.beaming,
  solver: picture.solver,
  iterations: picture.iterations,
  damping: picture.damping,
  grid: picture.grid,
  tone: picture.tone,
  exposure: picture.exposure - adaptation(picture, from, aspect),
  speedOfLight: picture.speedOfLight,
});

/**
 * Stops by which the exposure is taken back for the brightness that the observer's velocity gives the picture [EV]; only in
 * the light-cone view does it give any.
 */
export const adaptation = (
  { adapt, view, beaming, aberration }: Pick<Picture, 'adapt' | 'view' | 'beaming' | 'aberration'>,
  from: ViewPoint,
  aspect: number,
): number => (adapt && view === 'light-cone' ? beaming * stopsOfMotion(from, aspect, aberration) : 0);
