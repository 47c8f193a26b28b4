import type { TextureWrap } from '../../../../../scene/types.ts';
import type { LoadedImage } from '../textureFiles.ts';
import type { UvSource } from '../uvs.ts';
import type { UvAffine } from './placement.ts';

/** What an output of a shading network is. */
export type Expression = Constant | TexelField | VertexValue | PlacedUv | TangentNormals;

export interface Constant {
  readonly kind: 'constant';
  readonly values: readonly number[];
}

/** Values by place on a texture's grid. */
export interface TexelField {
  readonly kind: 'texels';
  /** Numbers at each place. */
  readonly size: number;
  readonly grid: Grid;
  /** Steps that one place takes. */
  readonly cost: number;
  /** The values at a texel; rows from the top. */
  at(x: number, y: number): readonly number[];
  /** Present where each value is one channel of a picture, scaled and shifted. */
  readonly picture?: ScaledPicture;
}

/** Where a picture is on a surface. */
export interface Grid {
  readonly width: number;
  readonly height: number;
  readonly uv: UvSource | undefined;
  readonly wrapS: TextureWrap;
  readonly wrapT: TextureWrap;
  readonly filter: 'nearest' | 'linear';
}

/** value k = scale k · channel `channels[k]` + bias k */
export interface ScaledPicture {
  readonly name: string;
  readonly image: LoadedImage;
  readonly colorSpace: 'srgb' | 'linear';
  readonly channels: readonly number[];
  readonly scale: readonly number[];
  readonly bias: readonly number[];
}

/** A primvar of the mesh, multiplied. */
export interface VertexValue {
  readonly kind: 'vertex';
  readonly name: string;
  readonly gain: readonly number[];
  readonly fallback: readonly number[];
}

/** Texture coordinates. */
export interface PlacedUv {
  readonly kind: 'placement';
  readonly uv: UvAffine;
}

/** Normals of a map, as `in` of a normalmap node: 0.5 is none. */
export interface TangentNormals {
  readonly kind: 'normals';
  readonly encoded: Constant | TexelField;
  readonly strength: readonly [x: number, y: number];
}

export const constant = (...values: number[]): Constant => ({ kind: 'constant', values });

/** Computes one value of each component. */
export type Compute = (args: readonly (readonly number[])[]) => readonly number[];

/** Maximum cost of an expression that is computed by place. */
export const MAX_COST = 256;

/**
 * The results of a computation on constants and texels; undefined if its arguments lie on surfaces in different ways, or
 * are of another kind, or there are too many steps. `size` is the number of results.
 */
export function computed(
  args: readonly Expression[],
  size: number,
  compute: Compute,
): Constant | TexelField | undefined {
  const texels: TexelField[] = [];
  for (const arg of args) {
    if (arg.kind === 'texels') texels.push(arg);
    else if (arg.kind !== 'constant') return undefined;
  }
  if (texels.length === 0) {
    const values = compute(args.map((arg) => (arg as Constant).values));
    return { kind: 'constant', values };
  }
  const grid = commonGrid(texels);
  const cost = texels.reduce((sum, arg) => sum + arg.cost, 1);
  if (!grid || cost > MAX_COST) return undefined;
  const reads = args.map((arg) => readerOf(arg as Constant | TexelField, grid));
  return { kind: 'texels', size, grid, cost, at: (x, y) => compute(reads.map((read) => read(x, y))) };
}

/** The finest grid, if all are placed alike. */
function commonGrid(texels: readonly TexelField[]): Grid | undefined {
  const placeOf = ({ grid: { uv, wrapS, wrapT } }: TexelField): string =>
    JSON.stringify([uv?.name ?? 'st', uv?.transform, wrapS, wrapT]);
  if (texels.some((other) => placeOf(other) !== placeOf(texels[0]))) return undefined;
  return texels.map(({ grid }) => grid).reduce((a, b) => (b.width * b.height > a.width * a.height ? b : a));
}

function readerOf(arg: Constant | TexelField, { width, height }: Grid): (x: number, y: number) => readonly number[] {
  if (arg.kind === 'constant') return () => arg.values;
  const { grid } = arg;
  if (grid.width === width && grid.height === height) return (x, y) => arg.at(x, y);
  return (x, y) => arg.at(Math.floor(((x + 0.5) * grid.width) / width), Math.floor(((y + 0.5) * grid.height) / height));
}

/** Each component of an expression times `scale` plus `bias`, which keeps what the expression is. */
export function scaled(from: Expression, scale: readonly number[], bias: readonly number[]): Expression | undefined {
  const at = (list: readonly number[], k: number): number => (list.length === 1 ? list[0] : (list[k] ?? 0));
  if (from.kind === 'vertex')
    return bias.every((b) => b === 0) ? { ...from, gain: from.gain.map((g, k) => g * at(scale, k)) } : undefined;
  const made = computed([from], sizeOf(from), ([values]) => values.map((v, k) => v * at(scale, k) + at(bias, k)));
  if (from.kind !== 'texels' || made?.kind !== 'texels' || !from.picture) return made;
  const { picture } = from;
  return {
    ...made,
    picture: {
      ...picture,
      scale: picture.scale.map((s, k) => s * at(scale, k)),
      bias: picture.bias.map((b, k) => b * at(scale, k) + at(bias, k)),
    },
  };
}

/** The components `indices` of an expression. */
export function picked(from: Expression, indices: readonly number[]): Constant | TexelField | undefined {
  const made = computed([from], indices.length, ([values]) => indices.map((i) => values[i] ?? 0));
  if (from.kind !== 'texels' || made?.kind !== 'texels' || !from.picture || indices.some((i) => i >= from.size))
    return made;
  const { picture } = from;
  const of = (list: readonly number[]): number[] => indices.map((i) => list[i]);
  return {
    ...made,
    picture: { ...picture, channels: of(picture.channels), scale: of(picture.scale), bias: of(picture.bias) },
  };
}

/** Whether two expressions are known to have the same values: the same node, or the same use of one picture. */
export function isSame(a: Expression, b: Expression): boolean {
  if (a === b) return true;
  if (a.kind === 'constant' && b.kind === 'constant') return areEqual(a.values, b.values);
  if (a.kind !== 'texels' || b.kind !== 'texels' || !a.picture || !b.picture) return false;
  const [p, q] = [a.picture, b.picture];
  const lists = [
    [p.channels, q.channels],
    [p.scale, q.scale],
    [p.bias, q.bias],
  ] as const;
  return (
    p.image === q.image &&
    p.colorSpace === q.colorSpace &&
    lists.every(([x, y]) => areEqual(x, y)) &&
    commonGrid([a, b]) !== undefined &&
    a.grid.filter === b.grid.filter
  );
}

const areEqual = (a: readonly number[], b: readonly number[]): boolean =>
  a.length === b.length && a.every((x, k) => x === b[k]);

export function sizeOf(from: Expression): number {
  if (from.kind === 'constant') return from.values.length;
  if (from.kind === 'texels') return from.size;
  if (from.kind === 'vertex') return from.gain.length;
  return from.kind === 'placement' ? 2 : 3;
}
