import { toHalf } from '../../math/half.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { linearizationTable } from '../../scene/materials/sampleTexture.ts';
import type { Texture } from '../../scene/types.ts';
import { cubeFaceOf } from '../../scene/view/lenses/cubeFaces.ts';
import { type FisheyeLens, fisheyeModel } from '../../scene/view/lenses/fisheyeLens.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { srgbByte } from '../../spectrum/display/srgbBytes.ts';
import type { CubeFaces, PanoramaPicture } from './faces.ts';

/** Widest picture that is made: 32 Mi pixels. */
const MAX_WIDTH = 8192;

/** Adds the colours in directions (x to the right, y up, z ahead) of a picture, times `weight`, in linear light. */
interface DirectionSampler {
  add(direction: Vec3, weight: number, sums: Float64Array, to: number): void;
}

/**
 * The picture by latitude and longitude of a cube: its middle is ahead, to the right of that is the right face. As fine at its equator as the faces are on average; each texel is the
 * mean over what it covers, in linear light. In halves if the faces are, else in bytes of sRGB.
 */
export function unfoldedCube(faces: CubeFaces): PanoramaPicture {
  const { size, picture } = faces[0];
  // The finest texels of faces, at their edges, are 1/size of a radian.
  return unfolded(4 * size, size, new FaceSampler(faces), picture);
}

/** The same of a fisheye or a dome master, a circle in the middle of its picture; black where that shows nothing. */
export function unfoldedFisheye(picture: PanoramaPicture, lens: FisheyeLens): PanoramaPicture {
  const perRadian = Math.min(picture.width, picture.height) / lens.aperture;
  return unfolded(2 * Math.round(Math.PI * perRadian), perRadian, new FisheyeSampler(picture, lens), picture);
}

/** `perRadian`: texels of what is sampled, where it is finest; `like`: a picture with its kind of numbers. */
function unfolded(
  wanted: number,
  perRadian: number,
  sampler: DirectionSampler,
  like: PanoramaPicture,
): PanoramaPicture {
  const width = Math.min(Math.max(2, wanted), MAX_WIDTH);
  const height = width / 2;
  const isRadiance = like.data instanceof Uint16Array;
  const data = new (isRadiance ? Uint16Array : Uint8Array)(4 * width * height).fill(isRadiance ? toHalf(1) : 255);
  const encode = isRadiance ? toHalf : srgbByte;
  const steps = Math.ceil((2 * Math.PI * perRadian) / width);
  const turns = Array.from({ length: steps * width }, (_, i) => 2 * Math.PI * ((i + 0.5) / (steps * width) - 0.5));
  const [sines, cosines] = [turns.map(Math.sin), turns.map(Math.cos)];
  const sums = new Float64Array(3 * width);
  for (let row = 0; row < height; row++) {
    sums.fill(0);
    let whole = 0;
    for (let j = 0; j < steps; j++) {
      const down = (Math.PI * (row + (j + 0.5) / steps)) / height;
      const [level, up] = [Math.sin(down), Math.cos(down)];
      whole += level * steps;
      for (let i = 0; i < sines.length; i++) {
        const direction: Vec3 = [level * sines[i], up, level * cosines[i]];
        sampler.add(direction, level, sums, 3 * Math.floor(i / steps));
      }
    }
    for (let i = 0, to = 4 * row * width; i < sums.length; i += 3, to += 4)
      for (let k = 0; k < 3; k++) data[to + k] = encode(sums[i + k] / whole);
  }
  const made = { width, height, data };
  return isRadiance
    ? { ...made, data: data as Uint16Array, colorSpace: 'linear' }
    : { ...made, data: data as Uint8Array, colorSpace: 'srgb' };
}

/** Points along each edge of a cube that are compared. */
const EDGE_POINTS = 32;
/** Difference across edges, relative to that between any places, from which they do not meet. */
const MAX_DIFFERENCE = 0.6;
/** Difference that is none: faces of one colour have no edges. */
const MIN_DIFFERENCE = 1 / 255;

/** Whether neighbouring faces have the same colours along their common edges, which six parts of a photograph have not. */
export function edgesMeet(faces: CubeFaces): boolean {
  const sampler = new FaceSampler(faces);
  const brightness = (direction: Vec3): number => {
    const rgb = new Float64Array(3);
    sampler.add(direction, 1, rgb, 0);
    const sum = rgb[0] + rgb[1] + rgb[2];
    return sum / (1 + sum);
  };
  const sides: (readonly [number, number])[] = [];
  const out = 1 + 2 / faces[0].size;
  for (let axis = 0; axis < 3; axis++)
    for (const [a, b] of [
      [1, 1],
      [1, -1],
      [-1, 1],
      [-1, -1],
    ] as const)
      for (let i = 0; i < EDGE_POINTS; i++) {
        const along = (2 * (i + 0.5)) / EDGE_POINTS - 1;
        const at = (p: number, q: number): number => {
          const direction: [number, number, number] = [0, 0, 0];
          direction[axis] = along;
          direction[(axis + 1) % 3] = p;
          direction[(axis + 2) % 3] = q;
          return brightness(direction);
        };
        sides.push([at(a * out, b), at(a, b * out)]);
      }
  const difference = (shift: number): number =>
    sides.reduce((sum, [one], i) => sum + Math.abs(one - sides[(i + shift) % sides.length][1]), 0);
  // An edge that has nothing to do with the first, and the other way round along it.
  return (
    difference(0) <= MIN_DIFFERENCE * sides.length + MAX_DIFFERENCE * difference(5 * EDGE_POINTS + EDGE_POINTS / 2)
  );
}

/** Bilinear samples of the faces, in linear light. */
class FaceSampler implements DirectionSampler {
  private readonly faces: CubeFaces;
  private readonly linear: readonly ArrayLike<number>[];

  constructor(faces: CubeFaces) {
    this.faces = faces;
    const tables = new Map<PanoramaPicture, ArrayLike<number>>();
    this.linear = faces.map(({ picture }) => {
      const table = tables.get(picture) ?? Float64Array.from(linearizationTable(picture as Texture));
      tables.set(picture, table);
      return table;
    });
  }

  add([right, up, ahead]: Vec3, weight: number, sums: Float64Array, to: number): void {
    const { face, ...place } = cubeFaceOf([right, up, -ahead]);
    const [u, v] = [(1 + place.x) / 2, (1 - place.y) / 2];
    const { picture, left, top, size, turned } = this.faces[face];
    const x = (turned ? 1 - u : u) * size - 0.5;
    const y = (turned ? 1 - v : v) * size - 0.5;
    addBilinear({ picture, linear: this.linear[face], left, top, width: size, height: size }, x, y, weight, sums, to);
  }
}

class FisheyeSampler implements DirectionSampler {
  private readonly area: PictureArea;
  private readonly lens: FisheyeLens;

  constructor(picture: PanoramaPicture, lens: FisheyeLens) {
    const { width, height } = picture;
    this.area = {
      picture,
      linear: Float64Array.from(linearizationTable(picture as Texture)),
      left: 0,
      top: 0,
      width,
      height,
    };
    this.lens = lens;
  }

  add([right, up, ahead]: Vec3, weight: number, sums: Float64Array, to: number): void {
    const place = fisheyeModel.placeOf(this.lens, [right, up, -ahead], this.area);
    if (!place || Math.hypot(...place) > 1) return;
    const { width, height } = this.area;
    const side = Math.min(width, height);
    const [x, y] = [(width + place[0] * side) / 2 - 0.5, (height - place[1] * side) / 2 - 0.5];
    addBilinear(this.area, x, y, weight, sums, to);
  }
}

/** A rectangle of a picture [px], and the linear light of its numbers. */
interface PictureArea extends PictureSize {
  readonly picture: PanoramaPicture;
  readonly linear: ArrayLike<number>;
  readonly left: number;
  readonly top: number;
}

/** `x`, `y` from the middle of the rectangle's first pixel. */
function addBilinear(
  { picture, linear, left, top, width: across, height: down }: PictureArea,
  x: number,
  y: number,
  weight: number,
  sums: Float64Array,
  to: number,
): void {
  const [x0, y0] = [Math.floor(x), Math.floor(y)];
  const [s, t] = [x - x0, y - y0];
  const inside = (i: number, count: number): number => Math.min(Math.max(i, 0), count - 1);
  const [columns, rows] = [
    [left + inside(x0, across), left + inside(x0 + 1, across)],
    [top + inside(y0, down), top + inside(y0 + 1, down)],
  ];
  const { data, width } = picture;
  for (let corner = 0; corner < 4; corner++) {
    const [i, j] = [corner & 1, corner >> 1];
    const share = weight * (i ? s : 1 - s) * (j ? t : 1 - t);
    const from = 4 * (rows[j] * width + columns[i]);
    for (let k = 0; k < 3; k++) sums[to + k] += share * linear[data[from + k]];
  }
}
