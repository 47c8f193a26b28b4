import { scale } from '../../../../math/vec3.ts';
import type { Material } from '../../../../scene/types.ts';
import type { ColorInputValue } from './textureReader.ts';

/** F₀ of a refractive index of 1.5. */
const DIELECTRIC_F0 = 0.04;
/** F₀ up to which a grey reflection is that of a refractive index: n = 3. */
const MAX_DIELECTRIC_F0 = 0.25;

/**
 * The specular workflow, whose colour is F₀, with F₉₀ = 1: exactly a metal where nothing is scattered, exactly a refractive index where F₀ is grey and low, else
 * a dielectric with a tinted reflection.
 */
export function fromSpecularWorkflow(
  diffuse: ColorInputValue,
  { color, texture }: ColorInputValue,
): Pick<Material, 'baseColor' | 'baseColorTexture' | 'metallic' | 'ior' | 'specular'> {
  if (!diffuse.texture && !diffuse.primvar && Math.max(...diffuse.color) === 0)
    return { baseColor: color, ...(texture && { baseColorTexture: texture }), metallic: 1 };
  const own = {
    baseColor: diffuse.color,
    ...(diffuse.texture && { baseColorTexture: diffuse.texture }),
    metallic: 0,
  };
  const [r, g, b] = color;
  const root = Math.sqrt(r);
  if (!texture && r === g && g === b && r > 0 && r <= MAX_DIELECTRIC_F0)
    return { ...own, ior: (1 + root) / (1 - root) };
  const specular = { factor: 1, color: scale(color, 1 / DIELECTRIC_F0), ...(texture && { colorTexture: texture }) };
  return { ...own, specular };
}
