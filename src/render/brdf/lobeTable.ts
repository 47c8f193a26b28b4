import { sqrt } from 'three/tsl';
import { toHalf } from '../../math/half.ts';
import { MIN_SHEEN_ROUGHNESS, SHEEN_TABLE_SIZE, type SheenLobe, sheenTable } from '../../scene/materials/sheenLobe.ts';
import {
  LOBE_TABLE_SIZE,
  type LobeCore,
  type LobeParts,
  lobeTables,
  type SpecularLobe,
} from '../../scene/materials/specularLobe.ts';
import type { HalfAtlas } from '../../shaders/tables/halfAtlas.ts';
import type { Float, Vec4 } from '../../shaders/types.ts';

type NodesOf<T> = { readonly [K in keyof T]: Float };
export type LobeNodes = NodesOf<SpecularLobe>;

/** Reads what is tabulated for `NV` and a roughness, both at most 1. */
export interface LobeTable {
  at(NV: Float, roughness: Float): LobeNodes;
  core(NV: Float, roughness: Float): NodesOf<LobeCore>;
  parts(NV: Float, roughness: Float): NodesOf<LobeParts>;
  /** Of fuzz, whose roughness is at least MIN_SHEEN_ROUGHNESS. */
  sheen(NV: Float, roughness: Float): NodesOf<SheenLobe>;
}

export function lobeTable(atlas: HalfAtlas): LobeTable {
  const texel = (name: string, size: typeof LOBE_TABLE_SIZE, texels: () => Float64Array, NV: Float, row: Float): Vec4 =>
    atlas
      .table(name, () => ({ data: Uint16Array.from(texels(), toHalf), width: size.columns }))
      .sampleLinear(
        sqrt(NV.min(1))
          .mul(size.columns - 1)
          .add(0.5),
        row.mul(size.rows - 1).add(0.5),
      );
  const read = (name: keyof ReturnType<typeof lobeTables>, NV: Float, roughness: Float): Vec4 =>
    texel(`specular ${name}`, LOBE_TABLE_SIZE, () => lobeTables()[name], NV, roughness);
  return {
    at: (NV, roughness) => {
      const { x, y, z } = read('lobes', NV, roughness);
      return { scale: x, bias: y, cosine: z };
    },
    core: (NV, roughness) => {
      const { x, y, z } = read('core', NV, roughness);
      return { share: x, cosine: y, width: z };
    },
    parts: (NV, roughness) => {
      const { x, y, z } = read('parts', NV, roughness);
      return { wide: x, cosine: y, width: z };
    },
    sheen: (NV, roughness) => {
      const row = roughness.sub(MIN_SHEEN_ROUGHNESS).div(1 - MIN_SHEEN_ROUGHNESS);
      const { x, y, z } = texel('sheen', SHEEN_TABLE_SIZE, sheenTable, NV, row);
      return { share: x, cosine: y, gain: z };
    },
  };
}
