import { msg } from '../../../../../messages/message.ts';
import type { Anisotropy } from '../../../../../scene/materials/layers.ts';
import type { PrimSpec } from '../../../layer/layer.ts';
import type { UvSource } from '../uvs.ts';
import { computed, constant, type Expression, picked, type TexelField } from './expression.ts';
import type { NetworkReader } from './networkReader.ts';

/** Inputs of a reflection that is wider along one direction. */
export interface GrooveInputs {
  readonly anisotropy: string;
  /** The direction, from that of increasing u; '': none. */
  readonly rotation: string;
  /** Radians towards increasing v per unit of the rotation. */
  readonly turn: number;
  readonly widths: Widths;
}

/** The widths of GGX along and across the direction, by roughness and anisotropy, 0 … 1. */
export type Widths = (roughness: number, anisotropy: number) => readonly [along: number, across: number];

/** The roughness that is drawn, the grooves, if there are any, and the texture coordinates that they need. */
interface Grooved {
  readonly roughness: Expression | undefined;
  readonly layer?: Anisotropy;
  readonly uv?: UvSource | undefined;
}

/** Grooves whose widths are those of the surface: across them roughness², along them as far as `Anisotropy.strength` widens it. */
export async function groovesOf(
  reader: NetworkReader,
  shader: PrimSpec,
  roughness: Expression | undefined,
  defaultRoughness: number,
  grooves: GrooveInputs | undefined,
): Promise<Grooved> {
  const { network } = reader;
  const written = grooves && (await network.input(shader, grooves.anisotropy));
  if (!written || (written.kind === 'constant' && !(written.values[0] > 0))) return { roughness };
  const turned = (grooves.rotation && (await network.input(shader, grooves.rotation))) || constant(0);
  // Across, strength, and the direction along u and v.
  const made = computed([roughness ?? constant(defaultRoughness), written, turned], 4, ([[r], [s], [turns]]) => {
    const [along, across] = grooves.widths(unit(r), unit(s)).map(unit);
    const angle = grooves.turn * turns;
    const strength = across < 1 ? Math.sqrt(Math.max(along - across, 0) / (1 - across)) : 0;
    return [Math.sqrt(across), strength, angle, 0];
  });
  if (!made) {
    network.tell(
      'mtlx.input',
      shader,
      msg`${grooves.anisotropy} and what it acts on lie on the surface in different ways; it is not drawn`,
    );
    return { roughness };
  }
  if (made.kind === 'constant') {
    const [across, strength, rotation] = made.values;
    return { roughness: constant(across), layer: { strength, rotation } };
  }
  const direction = computed([made], 3, ([[, strength, angle]]) => [
    (1 + Math.cos(angle)) / 2,
    (1 + Math.sin(angle)) / 2,
    strength,
  ]);
  const { texture, uv } = reader.dataOf(direction as TexelField);
  return { roughness: picked(made, [0]), layer: { strength: 1, rotation: 0, directionTexture: texture }, uv };
}

const unit = (x: number): number => Math.min(1, Math.max(0, x));
