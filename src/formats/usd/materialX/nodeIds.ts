import type { XmlElement } from './xml.ts';

/** Nodes whose definitions are named for the type of `in`, not for that of their result. */
const NAMED_BY_INPUT =
  /^(extract|separate[234]|dotproduct|magnitude|distance|determinant|transformmatrix|creatematrix|randomfloat|randomcolor)$/;
/** Definitions whose names do not follow the rule. */
const IRREGULAR: ReadonlyMap<string, string> = new Map([
  ['disney_principled', 'ND_disney_principled'],
  ['surface_unlit', 'ND_surface_unlit'],
  ['surface', 'ND_surface'],
  ['blackbody', 'ND_blackbody'],
  ['gltf_colorimage', 'ND_gltf_colorimage'],
  ['gltf_normalmap', 'ND_gltf_normalmap_vector3_1_0'],
  ['UsdTransform2d', 'ND_UsdTransform2d'],
  ['UsdUVTexture', 'ND_UsdUVTexture'],
  ['and', 'ND_logical_and'],
  ['or', 'ND_logical_or'],
  ['xor', 'ND_logical_xor'],
  ['not', 'ND_logical_not'],
]);
/** Inputs that may be one number where the result has several. */
const SINGLE = new Set(['in2', 'low', 'high', 'inlow', 'inhigh', 'outlow', 'outhigh', 'amount', 'pivot', 'gamma']);

/** The name of the definition of a node, such as `ND_multiply_color3FA`: its `nodedef`, else by MaterialX's rules. */
export function nodeId({ name, attributes, children }: XmlElement): string {
  const written = attributes.get('nodedef');
  if (written) return written;
  const type = attributes.get('type') ?? '';
  const typeOf = (input: string): string =>
    children.find((child) => child.attributes.get('name') === input)?.attributes.get('type') ?? '';
  const irregular = IRREGULAR.get(name);
  if (irregular) return irregular;
  if (/^(if|switch)/.test(name)) {
    const decided = typeOf(name === 'switch' ? 'which' : 'value1');
    return `ND_${name}_${type}${decided === 'integer' ? 'I' : decided === 'boolean' ? 'B' : ''}`;
  }
  if (name === 'combine2' && type.endsWith('4'))
    return `ND_combine2_${type}${type === 'color4' ? 'CF' : typeOf('in2') === 'float' ? 'VF' : 'VV'}`;
  if (name === 'convert') return `ND_convert_${typeOf('in')}_${type}`;
  if (name === 'gltf_image') return `ND_gltf_image_${type}_${type}_1_0`;
  if (name === 'normalmap') return `ND_normalmap_${typeOf('scale') || 'float'}`;
  if (name === 'mix' && typeOf('mix') === type && type !== 'float') return `ND_mix_${type}_${type}`;
  if (NAMED_BY_INPUT.test(name)) return `ND_${name}_${typeOf('in') || typeOf('in1')}`;
  const single =
    /^(color|vector)[234]$/.test(type) &&
    !/^(ramp|split|mix|combine|saturate|hsvadjust|rotate)/.test(name) &&
    children.some(
      ({ attributes: of }) =>
        SINGLE.has(of.get('name') ?? '') && of.get('type') === 'float' && (typeOf('in') || typeOf('in1')) === type,
    );
  return `ND_${name}_${type}${single ? 'FA' : ''}`;
}
