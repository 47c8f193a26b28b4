import { IDENTITY } from '../../../src/math/quat.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import type { SceneRenderer } from '../../../src/render/renderer.ts';
import { makeObject, makeScene } from '../../../src/scene/defaults.ts';
import { deformedNormals, smoothingGroups } from '../../../src/scene/mesh/normals.ts';
import { sphere } from '../../../src/scene/mesh/primitives.ts';
import type { SampledPointsMotion, Scene } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type ViewPoint } from '../../../src/scene/view/view.ts';
import { leftInFile } from '../../support/streamed.ts';

export const SIZE = 72;
/** Texels for samples: for 40 of the 150; a picture needs up to 33. */
export const FEW_TEXELS = 40 * 4096;

/** Where the samples are: all on the GPU, a few of them, a few streamed from a file, streamed by a worker. */
export type SampleStorage = 'whole' | 'ring' | 'file' | 'worker';

/** Forward, backward, and jumps larger than the ring, alternately at rest and at 0.9 c. */
export const STREAMING_VIEWS = [2, 2.1, 2.4, 9, 9.1, 8.7, 8.3, 14.9, 0, 3].map((t, i) => ({
  t: t + 5,
  beta: (i % 2 ? [0.3, 0, -0.85] : [0, 0, 0]) as Vec3,
}));

const mesh = sphere(1, { segments: 24 });
const PERIOD = 0.1;

function waving(): SampledPointsMotion {
  const groups = smoothingGroups(mesh);
  const times = Float64Array.from({ length: 150 }, (_, k) => PERIOD * k);
  const points = Array.from(times, (t) =>
    mesh.positions.map((x, i) => x + 0.25 * Math.sin(2 * t + mesh.positions[i - (i % 3) + 1] + i)),
  );
  const normals = points.map((p) => deformedNormals(p, mesh.indices, groups));
  return { kind: 'sampled-points', times, origin: [0, 0, -5], points, normals };
}

const blobOf = (bytes: Uint8Array<ArrayBuffer>): Blob => new Blob([bytes]);

export function sceneIn(form: SampleStorage): Scene {
  const motion = form === 'file' ? leftInFile(waving()) : form === 'worker' ? leftInFile(waving(), blobOf) : waving();
  return makeScene({ name: form, objects: [makeObject({ path: '/waving', mesh, motion })] });
}

export const viewOf = ({ t, beta }: (typeof STREAMING_VIEWS)[number]): ViewPoint => ({
  t,
  position: [0, 0, 0],
  u: properVelocity(beta),
  orientation: IDENTITY,
  lens: perspective(0.9),
});

const SETTINGS = { ...DEFAULT_SETTINGS, speedOfLight: 1 };

/** Two views of one picture whose samples do not fit into few texels together, 7 s apart. */
const PAIR = [STREAMING_VIEWS[0], STREAMING_VIEWS[3]] as const;

export async function renderStreamingPair(renderer: SceneRenderer, form: SampleStorage): Promise<number[]> {
  renderer.setSize(2 * SIZE, SIZE);
  await renderer.setScene(sceneIn(form));
  const eye = (i: 0 | 1) => ({ ...viewOf(PAIR[i]), viewport: { x: i * SIZE, y: 0, width: SIZE, height: SIZE } });
  const draw = () => renderer.render([eye(0), eye(1)], SETTINGS);
  draw();
  while (renderer.info.waiting) {
    await new Promise((done) => setTimeout(done, 2));
    draw();
  }
  return [...(await renderer.readAov('position')), ...(await renderer.readAov('beauty'))];
}

/** Position, emission time and picture of each view, concatenated. */
export async function renderStreamingViews(renderer: SceneRenderer, form: SampleStorage): Promise<number[][]> {
  renderer.setSize(SIZE, SIZE);
  await renderer.setScene(sceneIn(form));
  const seen: number[][] = [];
  for (const view of STREAMING_VIEWS) {
    renderer.render([viewOf(view)], SETTINGS);
    while (renderer.info.waiting) {
      await new Promise((done) => setTimeout(done, 2));
      renderer.render([viewOf(view)], SETTINGS);
    }
    const parts = [
      await renderer.readAov('position'),
      await renderer.readAov('emission_time'),
      await renderer.readAov('beauty'),
    ];
    seen.push(parts.flatMap((part) => Array.from(part)));
  }
  return seen;
}
