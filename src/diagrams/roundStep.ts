import { scaleLinear } from 'd3-scale';

/** A step of 1, 2 or 5 times a power of ten, that fits into `span` about `count` times. */
export function roundStep(span: number, count: number): number {
  const [first = 0, second = 1] = scaleLinear().domain([0, span]).ticks(count);
  return second - first;
}
