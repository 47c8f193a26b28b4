import type { GraphDocument } from '../../src/graph/document/document.ts';
import type { Command } from '../../src/graph/edits/commands.ts';
import { add, build, connect, set } from '../../tests/support/graphKit.ts';

/** Boxes per block of the graph, each with a node that moves it; a block is merged into one output. */
const BLOCK = 8;
/** Horizontal and vertical spacing of nodes, and of blocks [px]. */
const [COLUMN, ROW, WIDE, HIGH] = [260, 150, 900, 1300];
/** Blocks per column. */
const STACK = 2;

/** A project with the given number of nodes that makes a picture: blocks of boxes, a sun and the usual render nodes. */
export function gridProject(size: number): GraphDocument {
  const chain = ['scene', 'relativity-console', 'scene-camera', 'relativity-rasterize', 'deferred-lighting'] as const;
  const tail = ['post-process', 'tone-map', 'output'] as const;
  const blocks: Command[] = [];
  const merges: string[] = [];
  for (let left = size - chain.length - tail.length - 2; left > 0; ) {
    const boxes = Math.min(BLOCK, (left - 1) >> 1);
    // The remainder are number nodes.
    if (boxes < 1) {
      blocks.push(add(`spare${left--}`, 'number', [0, -ROW]));
      continue;
    }
    const merge = `merge${merges.length}`;
    blocks.push(...block(merge, boxes, merges.length));
    merges.push(merge);
    left -= 2 * boxes + 1;
  }
  const x = WIDE * Math.ceil(merges.length / STACK);
  const at = (i: number): readonly [number, number] => [x + COLUMN * (i + 1), 0];
  return build(
    ...blocks,
    add('sun', 'sun', [x, 0]),
    add('observer', 'observer', [x, 2 * ROW]),
    place('observer', 'beta', [0, 0, -0.4]),
    ...[...chain, ...tail].map((type, i) => add(type, type, at(i))),
    ...merges.map((merge, i) => connect(`${merge}.geometry`, `scene.geometry.${i + 1}`)),
    connect('sun.lights', 'scene.lights.1'),
    connect('observer.observer', 'scene.observer'),
    connect('scene.scene', 'relativity-console.scene'),
    connect('relativity-console.relativity', 'scene-camera.relativity'),
    connect('scene-camera.view', 'relativity-rasterize.view'),
    connect('relativity-rasterize.gbuffer', 'deferred-lighting.gbuffer'),
    connect('deferred-lighting.image', 'post-process.image'),
    connect('post-process.image', 'tone-map.image'),
    connect('tone-map.image', 'output.image'),
  );
}

const place = (node: string, param: string, value: readonly number[]): Command => ({
  kind: 'set-param',
  node,
  param,
  value: [...value],
});

function block(merge: string, boxes: number, index: number): Command[] {
  const [x, y] = [WIDE * Math.floor(index / STACK), HIGH * (index % STACK)];
  const rows = Array.from({ length: boxes }, (_, i): Command[] => {
    const [box, moved] = [`${merge}box${i}`, `${merge}moved${i}`];
    return [
      add(box, 'box', [x, y + ROW * i]),
      set(box, 'name', `Box${i}`),
      add(moved, 'transform', [x + COLUMN, y + ROW * i]),
      place(moved, 'position', [2 * i - BLOCK, 0, -4 - 2 * index]),
      connect(`${box}.geometry`, `${moved}.geometry`),
      connect(`${moved}.geometry`, `${merge}.geometry.${i + 1}`),
    ];
  });
  return [add(merge, 'merge', [x + 2 * COLUMN, y + (ROW * (boxes - 1)) / 2]), ...rows.flat()];
}
