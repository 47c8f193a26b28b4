/** A picture of any channels, as an EXR has them: one value per pixel, rows from the top, by name (`depth`, `position.x`). */
export interface ChannelPicture {
  readonly width: number;
  readonly height: number;
  readonly channels: ReadonlyMap<string, ArrayLike<number>>;
}

/** `position` of `position.x`; empty for `R`. */
export const layerOf = (channel: string): string => channel.slice(0, Math.max(channel.lastIndexOf('.'), 0));

/** The channels of world positions and of objects, which tell which point of what a pixel shows. */
export interface VisiblePoints {
  readonly object: ArrayLike<number>;
  readonly position: readonly [ArrayLike<number>, ArrayLike<number>, ArrayLike<number>];
}

export const VISIBLE_POINT_CHANNELS = ['object', 'position.x', 'position.y', 'position.z'] as const;

/** Undefined where one of `VISIBLE_POINT_CHANNELS` is missing. */
export function visiblePointsOf({ channels }: ChannelPicture): VisiblePoints | undefined {
  const [object, x, y, z] = VISIBLE_POINT_CHANNELS.map((name) => channels.get(name));
  return object && x && y && z ? { object, position: [x, y, z] } : undefined;
}
