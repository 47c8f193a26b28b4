import { expect, it } from 'vitest';
import { settingsFor, viewFrom } from '../../tests/support/rays.ts';
import { fromAxisAngle } from '../math/quat.ts';
import { dot, length, normalize, type Vec3 } from '../math/vec3.ts';
import { apparentPosition } from '../physics/optics/apparentPosition.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../scene/defaults.ts';
import { withMaterial } from '../scene/mesh/meshOps.ts';
import { box, plane, sphere } from '../scene/mesh/primitives.ts';
import type { Motion } from '../scene/types.ts';
import type { AovName } from '../scene/view/view.ts';
import { createTracedScene, type TracedScene } from './intersection/tracedScene.ts';
import { DEFAULT_LIGHT } from './lights/lightOptions.ts';
import { renderTile } from './tile.ts';
import type { ImageTile, TileRequest } from './tileRequest.ts';

const turning: Motion = {
  kind: 'sampled',
  times: Float64Array.of(-20, -15, -10, -5, 0),
  poses: Float64Array.from([0, 1, 2, 3, 4].flatMap((k) => [-1.5, 0, -6, ...fromAxisAngle([0, 1, 1], 0.5 * k)])),
};
const materials = [
  makeMaterial({ name: 'grey' }),
  makeMaterial({ name: 'pane', opacity: 0.5, baseColor: [1, 0, 0] }),
  makeMaterial({ name: 'gone', opacity: 0.3, opacityThreshold: 0.4 }),
];
const objects = [
  makeObject({ path: '/Ball', mesh: sphere(1, { segments: 12 }), motion: restingAt([1.5, 0, -6]) }),
  makeObject({ path: '/Turning', mesh: box([1, 2, 1]), motion: turning }),
  makeObject({
    path: '/Flying',
    mesh: box([1, 1, 1]),
    authoredIn: 'rest',
    motion: { kind: 'uniform', pose: { position: [4, -1, -5], orientation: [0, 0, 0, 1] }, velocity: [0.8, 0, 0] },
  }),
  makeObject({ path: '/Pane', mesh: withMaterial(plane(2, 9, 'Z'), 1), motion: restingAt([2, 0, -3]) }),
  makeObject({ path: '/Gone', mesh: withMaterial(plane(2, 9, 'Z'), 2), motion: restingAt([0, 0, -2]) }),
];
const scene: TracedScene = createTracedScene(makeScene({ name: 'test', objects, materials }), 1);
const [width, height] = [24, 16];
const request: TileRequest = {
  view: viewFrom({ u: [0.2, 0.1, -0.4] }),
  settings: settingsFor('light-cone'),
  width,
  height,
  layers: [
    'beauty',
    'picture',
    'depth',
    'object',
    'position',
    'emission_time',
    'velocity',
    'normal',
    'doppler',
    'albedo',
  ],
  samples: 2,
  seed: 11,
  light: DEFAULT_LIGHT,
};
const whole = renderTile(scene, request, { x0: 0, y0: 0, x1: width, y1: height });

it('a picture has the same bits however it is divided into tiles', () => {
  const again = createTracedScene(makeScene({ name: 'test', objects, materials }), 1);
  const cuts: ImageTile[] = [
    { x0: 10, y0: 0, x1: width, y1: 7 },
    { x0: 0, y0: 7, x1: width, y1: height },
    { x0: 0, y0: 0, x1: 10, y1: 7 },
  ];
  for (const tile of cuts) {
    const part = renderTile(again, request, tile);
    for (const [name, values] of Object.entries(part)) {
      const all = whole[name as AovName] ?? new Float32Array(0);
      const n = all.length / (width * height);
      for (let y = tile.y0; y < tile.y1; y++) {
        const row = values.slice((y - tile.y0) * (tile.x1 - tile.x0) * n, (y - tile.y0 + 1) * (tile.x1 - tile.x0) * n);
        expect(row, `${name}, row ${y}`).toEqual(all.slice((y * width + tile.x0) * n, (y * width + tile.x1) * n));
      }
    }
  }
});

it('the seed changes the noise, not the data', () => {
  const other = renderTile(scene, { ...request, seed: 12 }, { x0: 0, y0: 0, x1: width, y1: height });
  expect(other.beauty).not.toEqual(whole.beauty);
  expect(other.depth).toEqual(whole.depth);
});

it('the data of a pixel belong to one event of one object', () => {
  const { depth, object, position, emission_time: time, normal, doppler } = whole;
  if (!depth || !object || !position || !time || !normal || !doppler) return expect.fail('not all layers');
  const seen = new Set<number>();
  for (let i = 0; i < width * height; i++) {
    seen.add(object[i]);
    const at: Vec3 = [position[3 * i], position[3 * i + 1], position[3 * i + 2]];
    if (object[i] === 0) {
      expect([...at, depth[i], time[i], doppler[i]]).toEqual([0, 0, 0, 0, 0, 0]);
      continue;
    }
    expect(length(at)).toBeCloseTo(-time[i], 5);
    const apparent = apparentPosition(at, request.view.u);
    expect(length(apparent)).toBeCloseTo(depth[i], 5);
    // Its direction is that of the pixel's ray.
    const [x, y] = [((i % width) + 0.5) / width, (Math.floor(i / width) + 0.5) / height];
    const ray = normalize([(2 * x - 1) * (width / height), 1 - 2 * y, -1]);
    expect(dot(ray, normalize(apparent))).toBeCloseTo(1, 6);
    expect(Math.hypot(normal[3 * i], normal[3 * i + 1], normal[3 * i + 2])).toBeCloseTo(1, 6);
  }
  // Neither the alpha-blended pane nor what is cut out.
  expect([...seen].sort()).toEqual([0, 1, 2, 3]);
});

it('D = 1 in views without light', () => {
  const settings = settingsFor('simultaneity');
  const { doppler, object } = renderTile(
    scene,
    { ...request, settings, layers: ['doppler', 'object'] },
    { x0: 0, y0: 0, x1: width, y1: height },
  );
  expect(new Set(doppler)).toEqual(new Set([0, 1]));
  expect(doppler?.map((d, i) => d - Math.min(1, object?.[i] ?? 0)).every((x) => x === 0)).toBe(true);
});

it('an unlit surface shows its colour as it is written, whatever light falls on it, and shifts with the tone curve when it moves', () => {
  const orange: Vec3 = [1, 128 / 255, 0];
  const emissive = orange.map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4)) as unknown as Vec3;
  const unlit = makeMaterial({ name: 'sign', baseColor: [0, 0, 0], emissive, ior: 1, unlit: true });
  const sign = makeObject({ path: '/Sign', mesh: plane(20, 20, 'Z'), motion: restingAt([0, 0, -3]) });
  let signs = createTracedScene(makeScene({ name: 'sign', objects: [sign], materials: [unlit] }), 1);
  const middle = { x0: width / 2, y0: height / 2, x1: width / 2 + 1, y1: height / 2 + 1 };
  const shown = (u: Vec3): readonly number[] => {
    const { picture } = renderTile(signs, { ...request, layers: ['picture'], view: viewFrom({ u }) }, middle);
    return [...picture!].map((x) => 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
  };
  shown([0, 0, 0]).forEach((x, k) => {
    expect(Math.abs(x - 255 * orange[k])).toBeLessThan(0.01);
  });
  // Colours of vertices tint it.
  const white = makeMaterial({ name: 'white', baseColor: [0, 0, 0], emissive: [1, 1, 1], ior: 1, unlit: true });
  const colors = Float32Array.from(sign.mesh.positions, (_, i) => emissive[i % 3]);
  const painted = { ...sign, mesh: { ...sign.mesh, colors } };
  signs = createTracedScene(makeScene({ name: 'sign', objects: [painted], materials: [white] }), 1);
  shown([0, 0, 0]).forEach((x, k) => {
    expect(Math.abs(x - 255 * orange[k])).toBeLessThan(0.01);
  });
  // Towards it at 0.1 c, ln D = 0.1: the curve alone, below the white that clips.
  expect(Math.max(...shown([0, 0, -0.1005]))).toBeLessThan(252);
});

it('noise does not darken what is displayed: under a sky of 0.9 rough and smooth metals are 0.9', () => {
  const ball = (roughness: number): TracedScene =>
    createTracedScene(
      makeScene({
        name: 'furnace',
        objects: [makeObject({ path: '/Ball', mesh: sphere(4, { segments: 12 }), motion: restingAt([0, 0, -6]) })],
        materials: [makeMaterial({ name: 'metal', baseColor: [1, 1, 1], metallic: 1, roughness })],
        lights: [{ kind: 'dome', path: '/Sky', color: [0.9, 0.9, 0.9] }],
      }),
      1,
    );
  const furnace = {
    ...request,
    view: viewFrom({}),
    settings: { ...settingsFor('light-cone'), exposure: 0, tone: 'linear' },
    layers: ['picture', 'beauty'],
    width: 8,
    height: 8,
    samples: 4,
  } as const;
  for (const roughness of [0.2, 1]) {
    const { picture, beauty } = renderTile(ball(roughness), furnace, { x0: 0, y0: 0, x1: 8, y1: 8 });
    const mean = (values: Float32Array | undefined): number => values!.reduce((sum, value) => sum + value) / 192;
    expect(Math.abs(mean(beauty) - 0.9)).toBeLessThan(0.02);
    expect(Math.abs(mean(picture) - 0.9)).toBeLessThan(0.03);
  }
});
