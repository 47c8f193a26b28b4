import type { Scene } from '../../src/scene/types.ts';
import { paint, SceneBuilder, sky, sun } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { Canvas, checker } from '../kit/paint.ts';
import { block, quad } from '../kit/parts.ts';
import { floorOf, type Room, wallsOf } from '../kit/room.ts';

export const set: ExampleScene = { name: 'laboratory', readable: true, make };

const ROOM: Room = { half: 14, back: -1.5, front: 9 };
const TOP = 5;

/** A high-speed photography laboratory: dark walls with lines every 0.1 m, and a ruler of 0.1 m fields below the path. */
function make(): Scene {
  const builder = new SceneBuilder();
  const tiles = builder.material('tiles', '#ffffff', {
    texture: checker('#5d666e', '#444c55', 'tiles'),
    roughness: 0.6,
  });
  builder.object('/World/Floor', [paint(floorOf(ROOM, 0, 2), tiles)]);

  const slate = builder.material('slate', '#ffffff', { texture: graph(), roughness: 0.9 });
  builder.object(
    '/World/Boards',
    wallsOf(ROOM, -1, TOP).map((m) => paint(m, slate)),
  );

  const width = 2 * ROOM.half;
  const metal = builder.material('metal', '#8d949b', { roughness: 0.5, metallic: 0.3 });
  const rule = builder.material('rule', '#ffffff', {
    texture: checker('#f2ead8', '#b3261e', 'rule', 2, 16),
    roughness: 0.7,
  });
  const bench = [block(width, 0.16, 0.5, 1, [0, 0.02, 0]), block(width, 0.02, 0.6, 1, [0, 0.18, 0])];
  const [x, z] = [width / 2, 0.26];
  const front = quad([-x, 0.04, z], [x, 0.04, z], [x, 0.16, z], [-x, 0.16, z], 5 * width, 0.5);
  builder.object('/World/Bench', [...bench.map((m) => paint(m, metal)), paint(front, rule)]);
  const light = [sun([-0.3, 0.75, 0.8], '#fff6ea', 2.6), sky('#8fa0b8', '#79828e', '#3a3f46')];
  return builder.finish('laboratory', {}, [0, 0], [], light);
}

/** 1 m²: thin lines every 0.1 m, a thick border. */
function graph() {
  const [size, dark] = [320, '#22303c'];
  const canvas = new Canvas(size, size, dark);
  for (let k = 0; k < 10; k++) {
    const [at, wide, color] = [(k * size) / 10, k === 0 ? 4 : 1, k === 0 ? '#d8e2e8' : '#4b6274'];
    canvas.rect(at, 0, at + wide, size, color).rect(0, at, size, at + wide, color);
  }
  return canvas.rect(0, 0, 4, size, '#d8e2e8').rect(0, 0, size, 4, '#d8e2e8').texture('board');
}
