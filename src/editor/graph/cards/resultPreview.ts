import type { NodeResult } from '../../../graph/evaluation/resultCache.ts';
import { type Message, msg } from '../../../messages/message.ts';
import type { LoadedScene } from '../../../nodes/services.ts';
import type { GBufferSpec, ImageSpec, PictureSpec, RelativisticScene, TimeRange } from '../../../nodes/socketValues.ts';
import type { MotionPath } from '../../../scene/compose/motionPaths.ts';
import type { Light, RigidMotion } from '../../../scene/types.ts';
import type { LightSpectrum } from '../../../spectrum/sources/lightSpectrum.ts';
import { formatCount, formatNumber } from '../../format.ts';
import { type DisplayValue, displayColor, displayText, formatNumbers } from './displayValue.ts';

/** Formatters of one-line previews, by socket type. */
const TEXT_PREVIEWS: Readonly<Record<string, (value: never) => DisplayValue>> = {
  geometry: describeScene,
  scene: describeScene,
  relativity: ({ speedOfLight }: RelativisticScene) => displayText(`c = ${formatNumber(speedOfLight)}\u202fm/s`),
  motion: describeMotion,
  lights: (lights: readonly Light[]) => ({ kind: 'text', text: msg`Lights: ${formatCount(lights.length)}` }),
  observer: (beta: readonly number[]) => displayText(`β = ${formatNumber(Math.hypot(...beta))}`),
  time: ({ start, end }: TimeRange) => displayText(`${formatNumber(start)} … ${formatNumber(end)}\u202fs`),
  spectrum: describeSpectrum,
  number: (value: number) => displayText(formatNumber(value, 6)),
  vector: (value: readonly number[]) => displayText(formatNumbers(value)),
  color: (value: readonly number[]) => displayColor(value),
  text: (value: string) => displayText(value),
};

/** Whether results of a type have a text preview. */
export const hasTextPreview = (type: string): boolean => Object.hasOwn(TEXT_PREVIEWS, type);

/** Text preview of a node's first output. */
export function textPreview(result: NodeResult | undefined, output: string, type: string): DisplayValue | undefined {
  if (result?.status !== 'done' || !hasTextPreview(type)) return undefined;
  const value = result.outputs[output];
  return value === undefined ? undefined : TEXT_PREVIEWS[type]!(value as never);
}

const PICTURE_TYPES: ReadonlySet<string> = new Set(['image', 'mask', 'gbuffer', 'picture']);

/** Whether results of a type have a picture preview. */
export const hasPicturePreview = (type: string): boolean => PICTURE_TYPES.has(type);

/** The image or G-buffer to draw for a node's output, if any. */
export function previewedImage(result: NodeResult | undefined, output: string): ImageSpec | GBufferSpec | undefined {
  const value = result?.status === 'done' ? result.outputs[output] : undefined;
  if (typeof value !== 'object' || value === null) return undefined;
  // A picture is previewed by its final image.
  return 'image' in value ? (value as PictureSpec).image : (value as ImageSpec | GBufferSpec);
}

/** Number of objects and vertices; without objects, number of lights or cameras. */
function describeScene({ scene: { objects, lights, cameras } }: LoadedScene): DisplayValue {
  if (objects.length === 0 && lights.length > 0)
    return { kind: 'text', text: msg`Lights: ${formatCount(lights.length)}` };
  if (objects.length === 0 && cameras.length > 0)
    return { kind: 'text', text: msg`Cameras: ${formatCount(cameras.length)}` };
  const vertices = objects.reduce((sum, { mesh }) => sum + mesh.positions.length / 3, 0);
  return {
    kind: 'text',
    text: msg`Objects: ${formatCount(objects.length)} · vertices: ${formatCount(vertices)}`,
  };
}

const PATH_TITLES = { circle: msg`circle`, spin: msg`spin`, path: msg`path` };

function describeMotion(motion: MotionPath): DisplayValue {
  if (motion.kind !== 'frame') return describeSpan(PATH_TITLES[motion.kind], motion.from, motion.to);
  return describeFrameMotion(motion.motion);
}

/** How a frame moves, by the kind of its motion. */
interface MotionText<M extends RigidMotion> {
  describe(motion: M): DisplayValue;
}

const MOTION_TEXTS: { readonly [K in RigidMotion['kind']]: MotionText<Extract<RigidMotion, { readonly kind: K }>> } = {
  static: { describe: () => ({ kind: 'text', text: msg`at rest` }) },
  uniform: { describe: ({ velocity }) => displayText(`${formatNumber(Math.hypot(...velocity))}\u202fm/s`) },
  hyperbolic: {
    describe: ({ properAcceleration }) => displayText(`${formatNumber(Math.hypot(...properAcceleration))}\u202fm/s²`),
  },
  sampled: { describe: ({ times }) => describeSpan(msg`keys`, times[0]!, times.at(-1)!) },
};

function describeFrameMotion(motion: RigidMotion): DisplayValue {
  const text: MotionText<RigidMotion> = MOTION_TEXTS[motion.kind];
  return text.describe(motion);
}

const describeSpan = (path: Message, from: number, to: number): DisplayValue => ({
  kind: 'text',
  text: msg`${path}, ${formatNumber(from)} … ${formatNumber(to)} s`,
});

function describeSpectrum(light: LightSpectrum): DisplayValue {
  if (light.kind === 'thermal') return displayText(`${formatCount(light.temperature)}\u202fK`);
  return light.kind === 'lines'
    ? { kind: 'text', text: msg`Lines: ${formatCount(light.lines.length)}` }
    : { kind: 'text', text: msg`measured` };
}
