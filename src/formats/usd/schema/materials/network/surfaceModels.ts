import type { FilmInputs } from './film.ts';
import type { FuzzInputs } from './fuzz.ts';
import type { GlassInputs } from './glass.ts';
import type { GrooveInputs, Widths } from './grooves.ts';

/** Which inputs of a surface mean what; values are those of the definitions where nothing is written. */
export interface SurfaceModel {
  readonly color: string;
  readonly defaultColor: number;
  /** Factor of the colour. */
  readonly weight?: string;
  readonly metalness: string;
  readonly defaultMetalness: number;
  readonly roughness: string;
  readonly defaultRoughness: number;
  readonly ior: string;
  /** Strength and colour of the dielectric's reflection. */
  readonly specular: string;
  readonly specularColor: string;
  /** Weight, roughness, normal, colour and refractive index of the varnish. */
  readonly coat?: Coat;
  readonly glow: string;
  readonly defaultGlow: number;
  readonly glowWeight: string;
  readonly defaultGlowWeight: number;
  readonly opacity: string;
  readonly glass?: GlassInputs;
  readonly film?: FilmInputs;
  readonly grooves?: GrooveInputs;
  readonly fuzz?: FuzzInputs;
  /** Share of light that passes a surface without reflection: transparency. */
  readonly clear?: string;
  readonly normal: string;
  readonly occlusion?: string;
  /** Weight and colour of light scattered below the surface, which is drawn as its colour. */
  readonly subsurface?: readonly [weight: string, color: string, defaultColor: number];
  /** Inputs that are left out where they are more than 0. */
  readonly unread: readonly string[];
}

interface Coat {
  readonly weight: string;
  readonly roughness: string;
  readonly defaultRoughness: number;
  readonly normal: string;
  /** Inputs that are left out where they are not white, and not 1.5. */
  readonly unread: readonly (readonly [name: string, otherwise: number])[];
}

/** MaterialX's node `roughness_anisotropy`. */
const ROUGHNESS_ANISOTROPY: Widths = (roughness, anisotropy) => {
  const aspect = Math.sqrt(1 - Math.min(anisotropy, 0.98));
  return [roughness ** 2 / aspect, roughness ** 2 * aspect];
};

const STANDARD: SurfaceModel = {
  color: 'base_color',
  defaultColor: 0.8,
  weight: 'base',
  metalness: 'metalness',
  defaultMetalness: 0,
  roughness: 'specular_roughness',
  defaultRoughness: 0.2,
  ior: 'specular_IOR',
  specular: 'specular',
  specularColor: 'specular_color',
  glow: 'emission_color',
  defaultGlow: 1,
  glowWeight: 'emission',
  defaultGlowWeight: 0,
  opacity: 'opacity',
  film: {
    weight: '',
    thickness: 'thin_film_thickness',
    defaultThickness: 0,
    unit: 1e-9,
    ior: 'thin_film_IOR',
    defaultIor: 1.5,
  },
  grooves: {
    anisotropy: 'specular_anisotropy',
    rotation: 'specular_rotation',
    // Its vectors are rows, which `rotate3d` turns the other way.
    turn: -2 * Math.PI,
    widths: ROUGHNESS_ANISOTROPY,
  },
  fuzz: {
    weight: 'sheen',
    color: 'sheen_color',
    defaultColor: 1,
    roughness: 'sheen_roughness',
    defaultRoughness: 0.3,
    isWidth: true,
  },
  glass: {
    weight: 'transmission',
    color: 'transmission_color',
    depth: 'transmission_depth',
    thinWalled: 'thin_walled',
    thickness: '',
    dispersion: ['transmission_dispersion', 'transmission_dispersion', 0],
  },
  normal: 'normal',
  subsurface: ['subsurface', 'subsurface_color', 1],
  unread: ['diffuse_roughness', 'transmission_scatter', 'transmission_extra_roughness'],
  coat: {
    weight: 'coat',
    roughness: 'coat_roughness',
    defaultRoughness: 0.1,
    normal: 'coat_normal',
    unread: [
      ['coat_color', 1],
      ['coat_IOR', 1.5],
      ['coat_affect_color', 0],
      ['coat_affect_roughness', 0],
    ],
  },
};

/** Surfaces by the id of their definition. */
export const SURFACES: ReadonlyMap<string, SurfaceModel> = new Map<string, SurfaceModel>([
  ['ND_standard_surface_surfaceshader', STANDARD],
  ['ND_standard_surface_surfaceshader_100', { ...STANDARD, defaultColor: 1 }],
  [
    'ND_open_pbr_surface_surfaceshader',
    {
      color: 'base_color',
      defaultColor: 0.8,
      weight: 'base_weight',
      metalness: 'base_metalness',
      defaultMetalness: 0,
      roughness: 'specular_roughness',
      defaultRoughness: 0.3,
      ior: 'specular_ior',
      specular: 'specular_weight',
      specularColor: 'specular_color',
      coat: {
        weight: 'coat_weight',
        roughness: 'coat_roughness',
        defaultRoughness: 0,
        normal: 'geometry_coat_normal',
        unread: [
          ['coat_color', 1],
          ['coat_ior', 1.5],
        ],
      },
      glow: 'emission_color',
      defaultGlow: 1,
      glowWeight: 'emission_luminance',
      defaultGlowWeight: 0,
      opacity: 'geometry_opacity',
      film: {
        weight: 'thin_film_weight',
        thickness: 'thin_film_thickness',
        defaultThickness: 0.5,
        unit: 1e-6,
        ior: 'thin_film_ior',
        defaultIor: 1.4,
      },
      grooves: {
        anisotropy: 'specular_roughness_anisotropy',
        rotation: '',
        turn: 0,
        widths: (roughness, anisotropy) => {
          const along = roughness ** 2 * Math.sqrt(2 / ((1 - anisotropy) ** 2 + 1));
          return [along, (1 - anisotropy) * along];
        },
      },
      fuzz: {
        weight: 'fuzz_weight',
        color: 'fuzz_color',
        defaultColor: 1,
        roughness: 'fuzz_roughness',
        defaultRoughness: 0.5,
        isWidth: false,
      },
      glass: {
        weight: 'transmission_weight',
        color: 'transmission_color',
        depth: 'transmission_depth',
        thinWalled: 'geometry_thin_walled',
        thickness: '',
        dispersion: ['transmission_dispersion_scale', 'transmission_dispersion_abbe_number', 20],
      },
      normal: 'geometry_normal',
      subsurface: ['subsurface_weight', 'subsurface_color', 0.8],
      unread: ['base_diffuse_roughness', 'transmission_scatter'],
    },
  ],
  [
    'ND_gltf_pbr_surfaceshader',
    {
      color: 'base_color',
      defaultColor: 1,
      metalness: 'metallic',
      defaultMetalness: 1,
      roughness: 'roughness',
      defaultRoughness: 1,
      ior: 'ior',
      specular: 'specular',
      specularColor: 'specular_color',
      coat: {
        weight: 'clearcoat',
        roughness: 'clearcoat_roughness',
        defaultRoughness: 0,
        normal: 'clearcoat_normal',
        unread: [],
      },
      glow: 'emissive',
      defaultGlow: 0,
      glowWeight: 'emissive_strength',
      defaultGlowWeight: 1,
      opacity: 'alpha',
      film: {
        weight: 'iridescence',
        thickness: 'iridescence_thickness',
        defaultThickness: 100,
        unit: 1e-9,
        ior: 'iridescence_ior',
        defaultIor: 1.3,
      },
      grooves: {
        anisotropy: 'anisotropy_strength',
        rotation: 'anisotropy_rotation',
        turn: 1,
        widths: (roughness, anisotropy) => [roughness ** 2 + (1 - roughness ** 2) * anisotropy ** 2, roughness ** 2],
      },
      fuzz: {
        weight: '',
        color: 'sheen_color',
        defaultColor: 0,
        roughness: 'sheen_roughness',
        defaultRoughness: 0,
        isWidth: false,
      },
      glass: {
        weight: 'transmission',
        color: '',
        depth: 'attenuation_distance',
        thinWalled: '',
        thickness: 'thickness',
        dispersion: ['dispersion', '', 20],
      },
      normal: 'normal',
      occlusion: 'occlusion',
      unread: [],
    },
  ],
  [
    'ND_disney_principled',
    {
      color: 'baseColor',
      defaultColor: 0.16,
      metalness: 'metallic',
      defaultMetalness: 0,
      roughness: 'roughness',
      defaultRoughness: 0.5,
      ior: 'ior',
      specular: '',
      specularColor: '',
      glow: '',
      defaultGlow: 0,
      glowWeight: '',
      defaultGlowWeight: 0,
      opacity: '',
      glass: {
        weight: 'specTrans',
        color: '',
        depth: '',
        thinWalled: '',
        thickness: '',
        dispersion: ['', '', 20],
      },
      grooves: {
        anisotropy: 'anisotropic',
        rotation: '',
        turn: 0,
        widths: ROUGHNESS_ANISOTROPY,
      },
      normal: '',
      unread: ['specularTint', 'sheen', 'clearcoat', 'subsurface'],
    },
  ],
  [
    'ND_surface_unlit',
    {
      color: '',
      defaultColor: 0,
      metalness: '',
      defaultMetalness: 0,
      roughness: '',
      defaultRoughness: 1,
      ior: '',
      specular: '',
      specularColor: '',
      glow: 'emission_color',
      defaultGlow: 1,
      glowWeight: 'emission',
      defaultGlowWeight: 1,
      opacity: 'opacity',
      clear: 'transmission',
      normal: '',
      unread: [],
    },
  ],
]);
