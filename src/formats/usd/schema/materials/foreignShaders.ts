import { scale, type Vec3 } from '../../../../math/vec3.ts';
import { type LocalizedText, msg } from '../../../../messages/message.ts';
import { numberOf, textAt, textOf, vec3Of } from '../../layer/attributes.ts';
import type { PrimSpec, Value } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import { type ResolvedInput, resolveInput, shaderId } from './shaderInputs.ts';

/** Input names in shaders of MaterialX, MDL, RenderMan, Arnold and others; the first authored one counts. */
const INPUT_NAMES = {
  color: [
    'diffuseColor',
    'base_color',
    'baseColor',
    'diffuse_color_constant',
    'diffuse_tint',
    'diffuse_color',
    'diffuse_reflection_color',
    'diffuse',
    'albedo',
    'color',
  ],
  picture: ['diffuse_texture', 'base_color_texture', 'baseColorTexture', 'albedo_texture'],
  weight: ['base', 'base_weight', 'diffuseGain'],
  roughness: [
    'roughness',
    'specular_roughness',
    'specularRoughness',
    'reflection_roughness_constant',
    'base_roughness',
  ],
  metallic: ['metallic', 'metalness', 'base_metalness', 'metallic_constant'],
  glow: ['emissiveColor', 'emission_color', 'emissive', 'emissive_color', 'glowColor'],
  glowWeight: ['emission', 'glowGain'],
  opacity: ['opacity', 'geometry_opacity', 'opacity_constant', 'alpha', 'presence'],
  ior: ['ior', 'specular_IOR', 'specular_ior', 'ior_constant'],
} as const;

/** The supported part of another renderer's material. */
export interface ForeignMaterial {
  readonly color?: Vec3;
  /** Asset of a colour texture, looked up by the mesh's default uvs. */
  readonly texture?: Value;
  readonly roughness?: number;
  readonly metallic?: number;
  readonly emissive?: Vec3;
  readonly opacity?: number;
  readonly ior?: number;
}

/** The shaders of a Material's surface outputs: the universal one first, then those of render contexts (`outputs:mtlx:surface`). */
export function surfaceShaders({ layer, startCode }: StageContext, material: PrimSpec): PrimSpec[] {
  const names = [...material.properties.keys()].filter((name) => /^outputs:([^:]+:)*surface$/.test(name));
  names.sort((a, b) => a.split(':').length - b.split(':').length);
  return names.flatMap((name) => {
    const { shader } = resolveInput(layer, material, name, startCode);
    return shader ? [shader] : [];
  });
}

/** A shader's id, or its name in its source asset. */
export function shaderName(shader: PrimSpec): LocalizedText {
  const inSource = ['info:mdl:sourceAsset:subIdentifier', 'info:sourceAsset:subIdentifier'];
  return (
    shaderId(shader) || inSource.map((name) => textAt(shader, name, undefined)).find(Boolean) || msg`without an id`
  );
}

/** Base colour, metalness, roughness and emission, as far as they are constants or one texture; undefined if there are none. */
export function foreignMaterial(context: StageContext, shader: PrimSpec): ForeignMaterial | undefined {
  const input = (names: readonly string[]): ResolvedInput => {
    for (const name of names) {
      const found = resolveInput(context.layer, shader, `inputs:${name}`, context.startCode);
      if (found.value || found.shader) return found;
    }
    return {};
  };
  const base = input(INPUT_NAMES.color);
  const weight = numberOf(input(INPUT_NAMES.weight).value) ?? 1;
  const picture = assetOf(input(INPUT_NAMES.picture).value) ?? (base.shader && upstreamTexture(context, base.shader));
  const color = vec3Of(base.value) ?? (base.shader && !picture ? upstreamConstant(context, base.shader) : undefined);
  const glow = vec3Of(input(INPUT_NAMES.glow).value);
  const glowWeight =
    numberOf(input(INPUT_NAMES.glowWeight).value) ?? (input(['emissive', 'emissiveColor']).value ? 1 : 0);
  const opacity = input(INPUT_NAMES.opacity).value;
  const found: ForeignMaterial = {
    ...(color && { color: scale(color, weight) }),
    ...(picture && { texture: picture }),
    ...defined('roughness', numberOf(input(INPUT_NAMES.roughness).value)),
    ...defined('metallic', numberOf(input(INPUT_NAMES.metallic).value)),
    ...defined('opacity', numberOf(opacity) ?? vec3Of(opacity)?.[1]),
    ...defined('ior', numberOf(input(INPUT_NAMES.ior).value)),
    ...(glow && glowWeight > 0 && { emissive: scale(glow, glowWeight) }),
  };
  return Object.keys(found).length > 0 ? found : undefined;
}

const defined = (name: string, value: number | undefined) =>
  value !== undefined && Number.isFinite(value) ? { [name]: value } : {};

const assetOf = (value: Value | undefined): Value | undefined =>
  value?.type === 'asset' && textOf(value) ? value : undefined;

/** Maximum depth and number of network nodes visited. */
const MAX_UPSTREAM_NODES = 64;

/** Breadth-first search through the inputs of a shader and its upstream nodes; returns the first match. */
function findUpstream<T>(
  context: StageContext,
  shader: PrimSpec,
  find: (name: string, value: Value) => T | undefined,
): T | undefined {
  const queue = [shader];
  const visited = new Set(queue);
  for (const at of queue)
    for (const name of at.properties.keys()) {
      if (!name.startsWith('inputs:')) continue;
      const input = resolveInput(context.layer, at, name, context.startCode);
      const found = input.value && find(name, input.value);
      if (found !== undefined) return found;
      if (!input.shader || visited.has(input.shader) || queue.length >= MAX_UPSTREAM_NODES) continue;
      visited.add(input.shader);
      queue.push(input.shader);
    }
  return undefined;
}

const upstreamTexture = (context: StageContext, shader: PrimSpec): Value | undefined =>
  findUpstream(context, shader, (_, value) => assetOf(value));

const upstreamConstant = (context: StageContext, shader: PrimSpec): Vec3 | undefined =>
  findUpstream(context, shader, (_, value) => (value.type === 'float3' ? vec3Of(value) : undefined));
