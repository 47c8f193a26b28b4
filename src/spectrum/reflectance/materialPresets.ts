import type { Vec3 } from '../../math/vec3.ts';
import { filterFromRgb, type SpectralFilter } from './spectralFilter.ts';

/** The reflectance of a surface, including ultraviolet (below 360 nm) and infrared (above 830 nm). */
export interface MaterialPreset {
  /** What was measured, for people. */
  readonly about: string;
  /** Its reflectance. */
  readonly filter: SpectralFilter;
  /** For metals the filter is the specular reflectance, for others the diffuse one. */
  readonly metallic: boolean;
  /** 0…1, typical of the material. */
  readonly roughness: number;
}

const matt = (about: string, rgb: Vec3, uv: number, ir: number): MaterialPreset => ({
  about,
  filter: filterFromRgb(rgb, uv, ir),
  metallic: false,
  roughness: 0.8,
});
const metal = (about: string, rgb: Vec3, uv: number, ir: number): MaterialPreset => ({
  about,
  filter: filterFromRgb(rgb, uv, ir),
  metallic: true,
  roughness: 0.25,
});

/**
 * Materials whose infrared or ultraviolet reflectance differs from what their colour suggests, for scenes in which a Doppler shift makes it visible.
 * Rounded from published measurements of single samples; one number for the ultraviolet (300…360 nm) and one for the near
 * infrared (830…1300 nm).
 * @example
 * const { rgb, ir } = MATERIAL_PRESETS.get('leaf')!.filter;
 * ir > 3 * rgb[1]; // true: leaves are bright in the infrared
 */
export const MATERIAL_PRESETS: ReadonlyMap<string, MaterialPreset> = new Map([
  [
    'leaf',
    // Green and visible: foliage of ISO 17321-1. Ultraviolet over vegetation: Feister & Grewe 1995, Photochem. Photobiol. 62, 736.
    // Beyond the red edge at 720 nm: Gates et al. 1965, Appl. Opt. 4, 11.
    matt('green leaves: dark to the eye, bright beyond their red edge', [0.095, 0.148, 0.05], 0.02, 0.48),
  ],
  [
    'skin',
    // Light skin of ISO 17321-1; Cooksey, Allen & Tsai 2017, J. Res. NIST 122, 26 (250…2500 nm).
    matt('light human skin', [0.56, 0.31, 0.22], 0.06, 0.55),
  ],
  [
    'asphalt',
    // Worn asphalt of the ECOSTRESS library (Meerdink et al. 2019, Remote Sens. Environ. 230).
    matt('worn asphalt', [0.12, 0.115, 0.105], 0.07, 0.17),
  ],
  [
    'snow',
    // O'Brien & Munis 1975 (CRREL RR 332) and O'Brien 1977 (CRREL 77-27): nearly all of the ultraviolet, less and less beyond 800 nm.
    matt('fresh snow', [0.95, 0.96, 0.97], 0.95, 0.75),
  ],
  [
    'gold',
    // Johnson & Christy 1972, Phys. Rev. B 6, 4370, at normal incidence.
    metal('gold', [1, 0.77, 0.34], 0.37, 0.98),
  ],
  [
    'copper',
    // The same.
    metal('copper', [0.95, 0.64, 0.54], 0.36, 0.98),
  ],
]);
