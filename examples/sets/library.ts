import { random } from '../../src/math/random.ts';
import type { Scene } from '../../src/scene/types.ts';
import { paint, SceneBuilder, sky, sun } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { Canvas, tone } from '../kit/paint.ts';
import { bar, block, moved, quad, roundedBox } from '../kit/parts.ts';
import { floorOf, type Room, wallsOf } from '../kit/room.ts';

export const set: ExampleScene = { name: 'library', make };

const ROOM: Room = { half: 10, back: -3.6, front: 9 };
/** Distance between shelves [m], and their number. */
const [SHELF, SHELVES] = [0.85, 6];
/** Frame of the cradle: half its length and depth, and its height [m]. */
const [LONG, DEEP, HIGH] = [1.45, 0.6, 3.54];

/** A library with the frame of a large Newton's cradle. */
function make(): Scene {
  const builder = new SceneBuilder();
  const oak = builder.material('oak', '#ffffff', { texture: boards(), roughness: 0.45 });
  builder.object('/World/Floor', [paint(floorOf(ROOM, 0, 2), oak)]);
  const { half, back } = ROOM;
  const wood = builder.material('wood', '#5a3420', { roughness: 0.5 });
  const top = SHELF * SHELVES + 0.1;
  const shelves = Array.from({ length: SHELVES + 1 }, (_, k) =>
    block(2 * half, 0.07, 0.4, 1, [0, 0.1 + SHELF * k, back + 0.2]),
  );
  const uprights = Array.from({ length: half + 1 }, (_, k) =>
    block(0.08, top, 0.42, 1, [-half + 2 * k, 0, back + 0.2]),
  );
  builder.object(
    '/World/Shelves',
    [...shelves, ...uprights].map((m) => paint(m, wood)),
  );
  const damask = builder.material('damask', '#5f2f2a', { roughness: 0.9 });
  builder.object(
    '/World/Walls',
    wallsOf(ROOM, -0.1, top).map((m) => paint(m, damask)),
  );
  const spines = builder.material('spines', '#ffffff', { texture: books(), roughness: 0.7 });
  const z = back + 0.25;
  const rows = Array.from({ length: SHELVES }, (_, k) => {
    const [y, u] = [0.17 + SHELF * k, 0.37 * k];
    const row = quad(
      [-half, y, z],
      [half, y, z],
      [half, y + SHELF - 0.12, z],
      [-half, y + SHELF - 0.12, z],
      half / 2,
      1,
    );
    return { ...row, uvs: row.uvs.map((x, i) => (i % 2 === 0 ? x + u : x)) };
  });
  builder.object(
    '/World/Books',
    rows.map((m) => paint(m, spines)),
  );

  const brass = builder.material('brass', '#c79a4a', { roughness: 0.35, metallic: 0.6 });
  const ends = [-1, 1].flatMap((x) => [
    bar([x * LONG, HIGH, -DEEP], [x * LONG, HIGH, DEEP], 0.09),
    ...[-1, 1].map((side) => bar([x * LONG, 0.1, side * DEEP], [x * LONG, HIGH + 0.045, side * DEEP], 0.09)),
  ]);
  const base = moved(roundedBox([2 * LONG + 0.5, 0.14, 2 * DEEP + 0.5], 0.04), [0, 0.07, 0]);
  builder.object('/World/Frame', [
    ...[bar([-LONG, HIGH, 0], [LONG, HIGH, 0], 0.09), ...ends].map((m) => paint(m, brass)),
    paint(base, wood),
  ]);
  const light = [sun([-0.35, 0.8, 0.6], '#ffe6bd', 2.6), sky('#9c927e', '#a39884', '#6a5136')];
  return builder.finish('library', {}, [0, 0], [], light);
}

/** 2 m of dark boards. */
function boards() {
  const canvas = new Canvas(256, 256, '#4a2d18');
  for (let row = 0; row < 10; row++) {
    const [y, x] = [25.6 * row, (row * 97) % 256];
    for (const from of [x, x - 256])
      canvas.rect(from, y, from + 254, y + 24, tone('#8a5a33', 0.85 + 0.03 * ((row * 7) % 10)));
  }
  return canvas.grain(0.04, 2).texture('boards');
}

/** 4 m of book spines. */
function books() {
  const canvas = new Canvas(512, 96, '#17100b');
  const next = random(3);
  const covers = ['#7a2a22', '#2f4a63', '#8a6b2e', '#35553c', '#5b3a5e', '#b9a47c', '#6b4a30', '#26343c'];
  for (let x = 0; x < 512; ) {
    const [wide, high] = [7 + Math.floor(9 * next()), 8 + Math.floor(18 * next())];
    const color = tone(covers[Math.floor(covers.length * next())]!, 0.5 + 0.25 * next());
    canvas
      .rect(x, high, Math.min(x + wide - 1, 512), 96, color)
      .rect(x, high + 10, Math.min(x + wide - 1, 512), high + 13, tone(color, 1.45));
    x += wide;
  }
  return canvas.texture('books');
}
