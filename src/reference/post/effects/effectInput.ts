import { conjugate, rotate, toMatrix } from '../../../math/quat.ts';
import { normalize, scale, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { velocity } from '../../../physics/lorentz/boost.ts';
import type { FogColor } from '../../../scene/frameGraph/effects.ts';
import { backdropColors } from '../../../scene/lights/sceneLights.ts';
import type { SkyColors } from '../../../scene/lights/skyGradient.ts';
import { towardsZenith } from '../../../scene/view/lenses/fisheyeLens.ts';
import { filledSize, lensDirection, perspectiveOf } from '../../../scene/view/lenses/lenses.ts';
import { type Frustum, frustumOf } from '../../../scene/view/lenses/perspectiveLens.ts';
import type { AovName, RenderSettings, ViewPoint } from '../../../scene/view/view.ts';
import { directionAt, rayToward } from '../../camera/lensRay.ts';

/** An f64 image of any number of channels, by default three, rows from the top. */
export class FloatImage {
  readonly width: number;
  readonly height: number;
  readonly channels: number;
  readonly values: Float64Array;

  constructor(width: number, height: number, channels = 3, values?: ArrayLike<number>) {
    this.width = width;
    this.height = height;
    this.channels = channels;
    this.values = values ? Float64Array.from(values) : new Float64Array(width * height * channels);
  }

  /** A pixel's values; mirrored beyond the borders. */
  at(x: number, y: number): readonly number[] {
    const i = this.channels * (mirrorIndex(y, this.height) * this.width + mirrorIndex(x, this.width));
    return Array.from(this.values.subarray(i, i + this.channels));
  }

  /** A new image of this size, evaluated per pixel. */
  map(pixel: (x: number, y: number) => readonly number[], channels = 3): FloatImage {
    return FloatImage.of(this.width, this.height, channels, pixel);
  }

  static of(
    width: number,
    height: number,
    channels: number,
    pixel: (x: number, y: number) => readonly number[],
  ): FloatImage {
    const out = new FloatImage(width, height, channels);
    for (let y = 0; y < height; y++)
      for (let x = 0; x < width; x++) out.values.set(pixel(x, y), channels * (y * width + x));
    return out;
  }
}

/** Mirrors index `i` into 0 … n − 1: … 1 0 | 0 1 … n−1 | n−1 n−2 …; clamped beyond one reflection. */
export function mirrorIndex(i: number, n: number): number {
  const once = i < 0 ? -1 - i : i;
  const twice = once >= n ? 2 * n - 1 - once : once;
  return Math.min(Math.max(twice, 0), n - 1);
}

/** A picture with its AOVs, view and settings. */
export interface EffectInput {
  readonly image: FloatImage;
  /** The AOVs required by `EFFECTS[id].reads` (`AOVS_OF_EFFECT_CHANNEL`). */
  readonly aovs: ReadonlyMap<AovName, ArrayLike<number>>;
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  /** The scene's upward direction: unit, world frame. */
  readonly zenith: Vec3;
  /** Colours of the sky as a backdrop; those of a clear day if absent. */
  readonly sky?: SkyColors;
  /** What distant things fade into; absent: the effect's own. */
  readonly fogColor?: FogColor;
  /** From the camera to the observer [m]; absent: it is at his eye. */
  readonly observer?: Vec3;
}

/** Reads a picture's G-buffer at pixels, mirrored beyond the borders. */
export class GBufferReader {
  readonly image: FloatImage;
  readonly zenith: Vec3;
  readonly sky: SkyColors;
  readonly fogColor: FogColor | undefined;
  /** From the camera to the observer [m]. */
  readonly observer: Vec3;
  /** His velocity, world frame, units of c. */
  readonly beta: Vec3;
  /** [m/s] */
  readonly speedOfLight: number;
  private readonly input: EffectInput;

  constructor(source: EffectInput) {
    this.input = source;
    this.image = source.image;
    this.zenith = source.zenith;
    this.fogColor = source.fogColor;
    this.observer = source.observer ?? ZERO;
    this.beta = velocity(source.view.u);
    this.speedOfLight = source.settings.speedOfLight;
    this.sky = source.sky ?? backdropColors({ lights: [] });
  }

  /** Throws a RangeError unless the lens is a perspective one. */
  get frustum(): Frustum {
    return frustumOf(perspectiveOf(this.input.view.lens), this.image.width, this.image.height);
  }

  isCovered(x: number, y: number): boolean {
    return this.read('object', x, y)[0]! > 0.5;
  }

  /** Apparent distance |Δx′| [m]; 0 where no surface is. */
  depth(x: number, y: number): number {
    return this.read('depth', x, y)[0]!;
  }

  normal(x: number, y: number): Vec3 {
    return this.read('normal', x, y) as unknown as Vec3;
  }

  /** Observer → event, world frame [m]. */
  eventOffset(x: number, y: number): Vec3 {
    return sub(this.read('position', x, y) as unknown as Vec3, this.input.view.position);
  }

  /** Direction of the pixel's ray: unit, world frame; zero where the lens shows nothing. */
  direction(x: number, y: number): Vec3 {
    const { view, settings } = this.input;
    const n = directionAt(view, x + 0.5, y + 0.5, this.image.width, this.image.height);
    return n ? normalize(rayToward(view, settings, n).dx) : ZERO;
  }

  /** tan of the angles from the axis, to the right and up; of a perspective lens. */
  tangents(x: number, y: number): readonly [number, number] {
    const { image, frustum } = this;
    const { tanX, tanY, center } = frustum;
    const right = ((x + 0.5) / image.width) * 2 - 1;
    const up = 1 - ((y + 0.5) / image.height) * 2;
    return [right * tanX + center[0], up * tanY + center[1]];
  }

  /** Direction of a pixel, or of a place in it: unit, on axes whose +Y is the axis of a fisheye, the zenith of a dome, or else the camera's; undefined where the lens shows nothing. */
  gridDirection(x: number, y: number): Vec3 | undefined {
    const { lens } = this.input.view;
    const direction = lensDirection(lens, x + 0.5, y + 0.5, this.image);
    return direction && lens.kind === 'fisheye' ? towardsZenith(lens, direction) : direction;
  }

  /** How far a pixel is outside that part of the picture, about its middle [px]; negative inside. */
  beyondPart(part: number, x: number, y: number): number {
    const { lens } = this.input.view;
    const filled = filledSize(lens, this.image);
    const [right, up] = [x + 0.5 - this.image.width / 2, y + 0.5 - this.image.height / 2];
    if (lens.kind === 'fisheye') return Math.hypot(right, up) - (part * filled.width) / 2;
    return Math.max(Math.abs(right) - (part * filled.width) / 2, Math.abs(up) - (part * filled.height) / 2);
  }

  /** Direction of the pixel in the picture's space, the observer's frame on world axes carried by the boost: unit; zero where the lens shows nothing. */
  apparentDirection(x: number, y: number): Vec3 {
    return directionAt(this.input.view, x + 0.5, y + 0.5, this.image.width, this.image.height) ?? ZERO;
  }

  /** Observer → apparent position, observer's frame on world axes carried by the boost [m]. */
  apparentPosition(x: number, y: number): Vec3 {
    return scale(this.apparentDirection(x, y), this.depth(x, y));
  }

  /** Place in the picture [px from its top left corner] of a point in the camera's space, on those axes [m]; undefined unless it is in front of the camera. */
  pixelOf(point: Vec3): readonly [number, number] | undefined {
    const [right, up, back] = rotate(conjugate(this.input.view.orientation), point);
    if (!(back < 0)) return undefined;
    const { tanX, tanY, center } = this.frustum;
    const { width, height } = this.image;
    return [
      (((right / -back - center[0]) / tanX + 1) / 2) * width,
      ((1 - (up / -back - center[1]) / tanY) / 2) * height,
    ];
  }

  /** Distance of the apparent position along the camera's axis [m]. */
  axialDepth(x: number, y: number): number {
    return this.depth(x, y) / Math.hypot(...this.tangents(x, y), 1);
  }

  /** Apparent positions → camera axes: 4 × 4, column after column. */
  get viewMatrix(): readonly number[] {
    const m = toMatrix(conjugate(this.input.view.orientation));
    const column = (k: number) => [...[0, 1, 2].map((row) => m[3 * row + k] ?? 0), 0];
    return [...column(0), ...column(1), ...column(2), 0, 0, 0, 1];
  }

  /** World time of the event relative to the observer's [s]. */
  emissionTime(x: number, y: number): number {
    return this.read('emission_time', x, y)[0]! - this.input.view.t;
  }

  read(name: AovName, x: number, y: number): number[] {
    const { width, height } = this.image;
    const values = this.input.aovs.get(name);
    if (!values) throw new Error(`the picture was taken without its ${name}`);
    const channels = values.length / (width * height);
    const i = channels * (mirrorIndex(y, height) * width + mirrorIndex(x, width));
    return Array.from({ length: channels }, (_, k) => values[i + k]!);
  }
}
