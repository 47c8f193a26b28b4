import { existsSync, readFileSync } from 'node:fs';
import { setTimeout as sleep } from 'node:timers/promises';
import { openSceneFile } from '../../src/cli/files/sceneFiles.ts';
import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import { memorySource } from '../../src/formats/files/fileSource.ts';
import { sceneFormats } from '../../src/formats/registry.ts';
import { properVelocity } from '../../src/physics/lorentz/boost.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import type { LoadTask } from '../formats/readers.ts';
import type { CachePlayback, CacheTask } from '../simulation/cache.ts';
import { type ClothTask, type FallTask, fallingBy, measureFall } from '../simulation/dynamics.ts';
import { interleaved, median, timed } from './bench.ts';
import { openRenderer, releaseGpu, SETTINGS } from './gpu.ts';
import { sphereScene } from './scenes.ts';

const AT_REST = { u: properVelocity([0, 0, 0]) };
const AT_SPEED = { u: properVelocity([0, 0, -0.9]) };

/** Pictures of a long cache. */
const PICTURES = 24;

/** Tasks that are measured in a child process, for its memory. Prints one line of JSON. */
const [task, argument] = process.argv.slice(2);
if (task === 'load') await load(JSON.parse(argument) as LoadTask);
else if (task === 'three') await three(argument);
else if (task === 'instances') await instances(argument);
else if (task === 'cache') await playCache(JSON.parse(argument) as CacheTask);
else if (task === 'memory') await memory(Number(argument));
else if (task === 'dynamics') await clothMemory(JSON.parse(argument) as ClothTask);
else if (task === 'fall') console.log(JSON.stringify(await measureFall(JSON.parse(argument) as FallTask)));
else throw new Error(`no task ${task}`);

async function load({ file, inMemory, subdivision }: LoadTask): Promise<void> {
  const empty = memorySource({});
  await Promise.allSettled(sceneFormats.map(({ read }) => read(empty, 'none', {})));
  await tell(() =>
    openSceneFile(file, {
      ...(subdivision !== undefined && { subdivision }),
      ...(inMemory && { sampleMemory: 2 ** 40 }),
    }),
  );
}

async function three(path: string): Promise<void> {
  const { threeLoader } = await import('../formats/threeLoad.ts');
  const read = threeLoader(path);
  // A large file has its own ArrayBuffer.
  await tell(() => read(readFileSync(path).buffer as ArrayBuffer));
}

/** Time and memory of reading, or why it fails. */
async function tell(read: () => unknown): Promise<void> {
  const before = await resident();
  const began = performance.now();
  try {
    await read();
    const seconds = (performance.now() - began) / 1000;
    console.log(JSON.stringify({ seconds, bytes: peakMemory() - before }));
  } catch (error) {
    console.log(JSON.stringify({ refusal: `fails: ${String(error).split('\n')[0]}` }));
  }
}

/** Reads a file and draws it at rest and at 0.9 c. */
async function instances(path: string): Promise<void> {
  const { renderer, frame } = await openRenderer(640, 360);
  const before = await resident();
  const began = performance.now();
  const scene = await openSceneFile(path);
  const load = performance.now() - began;
  const loaded = (await resident()) - before;
  const upload = await timed(async () => {
    await renderer.setScene(scene);
    await frame({}, AT_REST);
  });
  const [still, fast] = await interleaved([() => frame({}, AT_REST), () => frame({}, AT_SPEED)], 5);
  const bytes = (await resident()) - before;
  const { triangles } = renderer.info;
  console.log(JSON.stringify({ load, loaded, upload, resident: bytes, still, fast, triangles }));
  renderer.dispose();
  await releaseGpu();
}

/** The whole cloth from above, at successive samples. */
async function playCache({ file, inMemory }: CacheTask): Promise<void> {
  const began = performance.now();
  const scene = await openSceneFile(file, { subdivision: 0, ...(inMemory && { sampleMemory: 2 ** 40 }) });
  const load = performance.now() - began;
  const loadedBytes = await resident();
  const { renderer } = await openRenderer(480, 270);
  await renderer.setScene(scene);
  const picture = (k: number): Promise<number> =>
    timed(async () => {
      pumpFrame();
      const t = (100 + k) / scene.timeCodesPerSecond;
      renderer.render(
        [{ t, position: [0, 0, 6], u: [0, 0, 0], orientation: [0, 0, 0, 1], lens: perspective(0.9) }],
        SETTINGS,
      );
      await renderer.readPixels();
    });
  const first = await picture(0);
  const times: number[] = [];
  for (let k = 1; k <= PICTURES; k++) times.push(await picture(k));
  const played: CachePlayback = { load, loadedBytes, first, frame: median(times), peakBytes: peakMemory() };
  console.log(JSON.stringify(played));
  renderer.dispose();
  await releaseGpu();
}

/** Peak memory of this process: the operating system's `maxRSS` includes that of the parent at the fork. */
function peakMemory(): number {
  const status = existsSync('/proc/self/status') ? readFileSync('/proc/self/status', 'utf8') : '';
  const kibibytes = /VmHWM:\s+(\d+)/.exec(status)?.[1] ?? process.resourceUsage().maxRSS;
  return Number(kibibytes) * 1024;
}

/** Resident bytes of rendering a deforming scene, without its own arrays. */
async function memory(samples: number): Promise<void> {
  const scene = sphereScene(100_000, 'deforming', samples);
  const { renderer, frame } = await openRenderer(64, 36);
  const before = await resident();
  await renderer.setScene(scene);
  await frame();
  await frame();
  const vertices = scene.objects.reduce((sum, { mesh }) => sum + mesh.positions.length / 3, 0);
  console.log(JSON.stringify({ vertices, bytes: (await resident()) - before }));
  renderer.dispose();
  await releaseGpu();
}

/** Resident bytes of a cloth, its springs and a method's work arrays. */
async function clothMemory({ side, method }: ClothTask): Promise<void> {
  const before = await resident();
  const { fall } = fallingBy({ method, side, mass: 1, parts: 1 });
  fall();
  console.log(JSON.stringify({ bytes: (await resident()) - before }));
  fall();
}

async function resident(): Promise<number> {
  for (let i = 0; i < 3; i++) {
    globalThis.gc?.();
    await sleep(50);
  }
  return process.memoryUsage().rss;
}
