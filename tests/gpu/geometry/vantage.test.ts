import { perspectiveOf } from '../../../src/scene/view/lenses/lenses.ts';
import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { conjugate, IDENTITY, rotate } from '../../../src/math/quat.ts';
import { add, addScaled, distance, length, scale, sub, type Vec3 } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { apparentPosition } from '../../../src/physics/optics/apparentPosition.ts';
import { emissionEvent } from '../../../src/physics/worldLines/lightCone.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { visibleHit } from '../../../src/reference/camera/visibleHit.ts';
import { createTracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { box, grid, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { Mesh, Scene } from '../../../src/scene/types.ts';
import { lookAtOrientation } from '../../../src/scene/view/camera.ts';
import { frustumOf, perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { ViewPoint } from '../../../src/scene/view/view.ts';
import { DEFAULT_SETTINGS, type RenderSettings } from '../../../src/scene/view/view.ts';
import { EXTRA_SCENES } from '../../visual/extraScenes.ts';
import { extraFrame } from '../../visual/frames.ts';
import { shownAt } from '../../visual/pixelOracle.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = { width: 96, height: 64 };
const C = 10;
const PLAIN: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: C, shadows: false, occlusionRadius: 0 };
let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE.width, SIZE.height);
});
afterAll(() => headless?.close());

interface Picture {
  readonly object: Float32Array;
  readonly position: Float32Array;
  readonly depth: Float32Array;
}

async function pictureOf(scene: Scene, view: ViewPoint, settings: RenderSettings): Promise<Picture> {
  const { renderer } = headless;
  await renderer.setScene(scene);
  pumpFrame();
  renderer.render([view], settings, 1);
  const [object, position, depth] = [
    await renderer.readAov('object'),
    await renderer.readAov('position'),
    await renderer.readAov('depth'),
  ];
  return { object, position, depth };
}

/** One of each kind of motion; behind a horizon; round solids; instances. */
const WHEEL = 'turning wheel';
const TRIED = EXTRA_SCENES.filter(
  ({ scene: { name } }) => name === WHEEL || !/cube|behind|walls|proportions/.test(name),
);

/** Of pixels, those that show another object, or the same at another distance. */
function different(a: Picture, b: Picture): number {
  const wrong = a.object.filter((id, i) => id !== b.object[i] || Math.abs(a.depth[i] - b.depth[i]) > 0.02 * b.depth[i]);
  return wrong.length / a.object.length;
}

const shares = ({ object }: Picture): number => object.filter((id) => id > 0).length / object.length;

/** Reflects nothing as a mirror does: its light is the same from everywhere. */
const MATTE = makeMaterial({ name: 'matte', baseColor: [0.6, 0.5, 0.4], ior: 1, roughness: 1 });
const FLOOR = { path: '/Floor', mesh: grid(30, 30, 3, 3, 'Y'), motion: restingAt([0, -1, -6]) };
const LOOKING = lookAtOrientation([-1, -0.4, -1], [0, 1, 0]);

const AT_REST = makeScene({
  name: 'at rest',
  materials: [MATTE, makeMaterial({ ...MATTE, name: 'dark', baseColor: [0.1, 0.2, 0.3] })],
  objects: [
    makeObject(FLOOR),
    makeObject({ path: '/Box', mesh: withMaterial(box([1, 2, 1]), 1), motion: restingAt([0.5, 0, -5]) }),
    makeObject({ path: '/Ball', mesh: withMaterial(sphere(0.8), 1), motion: restingAt([-1.5, 0, -4]) }),
  ],
});
const AT_EASE = { t: 0, u: [0, 0, 0], orientation: LOOKING, lens: perspective(1.2) } as const;

describe('what is seen, looked at from elsewhere', () => {
  it('is, of a world at rest, the picture that an observer there has', async () => {
    const position: Vec3 = [0.3, 0.4, 1];
    const vantage: Vec3 = [4, 1.5, -1];
    const shaded = { ...PLAIN, occlusionRadius: 2 };
    const aside = await pictureOf(AT_REST, { ...AT_EASE, position, vantage }, shaded);
    const openAside = await headless.renderer.readAov('occlusion');
    const there = await pictureOf(AT_REST, { ...AT_EASE, position: add(position, vantage) }, shaded);
    const openThere = await headless.renderer.readAov('occlusion');
    expect(shares(there)).toBeGreaterThan(0.5);
    expect(different(aside, there)).toBe(0);
    // Corners are dark, and equally so.
    expect(Math.min(...openThere.filter((_, i) => there.object[i] > 0))).toBeLessThan(0.8);
    const apart = openAside.filter((open, i) => Math.abs(open - openThere[i]) > 0.02);
    expect(apart.length / openAside.length).toBeLessThan(0.01);
  });

  it('also where it is blended with earlier pictures while the camera walks', async () => {
    const position: Vec3 = [0.3, 0.4, 1];
    const { renderer } = headless;
    const walked = async (viewAt: (offset: Vec3) => ViewPoint) => {
      await renderer.setScene(AT_REST);
      // Sample positions repeat after so many pictures.
      for (let k = 0; k < 16; k++) {
        pumpFrame();
        renderer.render([viewAt([4 - 0.03 * k, 1.5, -1 + 0.02 * k])], PLAIN, 'temporal');
      }
      return renderer.readPixels();
    };
    const aside = await walked((vantage) => ({ ...AT_EASE, position, vantage }));
    const there = await walked((offset) => ({ ...AT_EASE, position: add(position, offset) }));
    const apart = aside.filter((value, i) => Math.abs(value - there[i]) > 4);
    expect(apart.length / aside.length).toBeLessThan(0.005);
  });

  // Independent of the rasterizer's boosts: the same image as an ordinary scene at rest, of points placed by closed forms.
  it('is the ordinary picture of a scene that is built of apparent places', async () => {
    const u = properVelocity([0.3, 0, -0.8]);
    const position: Vec3 = [0, 0.5, 2];
    const velocity: Vec3 = [6, 0, 2];
    const fine = fineBox(1, 24);
    const moving = { kind: 'uniform', pose: { position: [-1, 0, -5], orientation: IDENTITY }, velocity } as const;
    const scene = makeScene({
      name: 'moving',
      objects: [
        makeObject({ ...FLOOR, mesh: box([30, 0.1, 30]) }),
        makeObject({ path: '/Box', mesh: box([1, 1, 1]), motion: moving, authoredIn: 'world' }),
        makeObject({ path: '/Other', mesh: box([1, 1, 1]), motion: restingAt([1.5, 0, -3]) }),
      ],
    });
    const placed = (mesh: Mesh, at: Vec3, v: Vec3): Mesh => {
      const positions = Float32Array.from(mesh.positions);
      for (let i = 0; i < positions.length; i += 3) {
        const p = add([mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]], at);
        const line = { kind: 'uniform', position: p, velocity: v } as const;
        const event = emissionEvent(line, { t: 0, position }, C)!;
        positions.set(apparentPosition(event.offset, u), i);
      }
      return { ...mesh, positions };
    };
    const still = (path: string, mesh: Mesh) => makeObject({ path, mesh, motion: restingAt([0, 0, 0]) });
    const snapshot = makeScene({
      name: 'snapshot',
      objects: [
        still('/Floor', placed(fineBox(1, 60, [30, 0.1, 30]), [0, -1, -6], [0, 0, 0])),
        still('/Box', placed(fine, [-1, 0, -5], velocity)),
        still('/Other', placed(fine, [1.5, 0, -3], [0, 0, 0])),
      ],
    });
    const vantage: Vec3 = [5, 2, -4];
    const eye = { t: 0, orientation: LOOKING, lens: perspective(1.4) } as const;
    const aside = await pictureOf(scene, { ...eye, u, position, vantage }, PLAIN);
    const built = await pictureOf(snapshot, { ...eye, u: [0, 0, 0], position: vantage }, PLAIN);
    expect(new Set(built.object)).toEqual(new Set([0, 1, 2, 3]));
    // Outlines are those of a finer mesh.
    expect(different(aside, built)).toBeLessThan(0.012);
  });

  it.each(TRIED.map((extra) => [extra.scene.name, extra] as const))(
    '%s, at 0.9 c: every pixel is where its event is shown',
    async (name, extra) => {
      // The wheel has parts of all speeds: it stands for the others in the other views.
      const others = name === WHEEL ? (['simultaneity', 'slice-to-cone'] as const) : [];
      for (const view of ['light-cone', ...others] as const) {
        const frame = extraFrame(extra, view, 0.9);
        const { u, position } = frame.view;
        const middle = shownAt(sub(extra.subject, position), u, frame.settings);
        // A quarter of the way to the subject, and to the side, looking at it.
        const vantage = addScaled(scale(middle, 0.25), [0, 1, 0], 0.3 * length(middle));
        const toSubject = sub(middle, vantage);
        const eye = { ...frame.view, vantage, orientation: lookAtOrientation(toSubject, [0, 1, 0]) };
        const picture = await pictureOf(extra.scene, eye, frame.settings);
        expect(shares(picture), view).toBeGreaterThan(0.02);
        expect(unlikeReference(picture, extra.scene, eye, frame.settings), view).toBeLessThan(0.01);
        const { displacement, depth } = worst(picture, eye, frame.settings);
        expect(displacement, view).toBeLessThan(0.5);
        expect(depth, view).toBeLessThan(1e-3);
      }
    },
  );
});

/** The greatest distance [px] of where events are shown from the pixels that show them, and of their distances, relative. */
function worst({ object, position, depth }: Picture, view: ViewPoint, settings: RenderSettings) {
  const { width, height } = SIZE;
  const { tanX, tanY } = frustumOf(perspectiveOf(view.lens), width, height);
  const result = { displacement: 0, depth: 0 };
  object.forEach((id, i) => {
    if (id === 0) return;
    const at: Vec3 = [position[3 * i], position[3 * i + 1], position[3 * i + 2]];
    const shown = sub(shownAt(sub(at, view.position), view.u, settings), view.vantage!);
    const [x, y, z] = rotate(conjugate(view.orientation), shown);
    const across = ((x / -z / tanX + 1) * width) / 2 - 0.5 - (i % width);
    const down = ((1 - y / -z / tanY) * height) / 2 - 0.5 - Math.floor(i / width);
    result.displacement = Math.max(result.displacement, Math.hypot(across, down));
    result.depth = Math.max(result.depth, Math.abs(depth[i] / length(shown) - 1));
  });
  return result;
}

/** The share of pixels that show another object than the reference finds there, at the centre and at the corners: outlines are tessellated. */
function unlikeReference({ object }: Picture, scene: Scene, view: ViewPoint, settings: RenderSettings): number {
  const { width, height } = SIZE;
  const traced = createTracedScene(scene, settings.speedOfLight);
  const shownAt = (x: number, y: number): number =>
    (visibleHit(traced, cameraRay(view, settings, x, y, width, height)!)?.object ?? -1) + 1;
  const wrong = object.filter((id, i) => {
    const [x, y] = [(i % width) + 0.5, Math.floor(i / width) + 0.5];
    const around = [-0.4, 0.4].flatMap((dx) => [-0.4, 0.4].map((dy) => [dx, dy] as const));
    return shownAt(x, y) !== id && around.every(([dx, dy]) => shownAt(x + dx, y + dy) !== id);
  });
  return wrong.length / object.length;
}

function withMaterial(mesh: Mesh, material: number): Mesh {
  return { ...mesh, groups: mesh.groups.map((group) => ({ ...group, material })) };
}

/** A box whose faces are n × n quads. */
function fineBox(size: number, n: number, [x, y, z]: Vec3 = [size, size, size]): Mesh {
  const face = grid(1, 1, n, n, 'Z');
  const turns: readonly ((p: Vec3) => Vec3)[] = [
    ([a, b]) => [a * x, b * y, z / 2],
    ([a, b]) => [-a * x, b * y, -z / 2],
    ([a, b]) => [x / 2, b * y, -a * z],
    ([a, b]) => [-x / 2, b * y, a * z],
    ([a, b]) => [a * x, y / 2, -b * z],
    ([a, b]) => [a * x, -y / 2, b * z],
  ];
  const corners = face.positions.length / 3;
  const at = (i: number): Vec3 => [face.positions[3 * i], face.positions[3 * i + 1], face.positions[3 * i + 2]];
  const points = turns.flatMap((turn) => Array.from({ length: corners }, (_, i) => turn(at(i))));
  const indices = turns.flatMap((_, f) => Array.from(face.indices, (i) => i + f * corners));
  return {
    ...face,
    positions: Float32Array.from(points.flat()),
    normals: Float32Array.from(points.flatMap((p) => scale(p, 1 / Math.max(distance(p, [0, 0, 0]), 1e-9)))),
    uvs: new Float32Array(2 * points.length),
    indices: Uint32Array.from(indices),
    groups: [{ start: 0, count: indices.length, material: 0 }],
    doubleSided: true,
  };
}
