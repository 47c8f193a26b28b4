import { msg } from '../../../../messages/message.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numbersOf, type TimeCode, valueAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { metadataText } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';

/** How values are spread over points or curves. */
export type ElementInterpolation = 'constant' | 'uniform' | 'varying' | 'vertex';

/** Number of values of each interpolation. */
export type ElementCounts = Readonly<Record<ElementInterpolation, number>>;

export interface ElementValues {
  readonly interpolation: ElementInterpolation;
  /** `size` numbers each, indices resolved. */
  readonly values: ArrayLike<number>;
}

const isInterpolation = (text: string | undefined): text is ElementInterpolation =>
  text === 'constant' || text === 'uniform' || text === 'varying' || text === 'vertex';

/** Values of an attribute, by the first of its names that is written; undefined, with a diagnostic, if their number does not fit. */
export function elementValues(
  context: StageContext,
  prim: PrimSpec,
  { names, size, counts, fallback, time }: ElementRequest,
): ElementValues | undefined {
  const name = names.find((candidate) => attributeOf(prim, candidate));
  const attribute = name === undefined ? undefined : attributeOf(prim, name);
  const found = numbersOf(valueAt(attribute, time));
  if (!attribute || !found || found.length === 0) return undefined;
  const indices = numbersOf(valueAt(attributeOf(prim, `${name}:indices`), time));
  const held = found.length / size;
  const values = indices
    ? Float32Array.from(
        { length: indices.length * size },
        (_, i) => found[size * indices[Math.floor(i / size)] + (i % size)],
      )
    : found;
  const written = metadataText(attribute.metadata, 'interpolation');
  // One value for all is common where more are meant by the fallback.
  const interpolation = isInterpolation(written) ? written : held === 1 ? 'constant' : fallback;
  const isWhole = values.length >= counts[interpolation] * size && Array.prototype.every.call(values, Number.isFinite);
  if (isWhole) return { interpolation, values };
  report(
    context,
    'warning',
    'usd.primvar',
    prim.path,
    msg`${name!} has ${values.length / size} values where ${counts[interpolation]} are needed; it is left out`,
  );
  return undefined;
}

interface ElementRequest {
  readonly names: readonly string[];
  /** Numbers per value. */
  readonly size: number;
  readonly counts: ElementCounts;
  /** ElementInterpolation of several values where none is written. */
  readonly fallback: ElementInterpolation;
  readonly time: TimeCode;
}
