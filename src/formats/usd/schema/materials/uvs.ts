import { radians } from '../../../../math/angle.ts';
import { msg } from '../../../../messages/message.ts';
import type { PolygonValues } from '../../../../scene/mesh/polygons.ts';
import { report } from '../../diagnostics.ts';
import { numberOf, numbersOf, textOf } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import { isAnimated, resolveInput, shaderId } from './shaderInputs.ts';

/** The primvar that a texture is looked up by, with its transform. */
export interface UvSource {
  readonly name: string;
  readonly transform?: UvTransform;
}

/** uv′ = R(rotation) (scale · uv) + translation (UsdTransform2d). */
export interface UvTransform {
  readonly scale: readonly [number, number];
  /** [degrees] */
  readonly rotation: number;
  readonly translation: readonly [number, number];
  /** Size of a UDIM set in tiles, by which u and v are finally divided. */
  readonly tiles?: readonly [number, number];
}

const IDENTITY: UvTransform = { scale: [1, 1], rotation: 0, translation: [0, 0] };

/** The lookup of a UDIM texture. */
export const withTiles = (uv: UvSource, tiles: readonly [number, number]): UvSource => ({
  ...uv,
  transform: { ...(uv.transform ?? IDENTITY), tiles },
});

export const isSameUv = (a: UvSource, b: UvSource): boolean =>
  a.name === b.name && JSON.stringify(a.transform) === JSON.stringify(b.transform);

/** Follows `inputs:st` of a UsdUVTexture to its UsdPrimvarReader_float2. */
export function uvSourceOf(context: StageContext, texture: PrimSpec): UvSource | undefined {
  const { layer, startCode } = context;
  const { shader } = resolveInput(layer, texture, 'inputs:st', startCode);
  if (!shader) return undefined;
  const id = shaderId(shader);
  if (id === 'UsdTransform2d') {
    const reader = resolveInput(layer, shader, 'inputs:in', startCode).shader;
    if (isAnimated(shader))
      report(
        context,
        'warning',
        'usd.animated-material',
        shader.path,
        msg`it changes with time; it is held at the start`,
      );
    const name = reader ? readerVariable(context, reader) : undefined;
    return name === undefined ? undefined : { name, transform: uvTransformOf(context, shader) };
  }
  if (id.startsWith('UsdPrimvarReader_float2')) {
    const name = readerVariable(context, shader);
    return name === undefined ? undefined : { name };
  }
  report(context, 'warning', 'usd.shader', shader.path, msg`a shader '${id}' is not read; st is used for uv`);
  return undefined;
}

const readerVariable = (context: StageContext, reader: PrimSpec): string | undefined =>
  textOf(resolveInput(context.layer, reader, 'inputs:varname', context.startCode).value);

function uvTransformOf(context: StageContext, shader: PrimSpec): UvTransform {
  const input = (name: string) => resolveInput(context.layer, shader, `inputs:${name}`, context.startCode).value;
  const pair = (name: string, fallback: number): readonly [number, number] => {
    const v = numbersOf(input(name));
    return [v?.[0] ?? fallback, v?.[1] ?? fallback];
  };
  const rotation = numberOf(input('rotation')) ?? 0;
  return { scale: pair('scale', 1), rotation, translation: pair('translation', 0) };
}

/** The uvs with the transform of each face's material, one per corner. */
export function transformUvs(
  values: PolygonValues,
  points: ArrayLike<number>,
  counts: ArrayLike<number>,
  transformOfFace: (face: number) => UvTransform | undefined,
): PolygonValues {
  return mapCorners(values, 2, points, counts, (face, [u, v]) => transformedUv(transformOfFace(face), u, v));
}

/** Applies `map` to each corner's value of `size` numbers. */
export function mapCorners(
  values: PolygonValues,
  size: number,
  points: ArrayLike<number>,
  counts: ArrayLike<number>,
  map: (face: number, value: readonly number[]) => readonly number[],
): PolygonValues {
  const out = new Float32Array(points.length * size);
  let corner = 0;
  for (let face = 0; face < counts.length; face++)
    for (let k = 0; k < counts[face] && corner < points.length; k++, corner++) {
      const place = { point: points[corner], corner, face, constant: 0 }[values.per];
      const i = values.indices ? values.indices[place] : place;
      out.set(
        map(
          face,
          Array.from({ length: size }, (_, n) => values.values[size * i + n]),
        ),
        size * corner,
      );
    }
  return { per: 'corner', values: out };
}

function transformedUv(transform: UvTransform | undefined, u: number, v: number): [number, number] {
  if (!transform) return [u, v];
  const { scale, rotation, translation } = transform;
  const [c, s] = [Math.cos(radians(rotation)), Math.sin(radians(rotation))];
  const [x, y] = [u * scale[0], v * scale[1]];
  const [columns, rows] = transform.tiles ?? [1, 1];
  return [(c * x - s * y + translation[0]) / columns, (s * x + c * y + translation[1]) / rows];
}
