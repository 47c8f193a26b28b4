import { NodeRefusal } from '../../graph/nodeType.ts';
import { properVelocity } from '../../physics/boost.ts';
import { DEFAULT_LIGHT, MOST_BOUNCES, MOST_SAMPLES, SEEDS } from '../../reference/lightOptions.ts';
import { framingCamera, observerFromCamera } from '../../scene/camera.ts';
import { BUFFER_SETTINGS } from '../../scene/plan.ts';
import { stillOf } from '../../scene/still.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../scene/view.ts';
import { defineNode, type GBuffer } from '../define.ts';

/** A still has at most so many pixels, and so many paths of light are followed for it: minutes, not hours. */
const MOST_PIXELS = 2 ** 22;
const MOST_PATHS = 2 ** 26;

const whole = (title: string, preset: number, min: number, max: number) =>
  ({ kind: 'number', title, default: preset, min, max, step: 1, integer: true }) as const;
const pixels = (title: string, preset: number) =>
  ({ ...whole(title, preset, 1, 8192), unit: 'px', slider: false }) as const;

/** A picture by the reference renderer, of the scene's camera. */
export const referenceRender = defineNode({
  id: 'reference-render',
  title: 'node.referenceRender',
  help: 'node.referenceRender.help',
  category: 'render',
  params: {
    width: pixels('param.width', 480),
    height: pixels('param.height', 270),
    samples: { ...whole('param.stillSamples', 4, 1, MOST_SAMPLES), help: 'param.stillSamples.help' },
    time: {
      kind: 'number',
      title: 'param.stillTime',
      help: 'param.stillTime.help',
      unit: 's',
      default: 0,
      min: -1e12,
      max: 1e12,
      step: 0.1,
      slider: false,
      suggestion: 'openAt',
    },
    bounces: {
      ...whole('param.bounces', DEFAULT_LIGHT.bounces, 0, MOST_BOUNCES),
      help: 'param.bounces.help',
      slider: false,
    },
    mirrors: {
      kind: 'boolean',
      title: 'param.mirrors',
      help: 'param.mirrors.help',
      default: DEFAULT_LIGHT.mirrors,
    },
    glass: { kind: 'boolean', title: 'param.glass', help: 'param.glass.help', default: DEFAULT_LIGHT.glass },
    seed: { ...whole('param.seed', 0, 0, SEEDS - 1), help: 'param.seed.help', slider: false },
  },
  inputs: { gbuffer: { type: 'gbuffer' } },
  outputs: { image: { type: 'image' } },
  async evaluate(
    { gbuffer },
    { width, height, samples, time, bounces, mirrors, glass, seed },
    { services, node, ...work },
  ) {
    checkSize(width, height, samples, node);
    const { scene } = gbuffer;
    const view = viewPoint(gbuffer, time ?? scene.hints.openAt ?? scene.startTime);
    const light = { bounces, mirrors, glass };
    const picture = { view, settings: settingsOf(gbuffer), width, height, samples, seed, light };
    const still = stillOf(width, height, await services.trace(scene, picture, work));
    return { image: { step: { kind: 'still', still }, gbuffer } };
  },
});

const millions = (n: number): string => `${(n / 1e6).toFixed(1)} million`;

function checkSize(width: number, height: number, samples: number, node: string): void {
  const many = width * height;
  const refuse = (message: string, remedy?: number): never => {
    throw new NodeRefusal({
      severity: 'error',
      code: 'reference.large',
      place: node,
      message,
      ...(remedy !== undefined && { remedy: { node, param: 'samples', value: remedy } }),
    });
  };
  if (many > MOST_PIXELS)
    refuse(`${width} × ${height} are ${millions(many)} pixels, more than ${millions(MOST_PIXELS)}; make it smaller`);
  if (many * samples ** 2 > MOST_PATHS) {
    const paths = `${samples} × ${samples} samples of ${width} × ${height} pixels are ${millions(many * samples ** 2)}`;
    const fitting = Math.floor(Math.sqrt(MOST_PATHS / many));
    refuse(`${paths}, more than ${millions(MOST_PATHS)}; take ${fitting} × ${fitting}, or fewer pixels`, fitting);
  }
}

/** Where the observer is at time t [s] who begins there: in the camera, with its velocity, or that which the scene wants. */
function viewPoint({ scene, camera, fovY, speedOfLight }: GBuffer, t: number): ViewPoint {
  const found = scene.cameras.find(({ path }) => path === camera) ?? scene.cameras[0] ?? framingCamera(scene);
  const { beta } = scene.hints;
  return {
    t,
    ...observerFromCamera(found, t, speedOfLight),
    ...(beta && { u: properVelocity(beta) }),
    ...(fovY !== undefined && { fovY }),
  };
}

/** What of the settings light itself depends on. */
const settingsOf = (gbuffer: GBuffer): RenderSettings => ({
  ...DEFAULT_SETTINGS,
  ...Object.fromEntries(BUFFER_SETTINGS.map((name) => [name, gbuffer[name]])),
});
