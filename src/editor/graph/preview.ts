import type { NodeResult } from '../../graph/results.ts';
import type { GBuffer, Image, Picture, Relativity, TimeRange } from '../../nodes/define.ts';
import type { LoadedScene } from '../../nodes/services.ts';
import type { Course } from '../../scene/compose/paths.ts';
import type { Light } from '../../scene/types.ts';
import type { LightSpectrum } from '../../spectrum/lightSpectrum.ts';
import { formatCount, formatNumber } from '../format.ts';
import { numbers, type Shown, shownColor, text } from './values.ts';

/** From each socket type to what is told of a value of it, in a line. */
const TOLD: Readonly<Record<string, (value: never) => Shown>> = {
  geometry: things,
  scene: things,
  relativity: ({ speedOfLight }: Relativity) => text(`c = ${formatNumber(speedOfLight)}\u202fm/s`),
  motion: course,
  lights: (lights: readonly Light[]) => counted('graph.lights', lights.length),
  observer: (beta: readonly number[]) => text(`β = ${formatNumber(Math.hypot(...beta))}`),
  time: ({ start, end }: TimeRange) => text(`${formatNumber(start)} … ${formatNumber(end)}\u202fs`),
  spectrum: spectrum,
  number: (value: number) => text(formatNumber(value, 6)),
  vector: (value: readonly number[]) => text(numbers(value)),
  color: (value: readonly number[]) => shownColor(value),
  text: (value: string) => text(value),
};

/** Whether a line is kept for what flows out of sockets of a type. */
export const isTold = (type: string): boolean => Object.hasOwn(TOLD, type);

/** What a node made, by its first output. */
export function previewOf(result: NodeResult | undefined, output: string, type: string): Shown | undefined {
  if (result?.status !== 'done' || !isTold(type)) return undefined;
  const value = result.outputs[output];
  return value === undefined ? undefined : TOLD[type]!(value as never);
}

const PICTURED: ReadonlySet<string> = new Set(['image', 'mask', 'gbuffer', 'picture']);

/** Whether what flows out of sockets of a type can be shown as a picture. */
export const isPictured = (type: string): boolean => PICTURED.has(type);

/** What of a node's output is to be drawn, where there is any. */
export function pictured(result: NodeResult | undefined, output: string): Image | GBuffer | undefined {
  const value = result?.status === 'done' ? result.outputs[output] : undefined;
  if (typeof value !== 'object' || value === null) return undefined;
  // A whole picture is of its last image.
  return 'image' in value ? (value as Picture).image : (value as Image | GBuffer);
}

/** How many things and vertices; of what has none, how many lights. */
function things({ scene: { objects, lights, cameras } }: LoadedScene): Shown {
  if (objects.length === 0 && lights.length > 0) return counted('graph.lights', lights.length);
  if (objects.length === 0 && cameras.length > 0) return counted('graph.cameras', cameras.length);
  const vertices = objects.reduce((sum, { mesh }) => sum + mesh.positions.length / 3, 0);
  const fill = { objects: formatCount(objects.length), vertices: formatCount(vertices) };
  return { kind: 'words', key: 'graph.things', fill };
}

function course(motion: Course): Shown {
  if (motion.kind !== 'frame') return span(`graph.course.${motion.kind}`, motion.from, motion.to);
  const { motion: frame } = motion;
  if (frame.kind === 'uniform') return text(`${formatNumber(Math.hypot(...frame.velocity))}\u202fm/s`);
  if (frame.kind === 'hyperbolic') return text(`${formatNumber(Math.hypot(...frame.properAcceleration))}\u202fm/s²`);
  if (frame.kind === 'sampled') return span('graph.course.keys', frame.times[0]!, frame.times.at(-1)!);
  return { kind: 'words', key: 'graph.course.rest' };
}

const span = (key: string, from: number, to: number): Shown => ({
  kind: 'words',
  key,
  fill: { from: formatNumber(from), to: formatNumber(to) },
});

function spectrum(light: LightSpectrum): Shown {
  if (light.kind === 'thermal') return text(`${formatCount(light.temperature)}\u202fK`);
  return light.kind === 'lines'
    ? counted('graph.spectralLines', light.lines.length)
    : { kind: 'words', key: 'graph.sampled' };
}

const counted = (key: string, count: number): Shown => ({ kind: 'words', key, fill: { count: formatCount(count) } });
