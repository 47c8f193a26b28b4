import { fileURLToPath } from 'node:url';
import { openSceneFile } from '../../src/cli/files/sceneFiles.ts';
import { nodeThreads } from '../../src/cli/pipelines/nodeThreads.ts';
import { ExposureMeter } from '../../src/nodes/pictures/exposureMeter.ts';
import { PictureMeter } from '../../src/nodes/pictures/pictureMeter.ts';
import type { PipelineHost } from '../../src/pipelines/host.ts';
import { type OptionValues, withDefaults } from '../../src/pipelines/options.ts';
import type { PictureRequest } from '../../src/pipelines/pictureRenderer.ts';
import type { PipelineSession } from '../../src/pipelines/pipeline.ts';
import { REFERENCE_OPTIONS } from '../../src/pipelines/referenceOptions.ts';
import { openReferenceSession } from '../../src/pipelines/referenceSession.ts';
import { flip } from '../../src/reference/compare/flip.ts';
import type { RgbImage } from '../../src/reference/compare/rgbImage.ts';
import type { Scene } from '../../src/scene/types.ts';
import { observerFromCamera } from '../../src/scene/view/camera.ts';
import { DEFAULT_SETTINGS } from '../../src/scene/view/view.ts';
import { decodeSrgb } from '../../src/spectrum/display/srgb.ts';
import { type Bench, cpuTimed } from '../support/bench.ts';

const SIZE = { width: 128, height: 72 };
/** Noise of its own, so that no other picture shares it. */
const TRUTH = { samples: 16, seed: 1 };
const SCENES = ['hall', 'lamps', 'saturn'];

/** A way to render; `samples`: n, for at most n × n per pixel. */
interface Method {
  readonly name: string;
  readonly samples: number;
  readonly options: OptionValues;
}

const UNIFORM = [1, 2, 3, 4, 6, 8].map(
  (samples): Method => ({ name: `${samples} × ${samples}`, samples, options: {} }),
);
const OTHERS: readonly Method[] = [
  { name: 'at most 8 × 8, adaptive, 0.04', samples: 8, options: { noiseThreshold: 0.04, minSamples: 2 } },
  ...[1, 2, 4].map((samples) => ({
    name: `${samples} × ${samples}, denoised`,
    samples,
    options: { denoise: true },
  })),
];

export const noise: Bench = {
  name: 'noise',
  title: 'The reference renderer: noise',
  about:
    `Examples in ${SIZE.width} × ${SIZE.height} pixels at rest: processor time of a picture, all threads together, and its mean ꟻLIP against one of ${TRUTH.samples} × ${TRUTH.samples} samples with another seed, whose own noise is in all figures. ` +
    '*Of uniform at equal ꟻLIP*: that time relative to the time in which n × n samples everywhere have the same ꟻLIP, interpolated between those of the table in logarithms of both; – where none of them is as good. Each picture is drawn once, after a small one that warms up its threads.',
  async run() {
    const rows: (string | number)[][] = [];
    for (const name of SCENES) rows.push(...(await rowsOf(name)));
    return [{ columns: ['scene', 'samples', 'time [s]', 'ꟻLIP', 'of uniform at equal ꟻLIP'], rows }];
  },
};

interface Measured {
  readonly seconds: number;
  readonly error: number;
}

async function rowsOf(name: string): Promise<(string | number)[][]> {
  const scene = await openSceneFile(fileURLToPath(new URL(`../../../../examples/${name}.usdc`, import.meta.url)));
  const request = await pictureOf(scene);
  const truth = (await draw(scene, request, TRUTH.samples, { seed: TRUTH.seed })).image;
  const measure = async ({ name: method, samples, options }: Method): Promise<Measured> => {
    console.error(`  noise, ${name}, ${method}`);
    const { image, seconds } = await draw(scene, request, samples, options);
    return { seconds, error: mean(flip(image, truth)) };
  };
  const uniform: Measured[] = [];
  for (const method of UNIFORM) uniform.push(await measure(method));
  const rows = UNIFORM.map((method, i) => [name, method.name, uniform[i]!.seconds, uniform[i]!.error, 1]);
  for (const method of OTHERS) {
    const { seconds, error } = await measure(method);
    rows.push([name, method.name, seconds, error, seconds / timeAt(uniform, error)]);
  }
  return rows;
}

/** Time in which uniform sampling has an error; NaN beyond those that were measured. */
function timeAt(uniform: readonly Measured[], error: number): number {
  for (const [i, { error: least, seconds: longer }] of uniform.entries()) {
    const before = uniform[i - 1];
    if (!before || error < least || error > before.error) continue;
    const share = Math.log(before.error / error) / Math.log(before.error / least);
    return before.seconds * (longer / before.seconds) ** share;
  }
  return Number.NaN;
}

/** From the first camera, exposed as `render` does. */
async function pictureOf(scene: Scene): Promise<Omit<PictureRequest, 'samples'>> {
  const speedOfLight = speedOfLightOf(scene);
  const t = scene.hints.openAt ?? scene.startTime;
  const view = { t, ...observerFromCamera(scene.cameras[0], t, speedOfLight) };
  const settings = { ...DEFAULT_SETTINGS, speedOfLight };
  const request = { views: [view], settings, pixels: true, aovs: [] } as const;
  const session = open(scene, {});
  const meter = new ExposureMeter(new PictureMeter(session, SIZE), 'automatic', SIZE);
  const exposure = await meter.read({ ...request, samples: 1 });
  await session.close();
  return { ...request, settings: { ...settings, exposure } };
}

async function draw(
  scene: Scene,
  request: Omit<PictureRequest, 'samples'>,
  samples: number,
  options: OptionValues,
): Promise<{ readonly image: RgbImage; readonly seconds: number }> {
  const session = open(scene, options);
  await session.render({ ...request, samples: 1 });
  let image: RgbImage | undefined;
  const ms = await cpuTimed(async () => {
    image = displayed((await session.render({ ...request, samples })).pixels);
  });
  await session.close();
  return { image: image!, seconds: ms / 1000 };
}

function open(scene: Scene, options: OptionValues): PipelineSession {
  const host: Pick<PipelineHost, 'threads'> = { threads: nodeThreads() };
  const session = { scenes: [scene], size: SIZE, speedOfLight: speedOfLightOf(scene) } as const;
  return openReferenceSession({ ...session, options: withDefaults(REFERENCE_OPTIONS, options) }, host as PipelineHost);
}

const speedOfLightOf = ({ hints }: Scene): number => hints.speedOfLight ?? DEFAULT_SETTINGS.speedOfLight;

const displayed = (rgba: Uint8Array): RgbImage => ({
  ...SIZE,
  rgb: Float32Array.from({ length: (3 * rgba.length) / 4 }, (_, i) =>
    decodeSrgb(rgba[4 * Math.floor(i / 3) + (i % 3)] / 255),
  ),
});

const mean = (values: Float32Array): number => values.reduce((sum, value) => sum + value, 0) / values.length;
