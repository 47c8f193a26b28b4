import type { Scene } from '../../src/scene/types.ts';
import { paint, place, placePart, SceneBuilder, sky, sun } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { Canvas, checker, tone } from '../kit/paint.ts';
import { bar, block, quad } from '../kit/parts.ts';
import { floorOf, type Room, wallsOf } from '../kit/room.ts';

export const set: ExampleScene = { name: 'gym', make };

const HALL: Room = { half: 9, back: -5, front: 9 };
const TOP = 6;
/** Half the side and the thickness of the mat [m]. */
const [MAT, THICK] = [3, 0.15];

/** A gymnasium. The top of its mat, in squares of 1 m, is at y = 0. */
function make(): Scene {
  const builder = new SceneBuilder();
  const mat = builder.material('mat', '#ffffff', { texture: checker('#3f7fb8', '#2f6596', 'mat'), roughness: 0.9 });
  builder.object('/World/Mat', [
    paint(quad([-MAT, 0, MAT], [MAT, 0, MAT], [MAT, 0, -MAT], [-MAT, 0, -MAT], MAT, MAT), mat),
  ]);
  const rim = builder.material('rim', '#27527c', { roughness: 0.9 });
  builder.object('/World/Rim', [paint(block(2 * MAT, THICK - 0.001, 2 * MAT, 1, [0, -THICK, 0]), rim)]);

  const planks = builder.material('planks', '#ffffff', { texture: parquet(), roughness: 0.4 });
  builder.object('/World/Floor', [paint(floorOf(HALL, -THICK, 2), planks)]);
  const line = builder.material('line', '#f1efe6', { roughness: 0.6 });
  const [x, from, to] = [HALL.half - 1.2, -MAT - 0.9, HALL.front - 1];
  const court = [
    block(2 * x, 0.004, 0.08, 1, [0, -THICK, from]),
    ...[-1, 1].map((side) => block(0.08, 0.004, to - from, 1, [side * x, -THICK, (from + to) / 2])),
  ];
  builder.object(
    '/World/Court',
    court.map((m) => paint(m, line)),
  );
  walls(builder);
  const light = [sun([-0.4, 0.8, 0.5], '#fff3df', 2.5), sky('#b9c8da', '#c9ced2', '#8c8071')];
  return builder.finish('gym', {}, [0, 0], [], light);
}

function walls(builder: SceneBuilder): void {
  const panel = builder.material('panel', '#c58f55', { roughness: 0.7 });
  const plaster = builder.material('plaster', '#dcd8cc', { roughness: 0.95 });
  const glass = builder.material('glass', '#cfe2ee', { emissive: '#a9c4d6', roughness: 0.3 });
  builder.object('/World/Walls', [
    ...wallsOf(HALL, -0.3, 2.5).map((m) => paint(m, panel)),
    ...wallsOf(HALL, 2.5, TOP).map((m) => paint(m, plaster)),
  ]);
  const windows = Array.from({ length: 6 }, (_, k) => block(2.2, 1.7, 0.05, 1, [-7.25 + 2.9 * k, 3.4, HALL.back]));
  builder.object(
    '/World/Windows',
    windows.map((m) => paint(m, glass)),
  );

  const beech = builder.material('beech', '#e0b57a', { roughness: 0.5 });
  const rungs = Array.from({ length: 11 }, (_, k) => bar([-0.45, 0.1 + 0.2 * k, 0], [0.45, 0.1 + 0.2 * k, 0], 0.04));
  const cheeks = [-0.47, 0.47].map((at) => block(0.05, 2.3, 0.1, 1, [at, 0, 0]));
  const ladder = [...rungs, ...cheeks].map((m) => paint(m, beech));
  for (let k = 0; k < 9; k++)
    builder.object(`/World/WallBars${k}`, placePart(ladder, place([-4.2 + 1.05 * k, -THICK, HALL.back + 0.14])));
}

/** Two metres of boards, each 2/16 m wide. */
function parquet() {
  const canvas = new Canvas(256, 256, '#8a6238');
  for (let row = 0; row < 16; row++)
    for (let half = 0; half < 2; half++) {
      const x = 128 * half + (row % 3) * 40;
      const color = tone('#c8935a', 0.9 + 0.2 * (((row * 7 + half * 5) % 11) / 11));
      for (const from of [x, x - 256]) canvas.rect(from, 16 * row, from + 127, 16 * row + 15, color);
    }
  return canvas.grain(0.03, 2).texture('planks');
}
