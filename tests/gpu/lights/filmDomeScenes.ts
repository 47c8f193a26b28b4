import { fromAxisAngle, IDENTITY } from '../../../src/math/quat.ts';
import { normalize, scale, type Vec3 } from '../../../src/math/vec3.ts';
import { type DomeMeans, domeMaps } from '../../../src/render/lights/sky/domeMaps.ts';
import type { SceneRenderer } from '../../../src/render/renderer.ts';
import { directionFromLatLong } from '../../../src/scene/lights/latLong.ts';
import { sphere } from '../../../src/scene/mesh/primitives.ts';
import type { DomePicture, Scene } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { dome, GREY, lambert, lit, mirror } from '../../support/lightKit.ts';

// A film's dome behind and on balls: for Dawn, and for WebGL2 in a page.

/** Of pictures [px]. */
export const SIZE = 48;
const [COLUMNS, ROWS] = [128, 64];

/** A frame: spots of colour of its own. */
function frame(k: number): DomePicture {
  const data = new Uint8Array(4 * COLUMNS * ROWS);
  for (let i = 0; i < COLUMNS * ROWS; i++) {
    const n = directionFromLatLong(((i % COLUMNS) + 0.5) / COLUMNS, 1 - (Math.floor(i / COLUMNS) + 0.5) / ROWS);
    const levels = n.map((x, axis) =>
      Math.round(127 + 120 * Math.sin((3 + k) * x + (axis + 2 * k) * n[(axis + 1) % 3]!)),
    );
    data.set([...levels, 255], 4 * i);
  }
  const how = { colorSpace: 'srgb', filter: 'linear', wrapS: 'repeat', wrapT: 'clamp' } as const;
  return { name: `frame ${k}`, width: COLUMNS, height: ROWS, data, ...how };
}

export interface FilmDomeCase {
  /** [c] Of a glossy ball. */
  readonly velocity: Vec3;
  readonly means: DomeMeans;
}

/** Resting balls, matt and rough, and a glossy one, before frame `k`. */
function sceneOf({ velocity }: FilmDomeCase, k: number): Scene {
  const ball = (at: Vec3, material: ReturnType<typeof lambert>, v: Vec3 = [0, 0, 0]) => {
    // Light from where it is seen has been under way for 4 s.
    const pose = { position: [at[0] + 4 * v[0], at[1] + 4 * v[1], at[2] + 4 * v[2]], orientation: IDENTITY } as const;
    const moves = v.some((x) => x !== 0);
    const motion = moves ? ({ kind: 'uniform', pose, velocity: v } as const) : ({ kind: 'static', pose } as const);
    return { mesh: sphere(0.7, { segments: 32, rings: 16 }), material, motion };
  };
  const things = [
    ball([-1, 0.8, 0], lambert(0.8)),
    ball([1, 0.8, 0], mirror({ roughness: 0.6 })),
    ball([0, -0.8, 0], mirror({ roughness: 0.3 }), velocity),
  ];
  const sky = { ...dome([1, 1, 1]), texture: frame(k), orientation: fromAxisAngle(normalize([1, 2, 3]), 1) };
  return lit(things, [sky]).scene;
}

const VIEW: ViewPoint = {
  ...{ t: 0, position: [0, 0, 4], u: scale([0.1, 0, -1], 0.2), orientation: IDENTITY, lens: perspective(1.2) },
};
const SETTINGS: RenderSettings = { ...GREY, grid: false, occlusionRadius: 0 };

/** Radiance, and what is shown of it. */
async function drawn(renderer: SceneRenderer): Promise<number[]> {
  renderer.render([VIEW], SETTINGS, 1);
  const [beauty, pixels] = [await renderer.readAov('beauty'), await renderer.readPixels()];
  return [...beauty, ...pixels];
}

/** Pictures of one scene, before several frames. */
export interface FilmDomePictures {
  /** Opened with frame 0, then with frame 1. */
  readonly opened: readonly [number[], number[]];
  /** Opened with frame 0, then frames 1, 0 and 1 are shown. */
  readonly shown: readonly number[][];
  /** Frame 1 was shown before the first picture. */
  readonly early: number[];
  /** Opened again, after another was shown. */
  readonly again: number[];
}

export async function filmDomePictures(
  renderer: SceneRenderer,
  given: FilmDomeCase,
  next: () => void = () => undefined,
): Promise<FilmDomePictures> {
  const [first, second] = [sceneOf(given, 0), sceneOf(given, 1)];
  const maps = [0, 1].map((k) => domeMaps(frame(k), given.means));
  const draw = (): Promise<number[]> => {
    next();
    return drawn(renderer);
  };
  await renderer.setScene(first);
  const opened = await draw();
  const shown: number[][] = [];
  for (const k of [1, 0, 1]) {
    renderer.showDome(maps[k]!);
    shown.push(await draw());
  }
  await renderer.setScene(first);
  const again = await draw();
  await renderer.setScene(second);
  const other = await draw();
  await renderer.setScene({ ...first });
  renderer.showDome(maps[1]!);
  return { opened: [opened, other], shown, early: await draw(), again };
}
