import type { Vec3 } from '../../../../../math/vec3.ts';
import { listed, msg } from '../../../../../messages/message.ts';
import type { Clearcoat, SpecularReflection } from '../../../../../scene/materials/layers.ts';
import type { Material } from '../../../../../scene/types.ts';
import type { PrimSpec } from '../../../layer/layer.ts';
import { shaderId } from '../shaderInputs.ts';
import type { ColorPrimvar } from '../textureReader.ts';
import type { UvSource } from '../uvs.ts';
import { computed, constant, type Expression, scaled, sizeOf } from './expression.ts';
import { type FilmInputs, filmOf } from './film.ts';
import { type FuzzInputs, fuzzOf } from './fuzz.ts';
import { type GlassInputs, glassOf, tinted } from './glass.ts';
import type { ShadingNetwork } from './network.ts';
import { NetworkReader } from './networkReader.ts';

/** Which inputs of a surface mean what; values are those of the definitions where nothing is written. */
interface SurfaceModel {
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
  unread: ['diffuse_roughness', 'specular_anisotropy', 'transmission_scatter', 'transmission_extra_roughness'],
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
const SURFACES: ReadonlyMap<string, SurfaceModel> = new Map<string, SurfaceModel>([
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
      unread: ['base_diffuse_roughness', 'specular_roughness_anisotropy', 'transmission_scatter'],
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
      unread: ['anisotropy_strength'],
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
      normal: '',
      unread: ['anisotropic', 'specularTint', 'sheen', 'clearcoat', 'subsurface'],
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

export const isNetworkSurface = (shader: PrimSpec): boolean => SURFACES.has(shaderId(shader));

/** A material made by a shading network, and the primvars that it needs. */
export interface NetworkMaterial {
  readonly material: Omit<Material, 'name'>;
  readonly uvs: readonly (UvSource | undefined)[];
  readonly colors: ColorPrimvar | undefined;
  readonly isPainted: boolean;
}

/** What a surface of MaterialX means as our material; the rest is told. */
export async function networkMaterial(network: ShadingNetwork, shader: PrimSpec): Promise<NetworkMaterial> {
  const model = SURFACES.get(shaderId(shader))!;
  const reader = new NetworkReader(network, shader);
  const input = (name: string): Promise<Expression | undefined> =>
    name === '' ? Promise.resolve(undefined) : network.input(shader, name);
  await tellOthers(
    network,
    shader,
    model.unread.map((name) => [name, 0]),
  );

  const opacity = reader.opacityOf(await opaqueShare(network, shader, model));
  const colored = await tinted(network, shader, await colorOf(network, shader, model), model.glass);
  const diffuse = reader.colorOf(colored, grey(model.defaultColor), opacity.alphaOf);
  const glow = (await input(model.glow)) ?? constant(...grey(model.defaultGlow));
  const glowWeight = (await input(model.glowWeight)) ?? constant(model.defaultGlowWeight);
  const emissive = reader.colorOf(product(glow, glowWeight), BLACK);
  const roughness = reader.scalarOf(await input(model.roughness), model.defaultRoughness);
  const metallic = reader.scalarOf(await input(model.metalness), model.defaultMetalness);
  const occlusion = reader.scalarOf(await input(model.occlusion ?? ''), 1);
  const bent = await input(model.normal);
  const normals = bent?.kind === 'normals' ? reader.normalsOf(bent.encoded, bent.strength) : undefined;
  if (bent && bent.kind !== 'normals' && bent.kind !== 'constant')
    network.tell('mtlx.input', shader, msg`${model.normal} is no normal map; it is not drawn`);
  const ior = await iorOf(network, shader, model);
  const specular = await specularOf(reader, shader, model);
  const coat = await coatOf(reader, shader, model);
  const glass = await glassOf(reader, shader, model.glass, network.unit);
  const film = await filmOf(reader, shader, model.film);
  const fuzz = await fuzzOf(reader, shader, model.fuzz);
  return {
    material: {
      baseColor: diffuse.color,
      ...(diffuse.texture && { baseColorTexture: diffuse.texture }),
      emissive: emissive.primvar ? BLACK : emissive.color,
      ...(emissive.texture && { emissiveTexture: emissive.texture }),
      roughness: roughness.value,
      ...(roughness.texture && { roughnessTexture: roughness.texture }),
      metallic: metallic.value,
      ...(metallic.texture && { metallicTexture: metallic.texture }),
      ...(normals && { normalTexture: normals.texture }),
      ...(occlusion.texture && { occlusionTexture: occlusion.texture }),
      opacity: opacity.value,
      opacityThreshold: await thresholdOf(network, shader),
      ...(ior !== undefined && { ior }),
      ...(specular.layer && { specular: specular.layer }),
      ...(coat.layer && { clearcoat: coat.layer }),
      ...glass.material,
      ...(film.layer && { iridescence: film.layer }),
      ...(fuzz.layer && { sheen: fuzz.layer }),
    },
    uvs: [
      diffuse.uv,
      emissive.uv,
      opacity.uv,
      normals?.uv,
      roughness.uv,
      metallic.uv,
      occlusion.uv,
      ...specular.uvs,
      ...coat.uvs,
      ...glass.uvs,
      film.uv,
      ...fuzz.uvs,
    ],
    colors: diffuse.primvar,
    isPainted: diffuse.texture !== undefined || diffuse.primvar !== undefined,
  };
}

/** The base colour: weighted, and mixed with that of light scattered below the surface. */
async function colorOf(
  network: ShadingNetwork,
  shader: PrimSpec,
  model: SurfaceModel,
): Promise<Expression | undefined> {
  const base = (model.color && (await network.input(shader, model.color))) || constant(...grey(model.defaultColor));
  const weight = model.weight ? await network.input(shader, model.weight) : undefined;
  const color = weight ? product(base, weight) : base;
  const [name, colorName, otherwise] = model.subsurface ?? [''];
  const below = name === '' ? undefined : await network.input(shader, name);
  if (!below || (below.kind === 'constant' && below.values[0] === 0)) return color;
  network.tell(
    'mtlx.input',
    shader,
    msg`${name} is drawn as a diffuse colour, without light that travels below the surface`,
  );
  const belowColor = (await network.input(shader, colorName!)) ?? constant(...grey(otherwise!));
  if (below.kind === 'constant' && below.values[0] === 1) return belowColor;
  if (!color) return belowColor;
  return (
    computed([color, belowColor, below], 3, ([a, b, [t]]) => [0, 1, 2].map((k) => a[k] * (1 - t) + b[k] * t)) ?? color
  );
}

/** What is not transparent: neither by opacity nor because light passes. */
async function opaqueShare(
  network: ShadingNetwork,
  shader: PrimSpec,
  model: SurfaceModel,
): Promise<Expression | undefined> {
  const opacity = await alphaOf(network, shader, model);
  const through = model.clear ? await network.input(shader, model.clear) : undefined;
  const kept = through && scaled(through, [-1], [1]);
  return kept && opacity ? product(opacity, kept) : (kept ?? opacity);
}

/** The opacity; gltf_pbr ignores its alpha in the mode OPAQUE. */
async function alphaOf(
  network: ShadingNetwork,
  shader: PrimSpec,
  model: SurfaceModel,
): Promise<Expression | undefined> {
  if (model.opacity === '') return undefined;
  if (model.opacity === 'alpha' && (await numberOf(network, shader, 'alpha_mode', 0)) === 0) return undefined;
  return network.input(shader, model.opacity);
}

const thresholdOf = async (network: ShadingNetwork, shader: PrimSpec): Promise<number> =>
  (await numberOf(network, shader, 'alpha_mode', 0)) === 1 ? numberOf(network, shader, 'alpha_cutoff', 0.5) : 0;

/** The refractive index; that of nothing where a surface only glows. */
async function iorOf(network: ShadingNetwork, shader: PrimSpec, model: SurfaceModel): Promise<number | undefined> {
  if (model.ior === '') return 1;
  const written = await network.input(shader, model.ior);
  if (written && written.kind !== 'constant')
    network.tell('mtlx.input', shader, msg`${model.ior} varies over the surface, which is not drawn`);
  return written?.kind === 'constant' ? written.values[0] : undefined;
}

/** A layer of the surface, and the texture coordinates that it needs. */
interface Layered<T> {
  readonly layer?: T;
  readonly uvs: readonly (UvSource | undefined)[];
}

/** Strength and colour of the reflection, unless they are 1 and white. */
async function specularOf(
  reader: NetworkReader,
  shader: PrimSpec,
  { specular, specularColor }: SurfaceModel,
): Promise<Layered<SpecularReflection>> {
  if (specular === '') return { uvs: [] };
  const factor = reader.scalarOf(await reader.network.input(shader, specular), 1);
  const color = reader.colorOf(await reader.network.input(shader, specularColor), WHITE);
  if (!factor.texture && !color.texture && factor.value === 1 && color.color.every((x) => x === 1)) return { uvs: [] };
  return {
    layer: {
      factor: factor.value,
      ...(factor.texture && { factorTexture: factor.texture }),
      color: color.primvar ? WHITE : color.color,
      ...(color.texture && { colorTexture: color.texture }),
    },
    uvs: [factor.uv, color.uv],
  };
}

/** The varnish, if there is one. */
async function coatOf(reader: NetworkReader, shader: PrimSpec, { coat }: SurfaceModel): Promise<Layered<Clearcoat>> {
  const weight = coat && reader.scalarOf(await reader.network.input(shader, coat.weight), 0);
  if (!weight || (weight.value === 0 && !weight.texture)) return { uvs: [] };
  const roughness = reader.scalarOf(await reader.network.input(shader, coat.roughness), coat.defaultRoughness);
  const bent = await reader.network.input(shader, coat.normal);
  const normals = bent?.kind === 'normals' ? reader.normalsOf(bent.encoded, bent.strength) : undefined;
  await tellOthers(reader.network, shader, coat.unread);
  return {
    layer: {
      factor: weight.value,
      ...(weight.texture && { factorTexture: weight.texture }),
      roughness: roughness.value,
      ...(roughness.texture && { roughnessTexture: roughness.texture }),
      ...(normals && { normalTexture: normals.texture }),
    },
    uvs: [weight.uv, roughness.uv, normals?.uv],
  };
}

/** Tells of inputs that are not read and do not have the given value. */
async function tellOthers(
  network: ShadingNetwork,
  shader: PrimSpec,
  inputs: readonly (readonly [name: string, value: number])[],
): Promise<void> {
  const left: string[] = [];
  for (const [name, value] of inputs) {
    const found = await network.input(shader, name);
    if (found && (found.kind !== 'constant' || found.values.some((x) => x !== value))) left.push(name);
  }
  if (left.length > 0) network.tell('mtlx.input', shader, msg`${listed(left)} of this material is not drawn`);
}

async function numberOf(network: ShadingNetwork, shader: PrimSpec, name: string, otherwise: number): Promise<number> {
  const found = await network.input(shader, name);
  return found?.kind === 'constant' ? found.values[0] : otherwise;
}

/** A colour times a number or colour. */
function product(color: Expression, factor: Expression): Expression | undefined {
  if (factor.kind === 'constant') return scaled(color, factor.values, [0]);
  if (color.kind === 'constant' && sizeOf(factor) >= 3) return scaled(factor, color.values, [0]);
  return computed([color, factor], 3, ([a, b]) => [0, 1, 2].map((k) => (a[k] ?? a[0]) * (b[k] ?? b[0])));
}

const grey = (x: number): Vec3 => [x, x, x];
const BLACK: Vec3 = [0, 0, 0];
const WHITE: Vec3 = [1, 1, 1];
