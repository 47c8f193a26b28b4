import { makeMesh } from '../../src/scene/geometry.ts';
import type { Mesh, Scene } from '../../src/scene/types.ts';
import { paint, SceneBuilder, sky, sun } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { Canvas } from '../kit/paint.ts';
import { quad, turned } from '../kit/parts.ts';

export const set: ExampleScene = { name: 'studio', make };

/** Half its width; where its floor ends, before and behind; of its bend [m]. */
const [HALF, FRONT, BACK, BEND] = [16, 10, -2.4, 2];
const TOP = 8;

/** A photographer's studio: the floor bends up into the wall, in fields of half a metre. On its foot a ball lies 0.3 m high. */
function make(): Scene {
  const builder = new SceneBuilder();
  const paper = builder.material('paper', '#ffffff', { texture: squared('#4f7f80', '#7fa9a6'), roughness: 0.95 });
  const [w, l] = [4 * HALF, 2 * (FRONT - BACK)];
  const floor = quad([-HALF, 0, FRONT], [HALF, 0, FRONT], [HALF, 0, BACK], [-HALF, 0, BACK], w, l);
  builder.object('/World/Floor', [paint(floor, paper)]);
  builder.object('/World/Sweep', [paint(sweep(), paper)]);
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

/** A field with a line round it. */
function squared(field: string, line: string) {
  const canvas = new Canvas(64, 64, line);
  return canvas.rect(1, 1, 63, 63, field).texture('paper');
}

/** What follows the floor: a quarter of a tube, then the wall; uv as on the floor. */
function sweep(): Mesh {
  const steps = 16;
  const outline = [
    ...Array.from({ length: steps + 1 }, (_, i) => {
      const a = (Math.PI / 2) * (i / steps);
      return {
        y: BEND * (1 - Math.cos(a)),
        z: BACK - BEND * Math.sin(a),
        way: BEND * a,
        n: [Math.cos(a), Math.sin(a)],
      };
    }),
    { y: TOP, z: BACK - BEND, way: (BEND * Math.PI) / 2 + TOP - BEND, n: [0, 1] },
  ];
  const sides = outline.flatMap((at) => [-HALF, HALF].map((x) => ({ ...at, x })));
  return makeMesh({
    points: sides.flatMap(({ x, y, z }) => [x, y, z]),
    faceCounts: outline.slice(1).map(() => 4),
    faceIndices: outline.slice(1).flatMap((_, i) => [2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2]),
    normals: { per: 'point', values: sides.flatMap(({ n }) => [0, ...n]) },
    uvs: { per: 'point', values: sides.flatMap(({ x, way }) => [2 * (x + HALF), 2 * (FRONT - BACK + way)]) },
  }).mesh;
}
