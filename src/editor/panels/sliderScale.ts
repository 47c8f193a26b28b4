import type { NumberParam } from '../../graph/nodeType.ts';

/** Slider position 0 … 1 of a value, and the inverse. */
export function sliderPosition(spec: NumberParam, value: number): number {
  const [low, high] = [toScale(spec, spec.min), toScale(spec, spec.max)];
  const bounded = Math.min(spec.max, Math.max(spec.min, value));
  return (toScale(spec, bounded) - low) / (high - low);
}

export function sliderValue(spec: NumberParam, position: number): number {
  const [low, high] = [toScale(spec, spec.min), toScale(spec, spec.max)];
  const value = fromScale(spec, low + position * (high - low));
  return Math.min(spec.max, Math.max(spec.min, roundToStep(spec, value)));
}

/** The step of the slider's position: no smaller than that of the value, which an arrow key would otherwise round back. */
export function sliderStep(spec: NumberParam): number {
  const whole = STEPS[spec.scale ?? 'linear'](spec) / (toScale(spec, spec.max) - toScale(spec, spec.min));
  return Math.max(FINEST_STEP, whole);
}

const FINEST_STEP = 0.002;

/** The least step on each scale that is not rounded back. Of two digits of 1 − v, 10 % apart at most, that is ln 1.1/2 of atanh v. */
const STEPS: Readonly<Record<NonNullable<NumberParam['scale']>, (spec: NumberParam) => number>> = {
  linear: ({ step, integer }) => (integer ? 1 : step),
  log: () => Math.log(1.01),
  approach: () => Math.log(1.1) / 2,
};

/** A logarithmic scale cannot reach 0: a range that starts there is shifted by one step. */
const logOffset = ({ min, step }: NumberParam): number => (min > 0 ? 0 : step);

function toScale(spec: NumberParam, value: number): number {
  const { scale } = spec;
  if (scale === 'log') return Math.log(value + logOffset(spec));
  return scale === 'approach' ? Math.atanh(value) : value;
}

function fromScale(spec: NumberParam, stretched: number): number {
  const { scale } = spec;
  if (scale === 'log') return Math.exp(stretched) - logOffset(spec);
  return scale === 'approach' ? Math.tanh(stretched) : stretched;
}

/**
 * Rounds to the step; on a log scale to three significant digits, on an approach scale above 0.5 to two digits of 1 −
 * value.
 */
function roundToStep({ scale, step }: NumberParam, value: number): number {
  if (scale === 'log') return Number(value.toPrecision(3));
  if (scale === 'approach') return value < 0.5 ? Number(value.toFixed(2)) : 1 - Number((1 - value).toPrecision(2));
  return Number((Math.round(value / step) * step).toPrecision(12));
}
