import { makeMesh } from '../../src/scene/mesh/makeMesh.ts';
import type { Mesh, Scene } from '../../src/scene/types.ts';
import { paint, SceneBuilder, sky, sun } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { Canvas } from '../kit/paint.ts';
import { turned } from '../kit/parts.ts';
import { floorOf, type Room, wallsOf } from '../kit/room.ts';

export const set: ExampleScene = { name: 'studio', make };

const ROOM: Room = { half: 12, back: -2.4, front: 10 };
/** Radius of the bend, and height of the wall [m]. */
const [BEND, TOP] = [2, 8];

/** A photo studio whose floor bends up into the wall, in squares of 0.5 m. On its foot a ball lies 0.3 m high. */
function make(): Scene {
  const builder = new SceneBuilder();
  const paper = builder.material('paper', '#ffffff', { texture: squared('#4f7f80', '#7fa9a6'), roughness: 0.95 });
  builder.object('/World/Floor', [paint(floorOf(ROOM, 0, 0.5), paper)]);
  builder.object('/World/Sweep', [paint(sweep(ROOM), paper)]);
  const felt = builder.material('felt', '#2f4f50', { roughness: 0.95 });
  const hall = { ...ROOM, back: ROOM.back - BEND - 0.05 };
  builder.object(
    '/World/Walls',
    wallsOf(hall, -0.1, TOP).map((m) => paint(m, felt)),
  );
  const foot = turned(
    [
      [0.42, 0],
      [0.42, 0.05],
      [0.16, 0.12],
      [0.12, 0.3],
      [0.2, 0.35],
      [0, 0.35],
    ],
    32,
  );
  const walnut = builder.material('walnut', '#4a2f22', { roughness: 0.5 });
  builder.object('/World/Foot', [paint(foot, walnut)]);
  const light = [sun([-0.55, 0.75, 0.5], '#fff0dc', 2.4), sky('#aab4c4', '#b9b2ac', '#8a7c70')];
  return builder.finish('studio', {}, [0, 0], [], light);
}

/** A square with a border. */
function squared(field: string, line: string) {
  const canvas = new Canvas(64, 64, line);
  return canvas.rect(1, 1, 63, 63, field).texture('paper');
}

/** The continuation of the floor: a quarter cylinder, then the wall; uv continues from the floor. */
function sweep({ half, back, front }: Room): Mesh {
  const steps = 16;
  const outline = [
    ...Array.from({ length: steps + 1 }, (_, i) => {
      const a = (Math.PI / 2) * (i / steps);
      return {
        y: BEND * (1 - Math.cos(a)),
        z: back - BEND * Math.sin(a),
        way: BEND * a,
        n: [Math.cos(a), Math.sin(a)],
      };
    }),
    { y: TOP, z: back - BEND, way: (BEND * Math.PI) / 2 + TOP - BEND, n: [0, 1] },
  ];
  const sides = outline.flatMap((at) => [-half, half].map((x) => ({ ...at, x })));
  return makeMesh({
    points: sides.flatMap(({ x, y, z }) => [x, y, z]),
    faceCounts: outline.slice(1).map(() => 4),
    faceIndices: outline.slice(1).flatMap((_, i) => [2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2]),
    normals: { per: 'point', values: sides.flatMap(({ n }) => [0, ...n]) },
    uvs: { per: 'point', values: sides.flatMap(({ x, way }) => [2 * (x + half), 2 * (front - back + way)]) },
  }).mesh;
}
