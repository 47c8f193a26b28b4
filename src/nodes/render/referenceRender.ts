import { NodeRefusal } from '../../graph/nodeType.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { DEFAULT_LIGHT, MAX_BOUNCES, MAX_SAMPLES, SEED_COUNT } from '../../reference/lights/lightOptions.ts';
import { makeStillPixels } from '../../scene/frameGraph/still.ts';
import { BUFFER_SETTINGS } from '../../scene/settings/settings.ts';
import { framingCamera, observerFromCamera } from '../../scene/view/camera.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../scene/view/view.ts';
import { defineNode } from '../defineNode.ts';
import type { GBufferSpec } from '../socketValues.ts';

/** Limits of a still on pixels and on light paths: minutes, not hours. */
const MAX_PIXELS = 2 ** 22;
const MAX_PATHS = 2 ** 26;

const integerParam = (title: string, preset: number, min: number, max: number) =>
  ({ kind: 'number', title, default: preset, min, max, step: 1, integer: true }) as const;
const stillPixelParam = (title: string, preset: number) =>
  ({ ...integerParam(title, preset, 1, 8192), unit: 'px', slider: false }) as const;

/** A picture by the reference renderer, from the scene's camera. */
export const referenceRenderNode = defineNode({
  id: 'reference-render',
  title: 'node.referenceRender',
  help: 'node.referenceRender.help',
  category: 'render',
  params: {
    width: stillPixelParam('param.width', 480),
    height: stillPixelParam('param.height', 270),
    samples: { ...integerParam('param.stillSamples', 4, 1, MAX_SAMPLES), help: 'param.stillSamples.help' },
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
      ...integerParam('param.bounces', DEFAULT_LIGHT.bounces, 0, MAX_BOUNCES),
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
    seed: { ...integerParam('param.seed', 0, 0, SEED_COUNT - 1), help: 'param.seed.help', slider: false },
  },
  inputs: { gbuffer: { type: 'gbuffer' } },
  outputs: { image: { type: 'image' } },
  async evaluate(
    { gbuffer },
    { width, height, samples, time, bounces, mirrors, glass, seed },
    { services, node, ...work },
  ) {
    assertSize(width, height, samples, node);
    const { scene } = gbuffer;
    const view = initialViewPoint(gbuffer, time ?? scene.hints.openAt ?? scene.startTime);
    const light = { bounces, mirrors, glass };
    const picture = { view, settings: traceSettings(gbuffer), width, height, samples, seed, light };
    const still = makeStillPixels(width, height, await services.trace(scene, picture, work));
    return { image: { step: { kind: 'still', still }, gbuffer } };
  },
});

const millions = (n: number): string => `${(n / 1e6).toFixed(1)} million`;

function assertSize(width: number, height: number, samples: number, node: string): void {
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
  if (many > MAX_PIXELS)
    refuse(`${width} × ${height} are ${millions(many)} pixels, more than ${millions(MAX_PIXELS)}; make it smaller`);
  if (many * samples ** 2 > MAX_PATHS) {
    const paths = `${samples} × ${samples} samples of ${width} × ${height} pixels are ${millions(many * samples ** 2)}`;
    const fitting = Math.floor(Math.sqrt(MAX_PATHS / many));
    refuse(`${paths}, more than ${millions(MAX_PATHS)}; take ${fitting} × ${fitting}, or fewer pixels`, fitting);
  }
}

/** View point at time t [s] of the initial observer: at the camera, with its velocity or that of the scene's hint. */
function initialViewPoint({ scene, camera, fovY, speedOfLight }: GBufferSpec, t: number): ViewPoint {
  const found = scene.cameras.find(({ path }) => path === camera) ?? scene.cameras[0] ?? framingCamera(scene);
  const { beta } = scene.hints;
  return {
    t,
    ...observerFromCamera(found, t, speedOfLight),
    ...(beta && { u: properVelocity(beta) }),
    ...(fovY !== undefined && { fovY }),
  };
}

/** The settings that radiance depends on. */
const traceSettings = (gbuffer: GBufferSpec): RenderSettings => ({
  ...DEFAULT_SETTINGS,
  ...Object.fromEntries(BUFFER_SETTINGS.map((name) => [name, gbuffer[name]])),
});
