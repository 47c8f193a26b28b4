import type { Vec3 } from '../../../../../math/vec3.ts';
import { listed, msg } from '../../../../../messages/message.ts';
import type { Clearcoat, SpecularReflection } from '../../../../../scene/materials/layers.ts';
import type { Material } from '../../../../../scene/types.ts';
import type { PrimSpec } from '../../../layer/layer.ts';
import { shaderId } from '../shaderInputs.ts';
import type { ColorPrimvar } from '../textureReader.ts';
import type { UvSource } from '../uvs.ts';
import { computed, constant, type Expression, isSame, scaled, sizeOf } from './expression.ts';
import { filmOf } from './film.ts';
import { fuzzOf } from './fuzz.ts';
import { glassOf, tinted } from './glass.ts';
import { groovesOf } from './grooves.ts';
import type { ShadingNetwork } from './network.ts';
import { NetworkReader } from './networkReader.ts';
import { SURFACES, type SurfaceModel } from './surfaceModels.ts';

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
  const written = await input(model.roughness);
  const grooves = await groovesOf(reader, shader, written, model.defaultRoughness, model.grooves);
  const roughness = reader.scalarOf(grooves.roughness, model.defaultRoughness);
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
      ...(grooves.layer && { anisotropy: grooves.layer }),
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
      grooves.uv,
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
  if (color && isSame(color, belowColor)) return color;
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
