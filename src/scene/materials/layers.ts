import type { Vec3 } from '../../math/vec3.ts';
import type { NormalTexture, Texture, TextureChannel } from './texture.ts';

/**
 * What a dielectric reflects at its surface, as of `KHR_materials_specular`: F₀ = min(((n − 1)/(n + 1))² · `color`, 1) · `factor`, F₉₀ = `factor`. Metals
 * do not depend on it.
 */
export interface SpecularReflection {
  /** 0 … 1; with a texture, the mean of that. */
  readonly factor: number;
  /** Factor by place. */
  readonly factorTexture?: TextureChannel;
  /** Linear sRGB of F₀, from 0; may exceed 1. */
  readonly color: Vec3;
  /** Multiplied with `color`. */
  readonly colorTexture?: Texture;
}

/** A clear varnish of refractive index 1.5 over a surface, as of `KHR_materials_clearcoat`. */
export interface Clearcoat {
  /** How much of the surface has it, 0 … 1; with a texture, the mean of that. */
  readonly factor: number;
  /** Factor by place. */
  readonly factorTexture?: TextureChannel;
  /** 0 … 1; with a texture, the mean of that. */
  readonly roughness: number;
  /** Roughness by place. */
  readonly roughnessTexture?: TextureChannel;
  /** Bends its normals; absent: those of the surface without its normal map. */
  readonly normalTexture?: NormalTexture;
}

/** Upright fibres over a surface, as of velvet and dust, as of `KHR_materials_sheen`: they reflect at grazing angles. */
export interface Sheen {
  /** Linear sRGB, 0 … 1. */
  readonly color: Vec3;
  /** Multiplied with `color`. */
  readonly colorTexture?: Texture;
  /** 0 … 1; with a texture, the mean of that. */
  readonly roughness: number;
  /** Roughness by place. */
  readonly roughnessTexture?: TextureChannel;
}

/** Fine parallel grooves, as of brushed metal, that widen its highlight along one direction, as of `KHR_materials_anisotropy`: α there goes from roughness² to 1 with `strength`². */
export interface Anisotropy {
  /** 0 … 1; with a texture, its factor. */
  readonly strength: number;
  /** From the direction of increasing u towards that of increasing v [rad]. */
  readonly rotation: number;
  /** Red and green: the direction along u and v, −1 … 1, which is rotated; blue: factor of `strength`. */
  readonly directionTexture?: Texture;
}

/** Light passes a surface that scatters none inside, as of `KHR_materials_transmission`: its base colour tints it. Without a volume it is a thin sheet. */
export interface Transmission {
  /** How much of what the surface does not reflect passes it, 0 … 1; with a texture, the mean of that. */
  readonly factor: number;
  /** Factor by place. */
  readonly factorTexture?: TextureChannel;
}

/** The inside of a closed body, as of `KHR_materials_volume`: light is refracted, and absorbed by Beer and Lambert's law. */
export interface Volume {
  /** How thick the fast renderer takes it to be [m]; the reference measures it. */
  readonly thickness: number;
  /** Thickness over `thickness` by place. */
  readonly thicknessTexture?: TextureChannel;
  /** Linear sRGB of white light after `attenuationDistance`. */
  readonly attenuationColor: Vec3;
  /** [m]; infinity: nothing is absorbed. */
  readonly attenuationDistance: number;
}

/** A thin transparent film whose two sides' reflections interfere, as of `KHR_materials_iridescence`: soap, oil, oxides. */
export interface Iridescence {
  /** How much of the surface has it, 0 … 1; with a texture, the mean of that. */
  readonly factor: number;
  /** Factor by place. */
  readonly factorTexture?: TextureChannel;
  /** Refractive index of the film. */
  readonly ior: number;
  /** [m]; with a texture, where that is 0 and where it is 1. */
  readonly thickness: readonly [thinnest: number, thickest: number];
  /** Thickness by place; absent: the greatest. */
  readonly thicknessTexture?: TextureChannel;
}
