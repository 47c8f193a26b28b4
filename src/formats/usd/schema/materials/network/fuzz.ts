import type { Sheen } from '../../../../../scene/materials/layers.ts';
import type { PrimSpec } from '../../../layer/layer.ts';
import type { UvSource } from '../uvs.ts';
import { computed, constant } from './expression.ts';
import type { NetworkReader } from './networkReader.ts';

/** Inputs of fuzz; without a weight it is wherever its colour is not black. */
export interface FuzzInputs {
  readonly weight: string;
  readonly color: string;
  readonly defaultColor: number;
  readonly roughness: string;
  readonly defaultRoughness: number;
  /** Whether the roughness is the width of the distribution, which elsewhere is its square. */
  readonly isWidth: boolean;
}

/** The fuzz of a surface, if it has any, and the texture coordinates that it needs. */
export async function fuzzOf(
  reader: NetworkReader,
  shader: PrimSpec,
  fuzz: FuzzInputs | undefined,
): Promise<{ readonly layer?: Sheen; readonly uvs: readonly (UvSource | undefined)[] }> {
  if (!fuzz) return { uvs: [] };
  const { network } = reader;
  const { defaultColor: grey } = fuzz;
  const tint = (await network.input(shader, fuzz.color)) ?? constant(grey, grey, grey);
  const weight = fuzz.weight === '' ? constant(1) : await network.input(shader, fuzz.weight);
  const weighted = weight && computed([tint, weight], 3, ([c, [w]]) => c.map((x) => x * w));
  const color = reader.colorOf(weighted, [0, 0, 0]);
  if (color.primvar || (!color.texture && color.color.every((x) => x === 0))) return { uvs: [] };
  const written = await network.input(shader, fuzz.roughness);
  const rooted = written && fuzz.isWidth ? computed([written], 1, ([[x]]) => [Math.sqrt(Math.max(x, 0))]) : written;
  const otherwise = fuzz.isWidth ? Math.sqrt(fuzz.defaultRoughness) : fuzz.defaultRoughness;
  const roughness = reader.scalarOf(rooted, otherwise);
  return {
    layer: {
      color: color.color,
      ...(color.texture && { colorTexture: color.texture }),
      roughness: roughness.value,
      ...(roughness.texture && { roughnessTexture: roughness.texture }),
    },
    uvs: [color.uv, roughness.uv],
  };
}
