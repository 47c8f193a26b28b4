import type { Quat } from '../../../math/quat.ts';
import type { Light, LocalLight } from '../light.ts';

/** The part of a similarity transform that changes a light's own numbers; its place belongs to its motion. */
export interface LightTransform {
  readonly orientation: Quat;
  /** Above 0. */
  readonly scale: number;
}

/** All that the scene needs to know of a kind of light (docs/adr/0024-light-kinds.md); render, reference and formats have records of their own. */
export interface LightKind<L extends Light> {
  /**
   * Where its light comes from: `local` from a place in the scene, with a motion; `distant` from one direction; `sky` from all directions; `stars` from
   * all directions, and too faint to light anything.
   */
  readonly reach: 'local' | 'distant' | 'sky' | 'stars';
  /** Rotates and scales it; the caller transforms its motion. Radiance does not change with the scale. */
  transform(light: L, by: LightTransform): L;
}

/** A kind of light with a place. */
export interface LocalLightKind<L extends LocalLight> extends LightKind<L> {
  readonly reach: 'local';
  /** Its lengths [m], each 0 or more. */
  readonly sizes: readonly LightSize[];
  /** Whether it is a face that is dark behind. */
  readonly isOneSided: boolean;
  /** Whether it is a point, whose `color` is an intensity. */
  isPoint(light: L): boolean;
  /** See `projectedArea` of lightKinds.ts. */
  projectedArea(light: L): number;
}

export type LightSize = 'radius' | 'width' | 'height' | 'length';
