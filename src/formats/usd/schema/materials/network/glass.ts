import type { Vec3 } from '../../../../../math/vec3.ts';
import type { Material } from '../../../../../scene/types.ts';
import type { PrimSpec } from '../../../layer/layer.ts';
import type { UvSource } from '../uvs.ts';
import { computed, constant, type Expression } from './expression.ts';
import type { ShadingNetwork } from './network.ts';
import type { NetworkReader } from './networkReader.ts';

/** Inputs that say what passes a surface; an empty name is none. */
export interface GlassInputs {
  readonly weight: string;
  /** Tint of what passes: at the surface, or inside over `depth` if that is more than 0. */
  readonly color: string;
  readonly depth: string;
  /** Whether it is a sheet, not the boundary of a body. */
  readonly thinWalled: string;
  /** Thickness of a body, without which it is a sheet. */
  readonly thickness: string;
  /** Factor of 20 over the Abbe number, and that number; of gltf_pbr the product. */
  readonly dispersion: readonly [scale: string, abbe: string, defaultAbbe: number];
}

/** The glass of a material, and the texture coordinates that it needs. */
export interface NetworkGlass {
  readonly material: Pick<Material, 'transmission' | 'volume' | 'dispersion'>;
  readonly uvs: readonly (UvSource | undefined)[];
}

/** The colour of a surface, with the tint of what passes it in the share that does. */
export async function tinted(
  network: ShadingNetwork,
  shader: PrimSpec,
  color: Expression | undefined,
  glass: GlassInputs | undefined,
): Promise<Expression | undefined> {
  const weight = glass && (await network.input(shader, glass.weight));
  if (!weight || glass.color === '' || isZero(weight)) return color;
  const isInside = (await numberAt(network, shader, glass.depth, 0)) > 0;
  const tint = (!isInside && (await network.input(shader, glass.color))) || constant(1, 1, 1);
  if (!color || (weight.kind === 'constant' && weight.values[0] === 1)) return tint;
  return computed([color, tint, weight], 3, ([a, b, [w]]) => [0, 1, 2].map((k) => a[k] * (1 - w) + b[k] * w)) ?? color;
}

/** Transmission, volume and dispersion; `unit`: metres per unit of the inputs. */
export async function glassOf(
  reader: NetworkReader,
  shader: PrimSpec,
  glass: GlassInputs | undefined,
  unit: number,
): Promise<NetworkGlass> {
  const { network } = reader;
  const weight = glass && (await network.input(shader, glass.weight));
  if (!weight || isZero(weight)) return { material: {}, uvs: [] };
  const share = reader.scalarOf(weight, 0);
  const number = (name: string, otherwise: number): Promise<number> => numberAt(network, shader, name, otherwise);
  const isSheet =
    glass.thickness === '' ? (await number(glass.thinWalled, 0)) !== 0 : (await number(glass.thickness, 0)) <= 0;
  const transmission = { factor: share.value, ...(share.texture && { factorTexture: share.texture }) };
  if (isSheet) return { material: { transmission }, uvs: [share.uv] };
  const depth = await number(glass.depth, 0);
  const color = depth > 0 ? await network.input(shader, glass.color || 'attenuation_color') : undefined;
  const [scale, abbe, defaultAbbe] = glass.dispersion;
  const strength = await number(scale, 0);
  const written = abbe === scale ? strength : abbe === '' ? 20 : await number(abbe, defaultAbbe);
  // standard_surface writes the Abbe number itself, 0 for none.
  const dispersion = abbe === scale ? (written > 0 ? 20 / written : 0) : (strength * 20) / Math.max(written, 1e-3);
  const [r, g, b] = color?.kind === 'constant' ? color.values : [1, 1, 1];
  return {
    material: {
      transmission,
      volume: {
        thickness: (glass.thickness === '' ? depth : await number(glass.thickness, 0)) * unit,
        attenuationColor: [r, g ?? r, b ?? r] satisfies Vec3,
        attenuationDistance: depth > 0 ? depth * unit : Number.POSITIVE_INFINITY,
      },
      ...(dispersion > 0 && { dispersion }),
    },
    uvs: [share.uv],
  };
}

const isZero = (found: Expression): boolean => found.kind === 'constant' && found.values.every((x) => x === 0);

async function numberAt(network: ShadingNetwork, shader: PrimSpec, name: string, otherwise: number): Promise<number> {
  const found = name === '' ? undefined : await network.input(shader, name);
  return found?.kind === 'constant' ? found.values[0] : otherwise;
}
