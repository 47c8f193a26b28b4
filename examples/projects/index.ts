import type { GraphDocument } from '../../src/graph/document.ts';
import { comparison } from './comparison.ts';
import { godsEye } from './godsEye.ts';
import { hangingCloth } from './hangingCloth.ts';
import { layers } from './layers.ts';
import { lesson } from './lesson.ts';
import { letters } from './letters.ts';
import { plain, rush } from './presets.ts';
import { truth } from './truth.ts';
import { workshop } from './workshop.ts';

/** Every example project, by name: a new one is added here. */
export const projects: Readonly<Record<string, () => GraphDocument>> = {
  plain,
  rush,
  layers,
  comparison,
  lesson,
  'gods-eye': godsEye,
  letters,
  truth,
  workshop,
  'hanging-cloth': hangingCloth,
};
