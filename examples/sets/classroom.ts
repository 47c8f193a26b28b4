import type { Scene } from '../../src/scene/types.ts';
import { paint, SceneBuilder, sky, sun } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { Canvas } from '../kit/paint.ts';
import { bar, block, quad } from '../kit/parts.ts';
import { floorOf, type Room, wallsOf } from '../kit/room.ts';

export const set: ExampleScene = { name: 'classroom', make };

const ROOM: Room = { half: 6, back: -3.4, front: 7 };
const TOP = 4.4;
/** A stand for a rail along z: half of its length, and the rail's height [m]. */
const [REACH, HIGH] = [1.75, 1.52];

/** A classroom with a board, a floor in squares of 0.5 m, and a stand for pendulums. */
function make(): Scene {
  const builder = new SceneBuilder();
  const linoleum = builder.material('linoleum', '#ffffff', { texture: tiles(), roughness: 0.5 });
  builder.object('/World/Floor', [paint(floorOf(ROOM, 0, 1), linoleum)]);
  const cream = builder.material('cream', '#e4d9bf', { roughness: 0.95 });
  const olive = builder.material('olive', '#7f8f6c', { roughness: 0.8 });
  builder.object('/World/Walls', [
    ...wallsOf(ROOM, -0.1, 0.9, 0.02).map((m) => paint(m, olive)),
    ...wallsOf(ROOM, 0.9, TOP).map((m) => paint(m, cream)),
  ]);

  const slate = builder.material('slate', '#ffffff', { texture: chalked(), roughness: 0.9 });
  const [x, bottom, top, z] = [2.6, 1.1, 2.75, ROOM.back + 0.06];
  builder.object('/World/Board', [paint(quad([-x, bottom, z], [x, bottom, z], [x, top, z], [-x, top, z]), slate)]);
  const oak = builder.material('oak', '#9a6a3a', { roughness: 0.6 });
  const frame = [
    bar([-x - 0.05, top + 0.03, z], [x + 0.05, top + 0.03, z], 0.08),
    bar([-x - 0.05, bottom - 0.03, z], [x + 0.05, bottom - 0.03, z], 0.08),
    ...[-1, 1].map((side) => bar([side * (x + 0.03), bottom, z], [side * (x + 0.03), top, z], 0.08)),
    block(2 * x, 0.03, 0.14, 1, [0, bottom - 0.1, z + 0.08]),
  ];
  builder.object(
    '/World/Frame',
    frame.map((m) => paint(m, oak)),
  );

  const iron = builder.material('iron', '#2b2d31', { roughness: 0.5, metallic: 0.4 });
  const stand = [
    bar([0, HIGH, -REACH - 0.1], [0, HIGH, REACH + 0.1], 0.07),
    ...[-1, 1].flatMap((end) => [
      bar([0, 0, end * REACH], [0, HIGH, end * REACH], 0.06),
      bar([-0.45, 0.03, end * REACH], [0.45, 0.03, end * REACH], 0.06),
    ]),
  ];
  builder.object(
    '/World/Stand',
    stand.map((m) => paint(m, iron)),
  );
  const light = [sun([-0.6, 0.8, 0.45], '#fff1d8', 2.5), sky('#b4c4da', '#d5d2c8', '#8d8574')];
  return builder.finish('classroom', {}, [0, 0], [], light);
}

/** 1 m² in squares of 0.5 m. */
function tiles() {
  const canvas = new Canvas(128, 128, '#cfc6b0');
  canvas.rect(0, 0, 64, 64, '#b7ad95').rect(64, 64, 128, 128, '#b7ad95');
  return canvas.grain(0.04, 2).texture('tiles');
}

/** A chalk drawing of a pendulum: its pivot, its rod level and hanging, and the arc between. */
function chalked() {
  const [width, height, pivot, length] = [512, 160, [256, 34], 100] as const;
  const canvas = new Canvas(width, height, '#1f3a31').grain(0.07, 8, 3);
  const dot = (x: number, y: number, size = 1.5): Canvas =>
    canvas.rect(pivot[0] + x - size, pivot[1] + y - size, pivot[0] + x + size, pivot[1] + y + size, '#dfe6dc');
  for (let k = 0; k <= 60; k++) {
    const [s, angle] = [k / 60, (Math.PI * k) / 60];
    dot(-60 + 120 * s, 0);
    dot(length * s, 0, 0.8);
    if (k % 6 < 3) dot(length * Math.cos(angle), length * Math.sin(angle), 1);
    if (k % 4 < 2) dot(0, length * s, 0.8);
    for (const [x, y] of [
      [length, 0],
      [0, length],
    ])
      dot(x + 8 * Math.cos(2 * angle), y + 8 * Math.sin(2 * angle), 1);
  }
  return canvas.texture('board');
}
