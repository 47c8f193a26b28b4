import type { Quat } from '../../../math/quat.ts';
import type { Light, LocalLight } from '../light.ts';

/** What of a similarity transform changes a light's own numbers; where it is, is its motion's. */
export interface LightTransform {
  readonly orientation: Quat;
  /** Above 0. */
  readonly scale: number;
}

/** All that the scene knows of a kind of light (docs/adr/0024-light-kinds.md). Records of render, reference and formats have the rest. */
export interface LightKind<L extends Light> {
  /**
   * Where its light comes from: `local` from somewhere in the scene, with a motion; `distant` from one direction; `sky` from all round; `stars` from
   * all round, and too faint to light anything.
   */
  readonly reach: 'local' | 'distant' | 'sky' | 'stars';
  /** Turned and enlarged; its motion is carried along by the caller. Radiance does not change with the scale. */
  transform(light: L, by: LightTransform): L;
}

/** The same of a kind that is somewhere. */
export interface LocalLightKind<L extends LocalLight> extends LightKind<L> {
  readonly reach: 'local';
  /** Its lengths [m], each 0 or more. */
  readonly sizes: readonly LightSize[];
  /** Whether it is a face, dark behind. */
  readonly isOneSided: boolean;
  /** Whether it is a point, whose `color` is an intensity. */
  isPoint(light: L): boolean;
  /** See `projectedArea` of lightKinds.ts. */
  projectedArea(light: L): number;
}

export type LightSize = 'radius' | 'width' | 'height' | 'length';
