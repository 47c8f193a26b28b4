import { fromAxisAngle } from '../../src/math/quat.ts';
import { random } from '../../src/math/random.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { makeMesh } from '../../src/scene/mesh/makeMesh.ts';
import { sphere, torus } from '../../src/scene/mesh/primitives.ts';
import type { Light, Mesh, Scene, Texture } from '../../src/scene/types.ts';
import { at, type Part, paint, place, placePart, SceneBuilder, sky } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, smoothRamp } from '../kit/flight.ts';
import { Canvas, linear, tone } from '../kit/paint.ts';
import { block, join, moved, quad, roundedBox, turned } from '../kit/parts.ts';

/** Half width, height of the walls, half length [m]; a barrel vault above. */
const [W, H, L] = [4.5, 4.6, 30];
const BAY = 6;
/** Number of the vault's 28 steps that are open along its crown, through which all light enters. */
const SKYLIGHT = 6;

export const scene: ExampleScene = { name: 'gallery', make };

function make(): Scene {
  const builder = new SceneBuilder();
  room(builder);
  pictures(builder);
  sculptures(builder);
  const [from, to] = [0, 9.5];
  const way = (t: number) => 26 - 46 * smoothRamp(t / to, 0.34);
  const flight = camera({
    from,
    to,
    fovY: 62,
    position: (t) => [-0.9 * Math.cos(0.35 * t), 1.8, way(t)],
    target: (t) => [0.3, 2.35, way(t) - 16],
  });
  const hints = {
    speedOfLight: 10,
    title: 'Gallery',
    lookFor:
      'Right angles everywhere, so that bending shows: frames lean, the vault flares, and pictures that you have passed turn their faces towards you. Their colours tell how fast you meet their light.',
    openAt: 0,
  };
  const [r, g, b] = linear('#fff3e0');
  const lights: Light[] = [
    { kind: 'distant', path: '/World/Skylight', direction: [0.28, -0.9, -0.33], color: [r * 1.7, g * 1.7, b * 1.7] },
    sky('#c3cfe4', '#eceef0', '#a7a49c'),
  ];
  return builder.finish('gallery', hints, [from, to], [flight], lights);
}

/** The inside of a barrel vault from z0 to z1: radius r about the axis at height h, without the `open` steps at its crown. */
function vault(r: number, h: number, z0: number, z1: number, steps: number, thick = 0, open = 0): Mesh {
  const points: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const faceIndices: number[] = [];
  for (let i = 0; i <= steps; i++) {
    const a = (Math.PI * i) / steps;
    for (const z of [z0, z1]) {
      points.push((r - thick) * Math.cos(a), h + (r - thick) * Math.sin(a), z);
      normals.push(-Math.cos(a), -Math.sin(a), 0);
      uvs.push((i / steps) * 4, z / 3);
    }
  }
  for (let i = 0; i < steps; i++) {
    const isCrown = Math.abs(i + 0.5 - steps / 2) < open / 2;
    if (!isCrown) faceIndices.push(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2);
  }
  const values = { normals: { per: 'point' as const, values: normals }, uvs: { per: 'point' as const, values: uvs } };
  const { mesh } = makeMesh({
    points,
    faceCounts: new Array<number>(faceIndices.length / 4).fill(4),
    faceIndices,
    ...values,
  });
  return { ...mesh, doubleSided: true };
}

/** The front of an arch: a flat half ring facing +Z (or −Z), between radii `inner` and `outer`. */
function archFace(inner: number, outer: number, h: number, z: number, facing: number, steps = 24): Mesh {
  const points: number[] = [];
  const faceIndices: number[] = [];
  for (let i = 0; i <= steps; i++) {
    const a = (Math.PI * i) / steps;
    for (const r of [inner, outer]) points.push(r * Math.cos(a), h + r * Math.sin(a), z);
  }
  for (let i = 0; i < steps; i++) {
    const face = [2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2];
    faceIndices.push(...(facing > 0 ? face : face.reverse()));
  }
  return makeMesh({ points, faceCounts: new Array<number>(steps).fill(4), faceIndices }).mesh;
}

function room(builder: SceneBuilder): void {
  const floor = builder.material('floor', '#ffffff', { texture: parquet(), roughness: 0.4 });
  const wall = builder.material('wall', '#6e2f35', { roughness: 0.95 });
  const dado = builder.material('dado', '#3b2a26', { roughness: 0.6 });
  const plaster = builder.material('plaster', '#ffffff', { texture: coffers(), roughness: 0.95 });
  const stone = builder.material('stone', '#d9cfbd', { roughness: 0.7 });
  const gilt = builder.material('gilt', '#c59a4a', { roughness: 0.35, metallic: 0.8, like: 'gold' });
  builder.object('/World/Floor', [paint(quad([-W, 0, L], [W, 0, L], [W, 0, -L], [-W, 0, -L], W, L), floor)]);
  const sides = [
    quad([-W, 0, L], [-W, 0, -L], [-W, H, -L], [-W, H, L]),
    quad([W, 0, -L], [W, 0, L], [W, H, L], [W, H, -L]),
  ];
  const ends = [-1, 1].map((s) =>
    quad([s * W, 0, s * L], [-s * W, 0, s * L], [-s * W, H + W, s * L], [s * W, H + W, s * L]),
  );
  const panels = [-1, 1].map((s) => paint(block(0.1, 0.95, 2 * L, 1, [s * (W - 0.05), 0, 0]), dado));
  const rails = [-1, 1].flatMap((s) => [
    paint(block(0.16, 0.08, 2 * L, 1, [s * (W - 0.08), 0.95, 0]), gilt),
    paint(block(0.4, 0.22, 2 * L, 1, [s * (W - 0.2), H - 0.22, 0]), stone),
  ]);
  builder.object('/World/Walls', [...[...sides, ...ends].map((m) => paint(m, wall)), ...panels, ...rails]);
  builder.object('/World/Vault', [paint(vault(W, H, -L, L, 28, 0, SKYLIGHT), plaster)]);
  for (let k = 0; k <= (2 * L) / BAY; k++)
    builder.object(`/World/Arch${k}`, placePart(arch(stone), place([0, 0, -L + BAY * k])));
}

/** Two pilasters and the rib between them. */
function arch(stone: number): Part {
  const deep = 0.3;
  const pilasters = [-1, 1].flatMap((s) => [
    block(0.35, H, 2 * deep, 1, [s * (W - 0.17), 0, 0]),
    block(0.5, 0.3, 2 * deep + 0.15, 1, [s * (W - 0.25), 0, 0]),
    block(0.5, 0.16, 2 * deep + 0.15, 1, [s * (W - 0.25), H - 0.4, 0]),
  ]);
  const rib = [
    vault(W, H, -deep, deep, 24, 0.32),
    archFace(W - 0.32, W, H, deep, 1),
    archFace(W - 0.32, W, H, -deep, -1),
  ];
  return [...pilasters.map((m) => paint(m, stone)), ...rib.map((m) => paint(m, stone))];
}

function parquet(): Texture {
  const canvas = new Canvas(128, 128, '#4d3524');
  const next = random(13);
  for (let j = 0; j < 4; j++)
    for (let i = 0; i < 4; i++)
      for (let k = 0; k < 4; k++) {
        const color = tone('#8e623c', 0.8 + 0.4 * next());
        const [x, y] = [i * 32, j * 32];
        if ((i + j) % 2 === 0) canvas.rect(x, y + k * 8, x + 32, y + k * 8 + 7, color);
        else canvas.rect(x + k * 8, y, x + k * 8 + 7, y + 32, color);
      }
  return canvas.grain(0.03).texture('parquet');
}

function coffers(): Texture {
  return new Canvas(64, 64, '#e4dccb')
    .rect(8, 8, 56, 56, '#bfb39b')
    .rect(12, 14, 56, 56, '#d3c8b2')
    .rect(14, 16, 54, 54, '#cabfa8')
    .grain(0.02, 2)
    .texture('coffers');
}

/** A different picture in each bay on both walls. */
function pictures(builder: SceneBuilder): void {
  const frame = builder.material('frame', '#b58a3f', { roughness: 0.4, metallic: 0.7, like: 'gold' });
  const mat = builder.material('mat', '#efe8da', { roughness: 0.9 });
  const kinds = [sunset, grid, waves, circles, spectrum, stripes];
  for (const side of [-1, 1])
    for (let k = 0; k < 10; k++) {
      const name = `Picture${side < 0 ? 'Left' : 'Right'}${k}`;
      const number = k + (side < 0 ? 0 : 3);
      const texture = kinds[number % kinds.length](name, 3 + number);
      const art = builder.material(name, '#ffffff', {
        texture: { ...texture, wrapS: 'clamp', wrapT: 'clamp' },
        roughness: 0.8,
      });
      const m = place([side * (W - 0.02), 2.55, L - BAY / 2 - BAY * k], side < 0 ? Math.PI / 2 : -Math.PI / 2);
      builder.object(`/World/${name}`, placePart(framed(2.7, 1.9, frame, mat, art), m));
    }
}

/** A picture w × h with mat and frame, back at z = 0, centred at the origin. */
function framed(w: number, h: number, frame: number, mat: number, art: number): Part {
  const [x, y, b] = [w / 2, h / 2, 0.16];
  const bars = [
    block(w + 2 * b, b, 0.12, 1, [0, y, 0.06]),
    block(w + 2 * b, b, 0.12, 1, [0, -y - b, 0.06]),
    block(b, h, 0.12, 1, [-x - b / 2, -y, 0.06]),
    block(b, h, 0.12, 1, [x + b / 2, -y, 0.06]),
  ];
  const flat = (k: number, z: number) =>
    quad([-x + k, -y + k, z], [x - k, -y + k, z], [x - k, y - k, z], [-x + k, y - k, z]);
  return [paint(join(bars), frame), paint(flat(0, 0.03), mat), paint(flat(0.18, 0.05), art)];
}

const [PW, PH] = [192, 128];

function sunset(name: string, seed: number): Texture {
  const next = random(seed);
  const sun = 0.3 + 0.4 * next();
  return new Canvas(PW, PH, '#000000')
    .shade((u, v) => {
      const d = Math.hypot((u - sun) * 1.5, v - 0.52);
      if (v > 0.38 && d < 0.11) return '#fff0c0';
      if (v > 0.38) return tone(v > 0.7 ? '#4b5d86' : v > 0.52 ? '#c9795f' : '#eda85c', 1.12 - 0.3 * d);
      const ripple = Math.sin(90 * v + 6 * Math.sin(9 * u));
      return tone(Math.abs(u - sun) < 0.1 + 0.05 * ripple ? '#e0935a' : '#33466b', 0.95 + 0.12 * ripple);
    })
    .texture(name);
}
function grid(name: string, seed: number): Texture {
  const next = random(seed);
  const canvas = new Canvas(PW, PH, '#f1ebdd');
  const colors = ['#c6372f', '#22498f', '#e6b93a', '#f1ebdd', '#f1ebdd', '#e7e0d0'];
  for (let x = 0; x < PW; x += 32)
    for (let y = 0; y < PH; y += 32)
      canvas.rect(x, y, x + 32 * (1 + Math.round(next())), y + 32, colors[Math.floor(next() * colors.length)]);
  for (let x = 0; x <= PW; x += 32) if (next() > 0.25) canvas.rect(x - 2, 0, x + 2, PH, '#1f1d1c');
  for (let y = 0; y <= PH; y += 32) canvas.rect(0, y - 2, PW, y + 2, '#1f1d1c');
  return canvas.texture(name);
}
function waves(name: string, seed: number): Texture {
  const colors = ['#12324a', '#1f5673', '#3f8797', '#8cbcb4', '#e9e3cf'];
  return new Canvas(PW, PH, '#000000')
    .shade(
      (u, v) =>
        colors[
          Math.max(0, Math.min(4, Math.floor(v * 6 + 0.7 * Math.sin(7 * u + seed) + 0.35 * Math.sin(19 * u + 2 * v))))
        ],
    )
    .texture(name);
}
function circles(name: string, seed: number): Texture {
  const next = random(seed);
  const discs = Array.from({ length: 9 }, () => ({
    x: next() * 1.5,
    y: next(),
    r: 0.08 + 0.2 * next(),
    c: ['#d96b3f', '#2f6f73', '#e7c25a', '#3a3f58', '#c9b8a0'][Math.floor(next() * 5)],
  }));
  return new Canvas(PW, PH, '#000000')
    .shade((u, v) => discs.find((d) => Math.hypot(u * 1.5 - d.x, v - d.y) < d.r)?.c ?? '#efe6d5')
    .texture(name);
}
function spectrum(name: string): Texture {
  const hues = ['#5a2d82', '#3049a0', '#2c86b8', '#3ea66b', '#a6c048', '#eacb3f', '#e88b34', '#c93d32', '#7d1f28'];
  return new Canvas(PW, PH, '#000000')
    .shade((u, v) => tone(hues[Math.min(8, Math.floor(u * 9))], 0.55 + 0.75 * v))
    .texture(name);
}
function stripes(name: string, seed: number): Texture {
  const next = random(seed);
  const colors = Array.from(
    { length: 14 },
    () => ['#254441', '#43aa8b', '#b2b09b', '#ef3054', '#ff9f1c', '#f4f1de'][Math.floor(next() * 6)],
  );
  return new Canvas(PW, PH, '#000000')
    .shade((u, v) => colors[Math.min(13, Math.floor((u * 0.8 + v * 0.2) * 14))])
    .texture(name);
}

/** Plinths along the room, beside the camera's path. */
function sculptures(builder: SceneBuilder): void {
  const stone = builder.material('plinth', '#cfc7b8', { roughness: 0.7 });
  const bronze = builder.material('bronze', '#8c5a32', { roughness: 0.3, metallic: 0.9, like: 'copper' });
  const marble = builder.material('marble', '#efebe3', { roughness: 0.4 });
  const enamel = builder.material('enamel', '#2f6f73', { roughness: 0.25 });
  const plinth = turned(
    [
      [0.5, 0],
      [0.5, 0.12],
      [0.4, 0.18],
      [0.38, 0.95],
      [0.46, 1.02],
      [0.46, 1.1],
    ],
    4,
  );
  const pieces: readonly (readonly [Mesh, number, number])[] = [
    [torus(0.42, 0.14, { segments: 48, rings: 20, axis: 'X' }), bronze, 0.56],
    [sphere(0.42, { segments: 40, rings: 20, axis: 'Y' }), marble, 0.42],
    [roundedBox([0.62, 0.62, 0.62], 0.05), enamel, 0.31],
    [
      turned(
        [
          [0.3, 0],
          [0.34, 0.1],
          [0.16, 0.3],
          [0.3, 0.55],
          [0.34, 0.75],
          [0.1, 1.0],
          [0.14, 1.1],
          [0, 1.12],
        ],
        32,
      ),
      marble,
      0,
    ],
  ];
  pieces.forEach(([mesh, material, lift], k) => {
    const position: Vec3 = [k % 2 === 0 ? 2.6 : -2.6, 0, 18 - 11 * k];
    builder.object(`/World/Plinth${k}`, placePart([paint(plinth, stone)], place(position, Math.PI / 4)));
    builder.object(
      `/World/Sculpture${k}`,
      [paint(moved(mesh, [0, 1.1 + lift, 0]), material)],
      at(position, fromAxisAngle([0, 1, 0], 0.6 * k)),
    );
  });
}
