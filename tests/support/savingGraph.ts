import type { GraphDocument } from '../../src/graph/document/document.ts';
import type { Command } from '../../src/graph/edits/commands.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { add, build, connect, set } from './graphKit.ts';

const CHAIN = [
  ...['move.geometry > scene.geometry.1', 'eye.geometry > scene.geometry.2', 'sun.lights > scene.lights.1'],
  ...['sky.lights > scene.lights.2', 'scene.scene > console.scene', 'console.relativity > camera.relativity'],
  ...['camera.view > rasterize.view', 'rasterize.gbuffer > lighting.gbuffer', 'lighting.image > tone.image'],
  ...['box.geometry > move.geometry', 'motion.motion > move.motion', 'tone.image > still.image'],
  ...['still.image > film.image', 'film.image > output.image'],
] as const;

const TYPES = {
  box: 'box',
  motion: 'motion-uniform',
  move: 'move',
  eye: 'camera',
  sun: 'sun',
  sky: 'sky',
  scene: 'scene',
  console: 'relativity-console',
  camera: 'scene-camera',
  rasterize: 'relativity-rasterize',
  lighting: 'deferred-lighting',
  tone: 'tone-map',
  still: 'save-image',
  film: 'save-video',
  output: 'output',
} as const;

const vector = (node: string, param: string, value: Vec3): Command => ({ kind: 'set-param', node, param, value });

/** A box passing at c/2, saved as a picture of 64 × 48 pixels at 0.5 s and as a film of five frames. */
export const savingProject = (): GraphDocument =>
  build(
    ...Object.entries(TYPES).map(([node, type], i) => add(node, type, [260 * (i % 5), 220 * Math.floor(i / 5)])),
    ...[
      set('console', 'speedOfLight', 10),
      vector('motion', 'velocity', [5, 0, 0]),
      vector('eye', 'position', [0, 1, 6]),
    ],
    ...[set('still', 'width', 64), set('still', 'height', 48), set('still', 'time', 0.5), set('still', 'samples', 2)],
    ...[set('film', 'width', 64), set('film', 'height', 48), set('film', 'samples', 1)],
    ...[set('film', 'from', 0.25), set('film', 'to', 0.75), set('film', 'fps', 8)],
    ...CHAIN.map((joint) => connect(...(joint.split(' > ') as [string, string]))),
  );
