import type { Evaluation } from '../graph/evaluate.ts';
import type { RenderSettings } from '../scene/view.ts';
import type { Scale } from '../spectrum/falseColor.ts';
import type { Picture } from './define.ts';

/** The picture that an evaluation of the output node gave; undefined where it failed. */
export const pictureOf = ({ target }: Evaluation): Picture | undefined =>
  target.status === 'done' ? (target.outputs.image as Picture) : undefined;

/** What the renderer needs of a picture; `metered`: the exposure that its metering sets [EV], `scale`: that of its false colours. */
export const renderSettings = (picture: Picture, metered: number, scale?: Scale): RenderSettings => ({
  view: picture.view,
  lightDelay: picture.lightDelay,
  aberration: picture.aberration,
  colors: picture.colors,
  dopplerMix: picture.dopplerMix,
  beaming: picture.beaming,
  shadows: picture.shadows,
  solver: picture.solver,
  iterations: picture.iterations,
  damping: picture.damping,
  antialiasing: picture.antialiasing,
  grid: picture.grid,
  tone: picture.tone,
  exposure: picture.exposure + metered,
  ...(scale && picture.falseColor !== 'none' && { falseColors: { kind: picture.falseColor, ...scale } }),
  speedOfLight: picture.speedOfLight,
});
