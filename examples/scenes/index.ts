import type { ExampleScene } from '../kit/example.ts';
import { scene as arcade } from './arcade.ts';
import { scene as boxes } from './boxes.ts';
import { scene as cubes } from './cubes.ts';
import { scene as dice } from './dice.ts';
import { scene as drops } from './drops.ts';
import { scene as gallery } from './gallery.ts';
import { scene as hall } from './hall.ts';
import { scene as ladder } from './ladder.ts';
import { scene as lamps } from './lamps.ts';
import { scene as lattice } from './lattice.ts';
import { scene as prism } from './prism.ts';
import { scene as saturn } from './saturn.ts';
import { scene as sphere } from './sphere.ts';
import { scene as starfield } from './starfield.ts';
import { scene as street } from './street.ts';
import { scene as sunset } from './sunset.ts';
import { scene as twins } from './twins.ts';
import { scene as wheel } from './wheel.ts';

/** All scenes, in the order of the gallery. */
export const scenes: readonly ExampleScene[] = [
  street,
  dice,
  wheel,
  lattice,
  sphere,
  hall,
  lamps,
  prism,
  sunset,
  starfield,
  saturn,
  gallery,
  ladder,
  twins,
  cubes,
  arcade,
  boxes,
  drops,
];
