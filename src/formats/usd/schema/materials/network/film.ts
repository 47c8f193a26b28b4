import { msg } from '../../../../../messages/message.ts';
import type { Iridescence } from '../../../../../scene/materials/layers.ts';
import type { PrimSpec } from '../../../layer/layer.ts';
import type { UvSource } from '../uvs.ts';
import type { NetworkReader } from './networkReader.ts';

/** Inputs of a thin film; without a weight it is wherever it is thicker than 0. */
export interface FilmInputs {
  readonly weight: string;
  readonly thickness: string;
  readonly defaultThickness: number;
  /** Metres per unit of the thickness. */
  readonly unit: number;
  readonly ior: string;
  readonly defaultIor: number;
}

/** The film of a surface, if it has one, and the texture coordinates that it needs. */
export async function filmOf(
  reader: NetworkReader,
  shader: PrimSpec,
  film: FilmInputs | undefined,
): Promise<{ readonly layer?: Iridescence; readonly uv?: UvSource | undefined }> {
  if (!film) return {};
  const { network } = reader;
  const number = async (name: string, otherwise: number): Promise<number> => {
    const found = await network.input(shader, name);
    if (found && found.kind !== 'constant')
      network.tell('mtlx.input', shader, msg`${name} varies over the surface, which is not drawn`);
    return found?.kind === 'constant' ? found.values[0] : otherwise;
  };
  const weight = reader.scalarOf(
    film.weight === '' ? undefined : await network.input(shader, film.weight),
    film.weight === '' ? 1 : 0,
  );
  const thickness = film.unit * (await number(film.thickness, film.defaultThickness));
  const { texture } = weight;
  if ((weight.value === 0 && !texture) || !(thickness > 0)) return {};
  return {
    layer: {
      factor: weight.value,
      ...(texture && { factorTexture: texture }),
      ior: await number(film.ior, film.defaultIor),
      thickness: [thickness, thickness],
    },
    uv: weight.uv,
  };
}
