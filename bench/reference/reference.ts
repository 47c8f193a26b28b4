import { availableParallelism } from 'node:os';
import { nodeThreads } from '../../src/cli/pipelines/nodeThreads.ts';
import { length, scale, type Vec3 } from '../../src/math/vec3.ts';
import { openTracerPool } from '../../src/pipelines/referenceSession.ts';
import type { SpacetimeRay } from '../../src/reference/acceleration/ray.ts';
import { cameraRay } from '../../src/reference/camera/cameraRay.ts';
import { createTracedScene, nearestHit } from '../../src/reference/intersection/tracedScene.ts';
import { DEFAULT_LIGHT } from '../../src/reference/lights/lightOptions.ts';
import { renderTile } from '../../src/reference/tile.ts';
import type { TileRequest } from '../../src/reference/tileRequest.ts';
import { tilesOf } from '../../src/reference/tracerPool.ts';
import { withoutQuadric } from '../../src/scene/mesh/quadric.ts';
import type { ColorMode } from '../../src/scene/settings/settings.ts';
import type { Scene, SceneObject } from '../../src/scene/types.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings } from '../../src/scene/view/view.ts';
import { type Bench, interleaved, type Table, timed } from '../support/bench.ts';
import { SETTINGS } from '../support/gpu.ts';
import { C, sphereScene, VIEW } from '../support/scenes.ts';
import { plainBvh } from './plainBvh.ts';

const TRIANGLES = 140_000;
const FEW_TRIANGLES = 20_000;
const SAMPLES = [16, 64, 256, 1024, 4096];
const ROUNDS = 3;
/** Size of the picture, with one ray per pixel. */
const SIZE = { width: 240, height: 135 };
/** The spheres fill the picture, because rays that miss everything are cheap. */
const LOOK = { ...VIEW, lens: perspective(0.35) };
/** Relative difference of distances that is due to f32. */
const F32 = 1e-4;

export const reference: Bench = {
  name: 'reference',
  title: 'The reference renderer: rays per second',
  about:
    `Rays through the pixels of a ${SIZE.width} × ${SIZE.height} picture by an observer at 0.5 c, to the nearest surface; one thread. three-mesh-bvh gets the same rays and meshes, at rest, in one ` +
    'hierarchy built by the same heuristic. With motion a ray also solves for the event: of things at constant speed in their own frame, of sampled ones in spacetime triangles (250 samples). *Round solids*: the same spheres as the program draws them, without triangles. Over threads: ' +
    'whole pictures of the rigid scene with 2 × 2 samples, light and shadows; of colours, with one thread. Over samples: rays to fewer triangles, with more and more samples in the same ten seconds.',
  async run() {
    return [await againstStatic(), await overThreads(), await overColors(), await overSamples()];
  },
};

const rays = (): SpacetimeRay[] => {
  const { width, height } = SIZE;
  return Array.from(
    { length: width * height },
    (_, i) => cameraRay(LOOK, SETTINGS, (i % width) + 0.5, Math.floor(i / width) + 0.5, width, height)!,
  );
};

/** Traces all rays. */
function sender(scene: Scene): () => void {
  const traced = createTracedScene(scene, C);
  const all = rays();
  return () => {
    for (const ray of all) nearestHit(traced, ray);
  };
}

const millionPerSecond = (count: number, ms: number): number => count / ms / 1000;

/** The spheres as the triangles that they are in other hierarchies. */
function ofTriangles(scene: Scene): Scene {
  // One mesh, so that all share its tree.
  const mesh = withoutQuadric(scene.objects[0].mesh);
  return { ...scene, objects: scene.objects.map((object) => ({ ...object, mesh })) };
}

async function againstStatic(): Promise<Table> {
  const round = [sphereScene(TRIANGLES, 'static'), sphereScene(TRIANGLES, 'rigid')];
  const [still, rigid] = round.map(ofTriangles);
  const cast = plainBvh(still, C);
  const lines = rays().map(({ x, dx }): readonly [Vec3, Vec3] => [x, scale(dx, 1 / length(dx))]);
  agree(still, lines, cast);
  const plain = (): void => {
    for (const [from, direction] of lines) cast(from, direction);
  };
  const scenes: readonly (readonly [surfaces: string, motion: string, scene: Scene])[] = [
    ['triangles', 'static', still],
    ['triangles', 'uniform', coasting(still)],
    ['triangles', 'rigid', rigid],
    ['triangles', 'deforming', sphereScene(TRIANGLES, 'deforming')],
    ['round solids', 'static', round[0]],
    ['round solids', 'uniform', coasting(round[0])],
    ['round solids', 'rigid', round[1]],
  ];
  const [base, ...ours] = await interleaved([plain, ...scenes.map(([, , scene]) => sender(scene))], ROUNDS);
  const row = (by: string, surfaces: string, motion: string, ms: number) => [
    by,
    surfaces,
    motion,
    millionPerSecond(lines.length, ms),
    base / ms,
  ];
  return {
    columns: ['hierarchy', 'surfaces', 'motion', 'million rays/s', '÷ three-mesh-bvh'],
    rows: [
      row('three-mesh-bvh', 'triangles', 'static', base),
      ...ours.map((ms, i) => row('Slowlight', scenes[i][0], scenes[i][1], ms)),
    ],
    remark: `${trianglesOf(still).toLocaleString('en')} triangles in ${still.objects.length} objects; ${Math.round(100 * hitShare(still))} % of the rays meet one at rest.`,
  };
}

/** Throws unless both find the same surfaces. */
function agree(scene: Scene, lines: readonly (readonly [Vec3, Vec3])[], cast: ReturnType<typeof plainBvh>): void {
  const traced = createTracedScene(scene, C);
  const different = rays().filter((ray, i) => {
    const found = nearestHit(traced, ray);
    const [ours, theirs] = [found && found.s * length(ray.dx), cast(...lines[i])];
    if (ours === undefined || theirs === undefined) return ours !== theirs;
    return Math.abs(ours - theirs) > F32 * theirs;
  }).length;
  // At silhouettes f32 and f64 may differ.
  if (different > lines.length / 1000)
    throw new Error(`${different} of ${lines.length} rays hit other things than in three-mesh-bvh`);
}

function hitShare(scene: Scene): number {
  const traced = createTracedScene(scene, C);
  const all = rays();
  return all.filter((ray) => nearestHit(traced, ray)).length / all.length;
}

/** The same objects with different constant velocities up to c/2. */
function coasting(scene: Scene): Scene {
  const moving = (object: SceneObject, i: number): SceneObject => {
    if (object.motion.kind !== 'static') throw new Error(`${object.path} does not rest`);
    const velocity: Vec3 = [(C / 16) * i, 0, 0];
    // At its original place at the observer's time.
    const { position, orientation } = object.motion.pose;
    const pose = { position: [position[0] - velocity[0] * VIEW.t, position[1], position[2]] as const, orientation };
    return { ...object, motion: { kind: 'uniform', pose, velocity } };
  };
  return { ...scene, objects: scene.objects.map(moving) };
}

const trianglesOf = ({ objects }: Scene): number => objects.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);

async function overThreads(): Promise<Table> {
  const scene = ofTriangles(sphereScene(TRIANGLES, 'rigid'));
  const most = availableParallelism();
  const counts = [...new Set([1, 2, 4, 8, 16, 32, 64].filter((n) => n < most).concat(most))];
  const rows: (string | number)[][] = [];
  let alone = 0;
  for (const threads of counts) {
    const ms = await timeOfPicture(scene, threads);
    if (threads === 1) alone = ms;
    const samples = 4 * SIZE.width * SIZE.height;
    rows.push([String(threads), ms / 1000, millionPerSecond(samples, ms), alone / ms, alone / ms / threads]);
  }
  return { columns: ['threads', 'picture [s]', 'million samples/s', 'times as fast', 'per thread'], rows };
}

const request = (settings: RenderSettings): TileRequest => ({
  view: LOOK,
  settings,
  ...SIZE,
  layers: ['beauty'],
  samples: 2,
  seed: 0,
  light: DEFAULT_LIGHT,
});

/** Cost of spectral transport relative to three colours: higher if rays are cheap, and if every surface has its own frame. */
async function overColors(): Promise<Table> {
  const rows: (string | number)[][] = [];
  for (const kind of ['static', 'rigid'] as const) {
    const scene = createTracedScene(ofTriangles(sphereScene(FEW_TRIANGLES, kind)), C);
    const draw = (colors: ColorMode) => () => {
      renderTile(scene, request({ ...SETTINGS, colors }), { x0: 0, y0: 0, x1: SIZE.width, y1: SIZE.height });
    };
    const [tint, spectra] = await interleaved([draw('approximate'), draw('spectral')], ROUNDS);
    rows.push([kind, tint / 1000, spectra / 1000, spectra / tint]);
  }
  return { columns: ['motion', 'tint [s]', 'spectra [s]', 'spectra ÷ tint'], rows };
}

async function timeOfPicture(scene: Scene, threads: number): Promise<number> {
  const pool = openTracerPool(scene, C, threads, nodeThreads());
  const draw = (): Promise<void> => pool.render(request(SETTINGS), tilesOf(SIZE), () => {});
  // The first picture warms up the JIT and builds the structures of sampled motions.
  await draw();
  const ms = await timed(draw);
  await pool.close();
  return ms;
}

async function overSamples(): Promise<Table> {
  const rows: (string | number)[][] = [];
  const count = SIZE.width * SIZE.height;
  for (const samples of SAMPLES) {
    const works = (['rigid', 'deforming'] as const).map((kind) =>
      sender(ofTriangles(sphereScene(FEW_TRIANGLES, kind, samples))),
    );
    const [rigid, deforming] = await interleaved(works, ROUNDS);
    rows.push([String(samples), millionPerSecond(count, rigid), millionPerSecond(count, deforming)]);
  }
  return { columns: ['samples', 'rigid [million rays/s]', 'deforming [million rays/s]'], rows };
}
