import type { Material } from '../types.ts';

/** The fields of `Material` that are layers (layers.ts). */
export const LAYERS = [
  'specular',
  'anisotropy',
  'clearcoat',
  'sheen',
  'transmission',
  'volume',
  'iridescence',
] as const;

/** Whether a material has layers. */
export const isLayered = (material: Material): boolean => LAYERS.some((name) => material[name] !== undefined);
