import { fromAxisAngle } from '../../src/math/quat.ts';
import { makeMesh } from '../../src/scene/mesh/makeMesh.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import type { Mesh, Scene } from '../../src/scene/types.ts';
import { at, type Part, paint, SceneBuilder, sky, sun } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, sampled, smoothRamp } from '../kit/flight.ts';
import { bricks, Canvas, checker, tone } from '../kit/paint.ts';
import { block, column, join, moved, quad, turned } from '../kit/parts.ts';

/** A bay is as long as an arch is wide [m]; the court is open between the arcades, whose galleries lie behind them. */
const BAY = 4;
const BAYS = 14;
const LENGTH = BAY * BAYS;
const [COURT, GALLERY] = [4.5, 8.5];
/** Heights of the floors, and of the columns' heads above them [m]. */
const FLOORS = [0, 6];
const SPRING = [3.4, 2.7];
const THICK = 0.6;

export const scene: ExampleScene = { name: 'arcade', make };

/** A court between two-storey arcades, of the size of Sponza, which tests of renderers use: 300,000 triangles, textured. Equal meshes are stored once. */
function make(): Scene {
  const builder = new SceneBuilder();
  const stone = builder.material('stone', '#ffffff', { texture: limestone(), roughness: 0.75 });
  const marble = builder.material('marble', '#e8e0d2', { roughness: 0.35 });
  const wall = builder.material('wall', '#ffffff', {
    texture: bricks('#b98a68', '#d8c7ae', 'wall', 4, 8, 32),
    roughness: 0.9,
  });
  const floor = builder.material('floor', '#ffffff', {
    texture: checker('#d9cdb8', '#8c6f5c', 'floor', 4, 64),
    roughness: 0.3,
  });
  shell(builder, floor, wall, stone);
  arcades(builder, stone, marble);
  hangings(builder);
  things(builder);
  const [from, to] = [0, 9];
  const way = (t: number) => 22 - 40 * smoothRamp(t / to, 0.34);
  const flight = camera({
    from,
    to,
    fovY: 68,
    position: (t) => [-1.2 + 0.5 * Math.sin(0.4 * t), 2.1, way(t)],
    target: (t) => [0.6, 3.4, way(t) - 16],
  });
  const hints = {
    speedOfLight: 10,
    title: 'Arcade',
    lookFor:
      'Three hundred thousand triangles: 120 columns, vaults and balusters, sun that falls into the court, a ball of bronze in it. At 0.9 c the arches lean in, the galleries fold round you, and what is ahead turns blue.',
    openAt: 1.3,
  };
  return builder.finish(
    'arcade',
    hints,
    [from, to],
    [flight],
    [sun([0.42, 0.86, 0.28], '#ffeccb', 4.2), sky('#86aede', '#e6e9e6', '#a89a86')],
  );
}

function limestone() {
  const canvas = new Canvas(128, 128, '#cdbfa6');
  for (let j = 0; j < 4; j++)
    for (let i = 0; i < 2; i++) {
      const x = 64 * i + (j % 2) * 32;
      const color = tone('#d8cbb3', 0.94 + 0.03 * ((3 * i + 5 * j) % 4));
      canvas.rect(x + 1, 32 * j + 1, x + 63, 32 * j + 31, color);
      canvas.rect(x - 127, 32 * j + 1, x - 65, 32 * j + 31, color);
    }
  return canvas.grain(0.03, 2).texture('limestone');
}

/** Floors, outer walls, roofs of the galleries and the walls at the ends. */
function shell(builder: SceneBuilder, floor: number, wall: number, stone: number): void {
  const end = LENGTH / 2;
  const flat = (x0: number, x1: number, y: number, material: number) =>
    paint(quad([x0, y, end], [x1, y, end], [x1, y, -end], [x0, y, -end], (x1 - x0) / 4, LENGTH / 4), material);
  builder.object('/World/Floor', [flat(-GALLERY, GALLERY, 0, floor)]);
  const top = FLOORS[1] + 5;
  for (const side of [-1, 1]) {
    const name = side < 0 ? 'Left' : 'Right';
    const [a, b] = side < 0 ? [-GALLERY, -COURT] : [COURT, GALLERY];
    builder.object(`/World/Upper${name}`, [flat(a, b, FLOORS[1] + 0.01, floor)]);
    builder.object(`/World/Wall${name}`, [
      paint(block(0.4, top, LENGTH, 0.4, [side * (GALLERY + 0.2), 0, 0]), wall),
      paint(block(GALLERY - COURT + 1, 0.5, LENGTH, 0.4, [(side * (COURT + GALLERY)) / 2, top, 0]), stone),
    ]);
  }
  for (const side of [-1, 1])
    builder.object(`/World/End${side < 0 ? 'Far' : 'Near'}`, [
      paint(block(2 * GALLERY + 0.8, top + 0.5, 0.4, 0.4, [0, 0, side * (end + 0.2)]), wall),
    ]);
}

/** Columns, arches, vaults and balusters: one mesh of each, many times. */
function arcades(builder: SceneBuilder, stone: number, marble: number): void {
  const vaultMaterial = builder.material('vault', '#e4d6bd', { roughness: 0.85 });
  const columns = SPRING.map((height): Part => [paint(pillar(height), marble)]);
  const heights = [FLOORS[1] - SPRING[0], 5 - SPRING[1]];
  const arches = heights.map((height): Part => [paint(arch(height), stone)]);
  const vault: Part = [paint(crossVault(GALLERY - COURT), vaultMaterial)];
  const rail: Part = [paint(block(BAY, 0.14, 0.26, 1, [0, 0.92, 0]), stone)];
  const balusters: Part = [paint(baluster(), marble)];
  for (const side of [-1, 1])
    for (let k = 0; k <= BAYS; k++) {
      const z = (k - BAYS / 2) * BAY;
      const turn = fromAxisAngle([0, 1, 0], Math.PI / 2);
      const name = `${side < 0 ? 'Left' : 'Right'}${k}`;
      FLOORS.forEach((y, storey) => {
        for (const [row, x] of [COURT, GALLERY - 0.3].entries())
          builder.object(`/World/Column${storey}${row}${name}`, columns[storey], at([side * x, y, z]));
        if (k === BAYS) return;
        const middle = z + BAY / 2;
        builder.object(
          `/World/Arch${storey}${name}`,
          arches[storey],
          at([side * COURT, y + SPRING[storey], middle], turn),
        );
        builder.object(
          `/World/Vault${storey}${name}`,
          vault,
          at([(side * (COURT + GALLERY)) / 2, y + SPRING[storey], middle]),
        );
      });
      if (k === BAYS) continue;
      builder.object(`/World/Rail${name}`, rail, at([side * COURT, FLOORS[1], z + BAY / 2], turn));
      for (let i = 1; i < 8; i++)
        builder.object(`/World/Baluster${name}_${i}`, balusters, at([side * COURT, FLOORS[1], z + (i * BAY) / 8]));
    }
}

/** A column that reaches from y = 0 to where the arches spring, with more sides than `column` has. */
function pillar(height: number): Mesh {
  const r = 0.3;
  const shaft = Array.from({ length: 9 }, (_, i): [number, number] => {
    const s = i / 8;
    return [r * (1 - 0.14 * s ** 1.8), 0.34 + (height - 0.86) * s];
  });
  const roll = (y: number, bulge: number): [number, number][] =>
    [-1, -0.5, 0, 0.5, 1].map((s) => [r + bulge * Math.sqrt(1 - 0.9 * s * s), y + 0.08 * s]);
  const outline = [...roll(0.24, 0.08), ...shaft, ...roll(height - 0.42, 0.03), [0.42, height - 0.16]] as [
    number,
    number,
  ][];
  return join([block(0.86, 0.16, 0.86), turned(outline, 36), block(0.92, 0.16, 0.92, 1, [0, height - 0.16, 0])]);
}

/** A wall of one bay with a round arch in it, from its springing up to `height`, across z. */
function arch(height: number): Mesh {
  const steps = 24;
  const radius = BAY / 2 - 0.42;
  const z = THICK / 2;
  const points: number[] = [];
  const uvs: number[] = [];
  const faceIndices: number[] = [];
  // Per step: the intrados at both faces, and above it the wall's upper edge.
  const edge = Array.from({ length: steps + 1 }, (_, i): readonly [number, number, number] => {
    const a = Math.PI * (1 - i / steps);
    const x = radius * Math.cos(a);
    return [x, radius * Math.sin(a), i === 0 ? -BAY / 2 : i === steps ? BAY / 2 : x * (BAY / 2 / radius)];
  });
  const face = (corners: readonly (readonly number[])[], places: readonly (readonly number[])[]) => {
    const first = points.length / 3;
    corners.forEach((corner, k) => {
      points.push(...corner);
      uvs.push(...places[k]);
      faceIndices.push(first + k);
    });
  };
  const along = (x: number, y: number) => [0.5 + x / BAY, y / 2];
  for (let i = 0; i < steps; i++) {
    const [x0, y0, u0] = edge[i];
    const [x1, y1, u1] = edge[i + 1];
    const front = [along(x0, y0), along(x1, y1), along(u1, height), along(u0, height)];
    face(
      [
        [x0, y0, z],
        [x1, y1, z],
        [u1, height, z],
        [u0, height, z],
      ],
      front,
    );
    face(
      [
        [x1, y1, -z],
        [x0, y0, -z],
        [u0, height, -z],
        [u1, height, -z],
      ],
      [front[1], front[0], front[3], front[2]],
    );
    face(
      [
        [x1, y1, z],
        [x0, y0, z],
        [x0, y0, -z],
        [x1, y1, -z],
      ],
      [
        [(i + 1) / 8, 0],
        [i / 8, 0],
        [i / 8, 0.3],
        [(i + 1) / 8, 0.3],
      ],
    );
  }
  for (const side of [-1, 1]) {
    const [x, u] = [side * radius, (side * BAY) / 2];
    const [a, b] = side > 0 ? [x, u] : [u, x];
    face(
      [
        [a, 0, z],
        [b, 0, z],
        [b, height, z],
        [a, height, z],
      ]
        .slice(0, 2)
        .concat([[u, height, z]]),
      [along(a, 0), along(b, 0), along(u, height)],
    );
    face(
      [
        [b, 0, -z],
        [a, 0, -z],
        [u, height, -z],
      ],
      [along(b, 0), along(a, 0), along(u, height)],
    );
    face(
      [
        [b, 0, -z],
        [b, 0, z],
        [a, 0, z],
        [a, 0, -z],
      ],
      [
        [0, 0],
        [0, 0.3],
        [0.2, 0.3],
        [0.2, 0],
      ],
    );
  }
  const faceCounts: number[] = [];
  for (let i = 0, n = 0; n < faceIndices.length; i++) {
    const count = i < 3 * steps ? 4 : (i - 3 * steps) % 3 === 2 ? 4 : 3;
    faceCounts.push(count);
    n += count;
  }
  return makeMesh({ points, faceCounts, faceIndices, uvs: { per: 'corner', values: uvs } }).mesh;
}

/** A groined vault over a bay, seen from below: the higher of two barrels at each place. */
function crossVault(width: number): Mesh {
  const steps = 14;
  const points: number[] = [];
  const uvs: number[] = [];
  const barrel = (s: number) => 1.5 * Math.sqrt(Math.max(0, 1 - (2 * s - 1) ** 2));
  // Finer at the springing, where barrels are steep.
  const place = (i: number) => 0.5 - 0.5 * Math.cos((Math.PI * i) / steps);
  for (let j = 0; j <= steps; j++)
    for (let i = 0; i <= steps; i++) {
      const [s, t] = [place(i), place(j)];
      points.push((s - 0.5) * width, Math.max(barrel(s), barrel(t)), (t - 0.5) * BAY);
      uvs.push(s, t);
    }
  const faceIndices: number[] = [];
  for (let j = 0; j < steps; j++)
    for (let i = 0; i < steps; i++) {
      const p = j * (steps + 1) + i;
      faceIndices.push(p, p + 1, p + steps + 2, p + steps + 1);
    }
  return makeMesh({
    points,
    faceCounts: new Array(steps * steps).fill(4),
    faceIndices,
    uvs: { per: 'point', values: uvs },
    doubleSided: true,
  }).mesh;
}

const baluster = (): Mesh =>
  turned(
    Array.from({ length: 17 }, (_, i): [number, number] => {
      const s = i / 16;
      const belly = 0.05 + 0.055 * Math.sin(Math.PI * Math.min(1, 1.7 * s)) ** 2 + (s > 0.6 ? 0.02 * (s - 0.6) : 0);
      return [i < 2 || i > 14 ? 0.1 : belly, 0.92 * s];
    }),
    18,
  );

/** Cloths that hang from the upper floor. */
function hangings(builder: SceneBuilder): void {
  const colors = ['#8f2f2a', '#2f5a7a', '#8a6a24'].map((color, i) =>
    builder.material(`cloth${i}`, color, { roughness: 0.95 }),
  );
  const cloth = folds();
  for (const side of [-1, 1])
    for (let k = 1; k < BAYS; k += 3)
      builder.object(
        `/World/Cloth${side < 0 ? 'Left' : 'Right'}${k}`,
        [paint(cloth, colors[k % 3])],
        at(
          [side * (COURT - THICK / 2 - 0.1), FLOORS[1] + 0.7, (k - BAYS / 2) * BAY],
          fromAxisAngle([0, 1, 0], Math.PI / 2),
        ),
      );
}

/** A hanging cloth with folds that open downwards. */
function folds(): Mesh {
  const [across, down] = [32, 10];
  const points: number[] = [];
  const faceIndices: number[] = [];
  for (let j = 0; j <= down; j++)
    for (let i = 0; i <= across; i++) {
      const [s, t] = [i / across, j / down];
      points.push((s - 0.5) * 1.7, -3 * t, 0.05 * (0.3 + t) * Math.sin(8 * Math.PI * s));
      if (i < across && j < down) {
        const p = j * (across + 1) + i;
        faceIndices.push(p, p + across + 1, p + across + 2, p + 1);
      }
    }
  return makeMesh({ points, faceCounts: new Array(across * down).fill(4), faceIndices, doubleSided: true }).mesh;
}

/** A ball of bronze that turns, one of marble that passes, and vases. */
function things(builder: SceneBuilder): void {
  const bronze = builder.material('bronze', '#b98a4e', { roughness: 0.25, metallic: 1 });
  const clay = builder.material('clay', '#ffffff', {
    texture: checker('#b5623f', '#8f4a30', 'clay', 8, 16),
    roughness: 0.7,
  });
  const foot: Part = [
    paint(moved(column(1.3, 0.45), [0, 0, -6]), builder.material('foot', '#d8cfbf', { roughness: 0.5 })),
  ];
  builder.object('/World/Foot', foot);
  builder.object(
    '/World/Bronze',
    [paint(sphere(0.9, { segments: 48, rings: 24, axis: 'Y' }), bronze)],
    at([0, 2.25, -6]),
  );
  builder.object(
    '/World/Passing',
    [paint(sphere(0.55, { segments: 32, rings: 16, axis: 'Y' }), clay)],
    sampled(0, 9, 24, (t) => ({
      position: [2.2, 0.55, 20 - 4 * t],
      orientation: fromAxisAngle([1, 0, 0], (-4 * t) / 0.55),
    })),
  );
  const vase: Part = [
    paint(
      turned(
        [
          [0.16, 0],
          [0.2, 0.06],
          [0.1, 0.16],
          [0.3, 0.42],
          [0.36, 0.66],
          [0.3, 0.86],
          [0.16, 0.98],
          [0.22, 1.08],
        ],
        32,
      ),
      clay,
    ),
  ];
  for (const side of [-1, 1])
    for (let k = 0; k < BAYS; k += 2)
      builder.object(
        `/World/Vase${side < 0 ? 'Left' : 'Right'}${k}`,
        vase,
        at([side * 3.6, 0, (k - BAYS / 2 + 0.5) * BAY]),
      );
}
