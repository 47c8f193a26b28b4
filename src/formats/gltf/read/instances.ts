import type { Accessor, Node as GltfNode } from '@gltf-transform/core';
import type { InstancedMesh } from '@gltf-transform/extensions';
import { fromParts } from '../../../math/mat4.ts';
import { normalizeQuat, toMatrix } from '../../../math/quat.ts';
import { type LocalizedText, listed, msg } from '../../../messages/message.ts';
import { type GltfContext, gltfError } from '../context.ts';
import { floatsOf } from './accessors.ts';
import type { NodeTransform } from './nodes.ts';

/** Maximum number of instances of one node; each becomes an object. */
export const MAX_INSTANCES = 2 ** 16;
const WIDTHS: ReadonlyMap<string, number> = new Map([
  ['TRANSLATION', 3],
  ['ROTATION', 4],
  ['SCALE', 3],
]);

/** Instance transforms of EXT_mesh_gpu_instancing in the node's frame; undefined if absent. */
export function readInstances(context: GltfContext, node: GltfNode, what: LocalizedText): NodeTransform[] | undefined {
  const instanced = node.getExtension<InstancedMesh>('EXT_mesh_gpu_instancing');
  if (!instanced) return undefined;
  const others = instanced.listSemantics().filter((name) => !WIDTHS.has(name));
  if (others.length > 0) {
    context.notes.add('info', 'gltf.instance-attributes', what, msg`${listed(others)} of its instances are left out`);
  }
  const count = instanced.listAttributes()[0]?.getCount() ?? 0;
  if (count > MAX_INSTANCES) {
    throw gltfError(
      context.entry,
      'gltf.too-large',
      what,
      msg`has ${count} instances; at most ${MAX_INSTANCES} are read`,
    );
  }
  const values = (name: string): Float32Array | undefined => {
    const accessor = instanced.getAttribute(name);
    return accessor ? valuesOf(context, what, name, accessor, count) : undefined;
  };
  const [translation, rotation, scale] = [...WIDTHS.keys()].map(values);
  return Array.from({ length: count }, (_, i) => placement(translation, rotation, scale, i));
}

function valuesOf(
  context: GltfContext,
  what: LocalizedText,
  name: string,
  accessor: Accessor,
  count: number,
): Float32Array {
  if (accessor.getElementSize() === WIDTHS.get(name) && accessor.getCount() === count) return floatsOf(accessor);
  const message = msg`${name} of its instances has ${accessor.getCount()} of ${accessor.getType()}, for ${count}; export it again`;
  throw gltfError(context.entry, 'gltf.bad-attribute', what, message);
}

type InstanceValues = Float32Array | undefined;

function placement(
  translation: InstanceValues,
  rotation: InstanceValues,
  scale: InstanceValues,
  i: number,
): NodeTransform {
  const [x, y, z] = translation?.subarray(3 * i) ?? [0, 0, 0];
  const [qx, qy, qz, qw] = rotation?.subarray(4 * i) ?? [0, 0, 0, 1];
  const sizes = scale?.subarray(3 * i) ?? [1, 1, 1];
  const turn = normalizeQuat([qx, qy, qz, qw]);
  const linear = toMatrix(turn).map((value, k) => value * sizes[k % 3]);
  return { matrix: fromParts(linear, [x, y, z]), rotation: turn };
}
