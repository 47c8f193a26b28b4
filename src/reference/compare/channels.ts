/** A picture with named channels (`depth`, `position.x`), as in an EXR file: one value per pixel, rows from the top. */
export interface ChannelPicture {
  readonly width: number;
  readonly height: number;
  readonly channels: ReadonlyMap<string, ArrayLike<number>>;
}

/** `position` for `position.x`; empty for `R`. */
export const layerOf = (channel: string): string => channel.slice(0, Math.max(channel.lastIndexOf('.'), 0));

/** The channels that identify the point shown by each pixel: its object and world position. */
export interface VisiblePoints {
  readonly object: ArrayLike<number>;
  readonly position: readonly [ArrayLike<number>, ArrayLike<number>, ArrayLike<number>];
}

export const VISIBLE_POINT_CHANNELS = ['object', 'position.x', 'position.y', 'position.z'] as const;

/** Undefined if one of `VISIBLE_POINT_CHANNELS` is missing. */
export function visiblePointsOf({ channels }: ChannelPicture): VisiblePoints | undefined {
  const [object, x, y, z] = VISIBLE_POINT_CHANNELS.map((name) => channels.get(name));
  return object && x && y && z ? { object, position: [x, y, z] } : undefined;
}
