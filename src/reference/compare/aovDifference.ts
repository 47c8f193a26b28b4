import { type ChannelPicture, layerOf } from './channels.ts';
import { type ErrorSummary, summarize } from './statistics.ts';

export interface AovDifference {
  readonly channels: readonly ChannelDifference[];
  /** Channels that only one of the pictures has. */
  readonly onlyA: readonly string[];
  readonly onlyB: readonly string[];
  /** Number of pixels that show different objects; undefined if a picture has no `object` channel. */
  readonly otherObject: number | undefined;
}

export interface ChannelDifference {
  readonly name: string;
  /** Number of pixels compared: for light (R, G, B) all, for data those where both pictures show the same object. */
  readonly pixels: number;
  /** Number of those pixels whose values differ and are not both finite: excluded from the errors below. */
  readonly notFinite: number;
  /** |A − B|, in the channel's unit; undefined if no pixel was compared. */
  readonly absolute: ErrorSummary | undefined;
  /** |A − B| divided by the larger of |A| and |B|, the lengths of the layer's vectors: for `position.x`, of all `position` channels. 0/0 counts as 0. */
  readonly relative: ErrorSummary | undefined;
}

/** Compares the common channels of two pictures of the same size. Symmetric, except for `onlyA` and `onlyB`. */
export function aovDifference(a: ChannelPicture, b: ChannelPicture): AovDifference {
  const common = [...a.channels.keys()].filter((name) => b.channels.has(name));
  const same = sameObject(a, b);
  return {
    channels: layers(common.filter((name) => name !== 'object')).flatMap((layer) => layerDifference(a, b, layer, same)),
    onlyA: [...a.channels.keys()].filter((name) => !b.channels.has(name)),
    onlyB: [...b.channels.keys()].filter((name) => !a.channels.has(name)),
    otherObject: same && pixelsWhere(same, (is) => is === OTHER).length,
  };
}

/** |A − B| of one channel per pixel; 0 where both are the same value, NaN and ±∞ included, otherwise infinite where the difference is NaN. */
export function channelErrors(a: ChannelPicture, b: ChannelPicture, name: string): Float32Array {
  const [valuesA, valuesB] = [a.channels.get(name) ?? [], b.channels.get(name) ?? []];
  return Float32Array.from({ length: a.width * a.height }, (_, i) => errorOf(valuesA[i], valuesB[i]));
}

function errorOf(a: number, b: number): number {
  if (Object.is(a, b)) return 0;
  const error = Math.abs(a - b);
  return Number.isNaN(error) ? Number.POSITIVE_INFINITY : error;
}

const [NOTHING, SAME, OTHER] = [0, 1, 2];

/** Per pixel: both show nothing, the same object, or different things; undefined without `object` channels. */
function sameObject(a: ChannelPicture, b: ChannelPicture): Uint8Array | undefined {
  const [ofA, ofB] = [a.channels.get('object'), b.channels.get('object')];
  const kind = (i: number) => (ofA?.[i] !== ofB?.[i] ? OTHER : ofA?.[i] === 0 ? NOTHING : SAME);
  return ofA && ofB && Uint8Array.from({ length: ofA.length }, (_, i) => kind(i));
}

function pixelsWhere(values: ArrayLike<number>, holds: (value: number) => boolean): number[] {
  const found: number[] = [];
  for (let i = 0; i < values.length; i++) if (holds(values[i])) found.push(i);
  return found;
}

// ── Layers ─────────────────────────────────────────────────────────────────────────────────────────────────────────

const LIGHT = ['R', 'G', 'B'];

/** Groups the channels that are components of one vector: those of one layer, and R, G, B. */
function layers(names: readonly string[]): string[][] {
  const found = new Map<string, string[]>();
  for (const name of names) {
    const key = LIGHT.includes(name) ? 'light' : layerOf(name) === '' ? `.${name}` : layerOf(name);
    found.set(key, [...(found.get(key) ?? []), name]);
  }
  return [...found.values()];
}

function layerDifference(
  a: ChannelPicture,
  b: ChannelPicture,
  names: readonly string[],
  same: Uint8Array | undefined,
): ChannelDifference[] {
  const lengths = largerLengths(a, b, names);
  // Data are comparable only where both pictures show the same object.
  const everywhere = !same || LIGHT.includes(names[0]);
  const compared = everywhere ? [...lengths.keys()] : pixelsWhere(same, (is) => is === SAME);
  return names.map((name) => {
    const errors = channelErrors(a, b, name);
    const finite = compared.filter((i) => Number.isFinite(errors[i]));
    return {
      name,
      pixels: compared.length,
      notFinite: compared.length - finite.length,
      absolute: summarize(Float64Array.from(finite, (i) => errors[i])),
      relative: summarize(Float64Array.from(finite, (i) => (errors[i] > 0 ? errors[i] / lengths[i] : 0))),
    };
  });
}

/** Per pixel, the larger of |A| and |B|, the lengths of the vectors of these channels. */
function largerLengths(a: ChannelPicture, b: ChannelPicture, names: readonly string[]): Float64Array {
  const [ofA, ofB] = [lengths(a, names), lengths(b, names)];
  return ofA.map((length, i) => Math.max(length, ofB[i]));
}

function lengths({ width, height, channels }: ChannelPicture, names: readonly string[]): Float64Array {
  const squares = new Float64Array(width * height);
  for (const name of names) {
    const values = channels.get(name) ?? [];
    for (let i = 0; i < squares.length; i++) squares[i] += values[i] ** 2;
  }
  return squares.map(Math.sqrt);
}
