import type { Scene } from '../../src/scene/types.ts';
import { paint, place, placePart, SceneBuilder, sky, sun } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { Canvas, tone } from '../kit/paint.ts';
import { turned } from '../kit/parts.ts';
import { floorOf, type Room, wallsOf } from '../kit/room.ts';
import { broadTree } from '../kit/trees.ts';

export const set: ExampleScene = { name: 'terrace', make };

const ROOF: Room = { half: 5, back: -4, front: 6 };

/** A roof terrace by the sea with tiles of 0.5 m, for the hanging cloth. */
function make(): Scene {
  const builder = new SceneBuilder();
  const tiles = builder.material('tiles', '#ffffff', { texture: terracotta(), roughness: 0.85 });
  builder.object('/World/Floor', [paint(floorOf(ROOF, 0, 1), tiles)]);

  const plaster = builder.material('plaster', '#e9e2d3', { roughness: 0.95 });
  const coping = builder.material('coping', '#a65a3a', { roughness: 0.8 });
  builder.object('/World/Parapet', [
    ...wallsOf(ROOF, -0.1, 0.8, 0, 0.25).map((m) => paint(m, plaster)),
    ...wallsOf(ROOF, 0.8, 0.87, 0.06, 0.37).map((m) => paint(m, coping)),
  ]);

  const clay = builder.material('clay', '#b0623f', { roughness: 0.9 });
  const bark = builder.material('bark', '#5b4634', { roughness: 0.9 });
  const leaf = builder.material('leaf', '#4c7a3a', { roughness: 0.8, like: 'leaf' });
  const pot = turned(
    [
      [0.24, 0],
      [0.34, 0.46],
      [0.38, 0.46],
      [0.38, 0.56],
      [0.3, 0.56],
      [0.29, 0.48],
      [0, 0.48],
    ],
    20,
  );
  const bush = [paint(pot, clay), ...placePart(broadTree(1.5, bark, leaf, 5), place([0, 0.4, 0]))];
  for (const [i, x] of [-4.3, -2.6, 2.9, 4.3].entries())
    builder.object(`/World/Pot${i}`, placePart(bush, place([x, 0, ROOF.back + 0.55], i)));
  const light = [sun([0.45, 0.7, 0.6], '#ffeccb', 2.9), sky('#4f8fd8', '#d8e8f0', '#1d5a80')];
  return builder.finish('terrace', {}, [0, 0], [], light);
}

/** 2 × 2 tiles, all slightly different. */
function terracotta() {
  const canvas = new Canvas(128, 128, '#8c7464');
  const shades = [0.94, 1.05, 1, 0.88];
  shades.forEach((k, i) => {
    const [x, y] = [64 * (i % 2), 64 * (i >> 1)];
    canvas.rect(x + 1, y + 1, x + 63, y + 63, tone('#c07a52', k));
  });
  return canvas.grain(0.03, 4).texture('tiles');
}
