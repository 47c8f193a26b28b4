import type { GraphDocument } from '../../src/graph/document/document.ts';
import { bouncing } from './bouncing.ts';
import { charges } from './charges.ts';
import { checkerboards } from './checkerboards.ts';
import { clocksAround } from './clocksAround.ts';
import { comparison } from './comparison.ts';
import { cradle } from './cradle.ts';
import { fallingCloth } from './fallingCloth.ts';
import { godsEye } from './godsEye.ts';
import { hangingCloth } from './hangingCloth.ts';
import { impact } from './impact.ts';
import { layers } from './layers.ts';
import { lesson } from './lesson.ts';
import { letters } from './letters.ts';
import { pendulums } from './pendulums.ts';
import { accelerations, captured, plain, rush } from './presets.ts';
import { sourceBall, sourceCorrections, sourceSpeeds } from './sourceExperiments.ts';
import { textureCube, textureHall, textureInterior } from './textureMapping.ts';
import { truth } from './truth.ts';
import { workshop } from './workshop.ts';

/** Every example project, by name: a new one is added here. */
export const projects: Readonly<Record<string, () => GraphDocument>> = {
  plain,
  rush,
  captured,
  'texture-cube': textureCube,
  'texture-hall': textureHall,
  'texture-interior': textureInterior,
  'clocks-around': clocksAround,
  ...accelerations,
  layers,
  checkerboards,
  comparison,
  lesson,
  'gods-eye': godsEye,
  letters,
  truth,
  workshop,
  'hanging-cloth': hangingCloth,
  'falling-cloth': fallingCloth,
  impact,
  bouncing,
  pendulums,
  cradle,
  charges,
  'source-speeds': sourceSpeeds,
  'source-corrections': sourceCorrections,
  'source-ball': sourceBall,
};
