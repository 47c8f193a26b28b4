import { type BooleanParam, NodeRefusal, type NumberParam } from '../../graph/nodeType.ts';
import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { optionsByEffect } from '../../pipelines/options.ts';
import type { Pipeline, StillLimits } from '../../pipelines/pipeline.ts';
import { PIPELINES } from '../../pipelines/registry.ts';
import { makeStillPixels } from '../../scene/frameGraph/still.ts';
import { BUFFER_SETTINGS } from '../../scene/settings/settings.ts';
import { observerFromCamera } from '../../scene/view/camera.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { PictureViews } from '../../scene/view/pictureViews.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../scene/view/view.ts';
import { defineNode } from '../defineNode.ts';
import { pictureCamera, pictureLens } from '../pictures/renderSettings.ts';
import type { GBufferSpec } from '../socketValues.ts';
import { assertShape } from './saveParams.ts';

const integerParam = (title: LocalizedText, preset: number, min: number, max: number) =>
  ({ kind: 'number', title, default: preset, min, max, step: 1, integer: true }) as const;
const stillPixelParam = (title: LocalizedText, preset: number) =>
  ({ ...integerParam(title, preset, 1, 8192), unit: 'px', slider: false }) as const;

/** Parameters for a pipeline's options. */
function optionParams({ options }: Pipeline): Readonly<Record<string, NumberParam | BooleanParam>> {
  const specs = optionsByEffect(options).flatMap(([name, option]) => {
    const { param } = option;
    if (!param) return [];
    const spec: NumberParam | BooleanParam =
      option.kind === 'boolean'
        ? { kind: 'boolean', ...param, default: option.default }
        : {
            ...integerParam(param.title, option.default ?? option.min, option.min, option.max),
            ...(option.kind === 'number' && { integer: false, step: option.step }),
            ...param,
            slider: false,
          };
    return [[name, spec] as const];
  });
  return Object.fromEntries(specs);
}

/** A picture by a pipeline, from the scene's camera. */
const stillNode = (pipeline: Pipeline, still: StillLimits) =>
  defineNode({
    id: still.node,
    title: still.title,
    help: still.help,
    category: 'render',
    params: {
      width: stillPixelParam(msg`Width`, 480),
      height: stillPixelParam(msg`Height`, 270),
      samples: {
        ...integerParam(msg`Samples`, pipeline.samples.default, 1, still.maxSamples),
        help: msg`n × n per pixel: four times as many samples halve the noise.`,
      },
      time: {
        kind: 'number',
        title: msg`Time`,
        help: msg`World time of the observer’s event.`,
        unit: 's',
        default: 0,
        min: -1e12,
        max: 1e12,
        step: 0.1,
        slider: false,
        suggestion: 'openAt',
      },
      ...optionParams(pipeline),
    },
    inputs: { gbuffer: { type: 'gbuffer' } },
    outputs: { image: { type: 'image' } },
    async evaluate({ gbuffer }, { width, height, samples, time, ...options }, { services, node, ...work }) {
      const size = { width, height };
      assertSize(pipeline.id, still, size, samples, node);
      assertShape(pictureLens(gbuffer), size, node);
      const { scene } = gbuffer;
      const views: PictureViews = [initialViewPoint(gbuffer, time ?? scene.hints.openAt ?? scene.startTime)];
      const request = {
        pipeline: pipeline.id,
        scene,
        views,
        settings: lightSettings(gbuffer),
        ...size,
        samples,
        options,
      };
      const pixels = makeStillPixels(width, height, await services.renderStill(request, work));
      return { image: { step: { kind: 'still', still: pixels }, gbuffer } };
    },
  });

/** One for each pipeline that draws stills. */
export const stillNodes = PIPELINES.flatMap((pipeline) =>
  pipeline.still ? [stillNode(pipeline, pipeline.still)] : [],
);

const millions = (n: number): Message => msg`${(n / 1e6).toFixed(1)} million`;

function assertSize(
  pipeline: string,
  { maxPixels, maxPaths }: StillLimits,
  { width, height }: PictureSize,
  samples: number,
  node: string,
): void {
  const many = width * height;
  const refuse = (message: Message, remedy?: number): never => {
    throw new NodeRefusal({
      severity: 'error',
      code: `${pipeline}.large`,
      place: node,
      message,
      ...(remedy !== undefined && { remedy: { node, param: 'samples', value: remedy } }),
    });
  };
  if (many > maxPixels)
    refuse(msg`${width} × ${height} are ${millions(many)} pixels, more than ${millions(maxPixels)}; make it smaller`);
  if (many * samples ** 2 > maxPaths) {
    const paths = msg`${samples} × ${samples} samples of ${width} × ${height} pixels are ${millions(many * samples ** 2)}`;
    const fitting = Math.floor(Math.sqrt(maxPaths / many));
    refuse(msg`${paths}, more than ${millions(maxPaths)}; take ${fitting} × ${fitting}, or fewer pixels`, fitting);
  }
}

/** View point at time t [s] of the initial observer: at the camera, with its velocity or that of the scene's hint. */
function initialViewPoint(gbuffer: GBufferSpec, t: number): ViewPoint {
  const { scene, speedOfLight } = gbuffer;
  const { beta } = scene.hints;
  return {
    t,
    ...observerFromCamera(pictureCamera(gbuffer), t, speedOfLight),
    ...(beta && { u: properVelocity(beta) }),
    lens: pictureLens(gbuffer),
  };
}

/** The settings that radiance depends on. */
const lightSettings = (gbuffer: GBufferSpec): RenderSettings => ({
  ...DEFAULT_SETTINGS,
  ...Object.fromEntries(BUFFER_SETTINGS.map((name) => [name, gbuffer[name]])),
});
