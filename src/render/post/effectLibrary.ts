import type { EffectId } from '../../scene/frameGraph/effects.ts';
import { antialiasing } from './antialiasing.ts';
import { bilateralFilter } from './bilateralFilter.ts';
import { bloom } from './bloom.ts';
import { depthOfField } from './depthOfField.ts';
import { edge } from './edge.ts';
import type { Effect } from './effect.ts';
import { fog } from './fog.ts';
import { gaussianBlur } from './gaussianBlur.ts';
import { hueShift } from './hueShift.ts';
import { lensGrid } from './lensGrid.ts';
import { observerMarks } from './observerMarks.ts';
import { sharpen } from './sharpen.ts';
import { skyBackground } from './skyBackground.ts';
import { vignette } from './vignette.ts';

/** The GPU implementation of every effect; names and arguments are in scene/frameGraph/effects.ts. */
export const effectLibrary: Readonly<Record<EffectId, Effect>> = {
  'gaussian-blur': gaussianBlur,
  'bilateral-filter': bilateralFilter,
  'sky-background': skyBackground,
  sharpen,
  bloom,
  edge,
  vignette,
  fog,
  'hue-shift': hueShift,
  'observer-marks': observerMarks,
  'lens-grid': lensGrid,
  'depth-of-field': depthOfField,
  antialiasing,
};
