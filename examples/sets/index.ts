import type { ExampleScene } from '../kit/example.ts';
import { set as classroom } from './classroom.ts';
import { set as gym } from './gym.ts';
import { set as laboratory } from './laboratory.ts';
import { set as library } from './library.ts';
import { set as planetarium } from './planetarium.ts';
import { set as studio } from './studio.ts';
import { set as terrace } from './terrace.ts';

/** Surroundings of the simulation examples, with light; they are read by projects and not part of the gallery. */
export const sets: readonly ExampleScene[] = [terrace, studio, laboratory, gym, classroom, library, planetarium];
