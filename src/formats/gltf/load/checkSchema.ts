import type { GLTF } from '@gltf-transform/core';
import { type Message, msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { gltfError } from '../context.ts';

/** Schema of the parts of glTF in use: types of values. References are checked in checkReferences.ts. */

/** Throws for a value of the wrong type; `place`: as in `nodes[3].mesh`. */
type SchemaCheck = (value: unknown, place: string) => void;

class SchemaError extends MessageError {
  readonly place: string;
  constructor(place: string, value: unknown, wanted: Message) {
    const shown = JSON.stringify(value);
    super(shown === undefined ? msg`is missing, not ${wanted}` : msg`is ${shortened(shown)}, not ${wanted}`);
    this.place = place;
  }
}

const shortened = (text: string): string => (text.length > 40 ? `${text.slice(0, 40)}…` : text);

const kind =
  (isOne: (value: unknown) => boolean, wanted: Message): SchemaCheck =>
  (value, place) => {
    if (!isOne(value)) throw new SchemaError(place, value, wanted);
  };
const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const number = kind(Number.isFinite, msg`a finite number`);
const index = kind((value) => Number.isSafeInteger(value) && (value as number) >= 0, msg`a whole number from 0`);
const text = kind((value) => typeof value === 'string', msg`a text`);
const object = kind(isObject, msg`an object`);
const array = kind(Array.isArray, msg`an array`);

const optional =
  (of: SchemaCheck): SchemaCheck =>
  (value, place) => {
    if (value !== undefined) of(value, place);
  };
const list =
  (of: SchemaCheck, length?: number): SchemaCheck =>
  (value, place) => {
    array(value, place);
    const items = value as readonly unknown[];
    if (length !== undefined && items.length !== length) throw new SchemaError(place, value, msg`${length} numbers`);
    for (const [i, item] of items.entries()) of(item, `${place}[${i}]`);
  };
const fields =
  (of: Readonly<Record<string, SchemaCheck>>): SchemaCheck =>
  (value, place) => {
    object(value, place);
    for (const [name, check] of Object.entries(of)) {
      check((value as Record<string, unknown>)[name], place === '' ? name : `${place}.${name}`);
    }
  };
/** An object with arbitrary keys. */
const each =
  (of: SchemaCheck): SchemaCheck =>
  (value, place) => {
    object(value, place);
    for (const [name, item] of Object.entries(value as object)) of(item, `${place}.${name}`);
  };
const extensions = (of: Readonly<Record<string, SchemaCheck>>): SchemaCheck =>
  optional(fields(Object.fromEntries(Object.entries(of).map(([name, check]) => [name, optional(check)]))));

const picture = optional(fields({ index, texCoord: optional(index) }));
const primitive = fields({
  attributes: each(index),
  indices: optional(index),
  material: optional(index),
  mode: optional(index),
  targets: optional(list(each(index))),
  extensions: extensions({
    KHR_draco_mesh_compression: fields({ bufferView: index, attributes: each(index) }),
    KHR_materials_variants: fields({ mappings: list(fields({ material: index, variants: list(index) })) }),
  }),
});
const meshopt = fields({
  count: index,
  byteStride: index,
  byteLength: index,
  buffer: index,
  mode: text,
  filter: optional(text),
});

const perspective = fields({ type: text, perspective: fields({ yfov: number }) });
const orthographic = fields({ type: text, orthographic: object });
const camera: SchemaCheck = (value, place) => {
  object(value, place);
  const check = (value as { type?: unknown }).type === 'perspective' ? perspective : orthographic;
  check(value, place);
};
/** Embedded or external. */
const image: SchemaCheck = (value, place) => {
  fields({ name: optional(text), uri: optional(text), bufferView: optional(index), mimeType: optional(text) })(
    value,
    place,
  );
  const { uri, bufferView } = value as GLTF.IImage;
  if (uri === undefined && bufferView === undefined)
    throw new SchemaError(place, value, msg`a picture: it needs uri or bufferView`);
};

const factor = optional(number);
const color = optional(list(number, 3));
/** Of those that are read. */
const MATERIAL_EXTENSIONS: Readonly<Record<string, SchemaCheck>> = {
  KHR_materials_anisotropy: fields({
    anisotropyStrength: factor,
    anisotropyRotation: factor,
    anisotropyTexture: picture,
  }),
  KHR_materials_clearcoat: fields({
    clearcoatFactor: factor,
    clearcoatTexture: picture,
    clearcoatRoughnessFactor: factor,
    clearcoatRoughnessTexture: picture,
    clearcoatNormalTexture: picture,
  }),
  KHR_materials_emissive_strength: fields({ emissiveStrength: factor }),
  KHR_materials_ior: fields({ ior: factor }),
  KHR_materials_pbrSpecularGlossiness: fields({
    diffuseFactor: optional(list(number, 4)),
    diffuseTexture: picture,
    specularFactor: color,
    glossinessFactor: factor,
    specularGlossinessTexture: picture,
  }),
  KHR_materials_dispersion: fields({ dispersion: factor }),
  KHR_materials_iridescence: fields({
    iridescenceFactor: factor,
    iridescenceTexture: picture,
    iridescenceIor: factor,
    iridescenceThicknessMinimum: factor,
    iridescenceThicknessMaximum: factor,
    iridescenceThicknessTexture: picture,
  }),
  KHR_materials_sheen: fields({
    sheenColorFactor: color,
    sheenColorTexture: picture,
    sheenRoughnessFactor: factor,
    sheenRoughnessTexture: picture,
  }),
  KHR_materials_transmission: fields({ transmissionFactor: factor, transmissionTexture: picture }),
  KHR_materials_volume: fields({
    thicknessFactor: factor,
    thicknessTexture: picture,
    attenuationDistance: factor,
    attenuationColor: color,
  }),
  KHR_materials_specular: fields({
    specularFactor: factor,
    specularTexture: picture,
    specularColorFactor: color,
    specularColorTexture: picture,
  }),
};

const FILE = fields({
  asset: fields({ version: optional(text) }),
  scene: optional(index),
  extensionsUsed: optional(list(text)),
  extensionsRequired: optional(list(text)),
  extensions: extensions({
    KHR_lights_punctual: fields({ lights: list(fields({ type: text, range: optional(number) })) }),
    KHR_materials_variants: fields({ variants: list(fields({ name: optional(text) })) }),
  }),
  buffers: optional(list(fields({ byteLength: index, uri: optional(text) }))),
  bufferViews: optional(
    list(
      fields({
        buffer: index,
        byteLength: index,
        byteOffset: optional(index),
        byteStride: optional(index),
        extensions: extensions({ EXT_meshopt_compression: meshopt, KHR_meshopt_compression: meshopt }),
      }),
    ),
  ),
  accessors: optional(
    list(
      fields({
        componentType: index,
        count: index,
        type: text,
        bufferView: optional(index),
        byteOffset: optional(index),
        sparse: optional(
          fields({
            count: index,
            indices: fields({ bufferView: index, componentType: index, byteOffset: optional(index) }),
            values: fields({ bufferView: index, byteOffset: optional(index) }),
          }),
        ),
      }),
    ),
  ),
  images: optional(list(image)),
  samplers: optional(list(object)),
  textures: optional(list(fields({ source: optional(index), sampler: optional(index) }))),
  materials: optional(
    list(
      fields({
        name: optional(text),
        pbrMetallicRoughness: optional(
          fields({
            baseColorFactor: optional(list(number, 4)),
            baseColorTexture: picture,
            metallicRoughnessTexture: picture,
            metallicFactor: optional(number),
            roughnessFactor: optional(number),
          }),
        ),
        emissiveFactor: optional(list(number, 3)),
        emissiveTexture: picture,
        normalTexture: picture,
        occlusionTexture: picture,
        alphaCutoff: optional(number),
        extensions: extensions(MATERIAL_EXTENSIONS),
      }),
    ),
  ),
  meshes: optional(
    list(fields({ name: optional(text), primitives: list(primitive), weights: optional(list(number)) })),
  ),
  nodes: optional(
    list(
      fields({
        name: optional(text),
        children: optional(list(index)),
        mesh: optional(index),
        skin: optional(index),
        camera: optional(index),
        matrix: optional(list(number, 16)),
        translation: optional(list(number, 3)),
        rotation: optional(list(number, 4)),
        scale: optional(list(number, 3)),
        weights: optional(list(number)),
        extensions: extensions({
          EXT_mesh_gpu_instancing: fields({ attributes: each(index) }),
          KHR_lights_punctual: fields({ light: index }),
        }),
      }),
    ),
  ),
  skins: optional(
    list(fields({ joints: list(index), inverseBindMatrices: optional(index), skeleton: optional(index) })),
  ),
  cameras: optional(list(camera)),
  animations: optional(
    list(
      fields({
        name: optional(text),
        samplers: list(fields({ input: index, output: index })),
        channels: list(fields({ sampler: index, target: fields({ node: optional(index), path: text }) })),
      }),
    ),
  ),
  scenes: optional(list(fields({ name: optional(text), nodes: optional(list(index)) }))),
});

/** Validates the JSON; throws with the place and value of an error. */
export function checkSchema(entry: string, json: unknown): GLTF.IGLTF {
  try {
    FILE(json, '');
    return json as GLTF.IGLTF;
  } catch (thrown) {
    if (!(thrown instanceof SchemaError)) throw thrown;
    throw gltfError(entry, 'gltf.invalid', thrown.place, msg`${thrown.text}; the file is damaged, export it again`);
  }
}
