/** Layer offset: t′ = scale · t + offset [time codes]. */
export interface TimeOffset {
  readonly offset: number;
  readonly scale: number;
}

export const NO_OFFSET: TimeOffset = { offset: 0, scale: 1 };

export const isNoOffset = ({ offset, scale }: TimeOffset): boolean => offset === 0 && scale === 1;

/** First `inner`, then `outer`. */
export function composeOffsets(outer: TimeOffset, inner: TimeOffset): TimeOffset {
  if (isNoOffset(outer)) return inner;
  return { scale: outer.scale * inner.scale, offset: outer.scale * inner.offset + outer.offset };
}

export const inverseOffset = ({ offset, scale }: TimeOffset): TimeOffset =>
  offset === 0 && scale === 1 ? NO_OFFSET : { scale: 1 / scale, offset: -offset / scale };

export const mapTime = ({ offset, scale }: TimeOffset, time: number): number => scale * time + offset;

/** Finite, with nonzero scale. */
export const isInvertible = ({ offset, scale }: TimeOffset): boolean =>
  Number.isFinite(offset) && Number.isFinite(scale) && scale !== 0 && Number.isFinite(1 / scale);
