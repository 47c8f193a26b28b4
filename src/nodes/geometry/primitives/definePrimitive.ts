import { NodeRefusal, type NumberParam, type ParamSpec, type ParamValueOf } from '../../../graph/nodeType.ts';
import { type LocalizedText, type Message, msg } from '../../../messages/message.ts';
import { makeObject, makeScene } from '../../../scene/defaults.ts';
import type { Mesh } from '../../../scene/types.ts';
import { defineNode, type ParamTable } from '../../defineNode.ts';
import type { Services } from '../../services.ts';

/** A length of a primitive [m]. */
export const lengthParam = (title: LocalizedText, value: number): NumberParam => ({
  kind: 'number',
  title,
  unit: 'm',
  default: value,
  min: 1e-6,
  max: 1e9,
  step: 0.001,
  slider: false,
});

/** A number of subdivisions. */
export const countParam = (title: LocalizedText, value: number, least: number, most: number): NumberParam => ({
  kind: 'number',
  title,
  default: value,
  min: least,
  max: most,
  step: 1,
  integer: true,
});

/** The axis of a round primitive. */
export const axisParam = {
  kind: 'choice',
  title: msg`Axis`,
  default: 'Y',
  options: [
    { value: 'X', title: msg`X` },
    { value: 'Y', title: msg`Y` },
    { value: 'Z', title: msg`Z` },
  ],
} as const satisfies ParamSpec;

type PrimitiveParams<P extends ParamTable> = { readonly [K in keyof P]: ParamValueOf<P[K]> };

/** Where a mesh is made, with its services. */
interface MeshContext {
  readonly node: string;
  readonly services: Services;
}

/** Defines a node that makes one mesh at rest at the origin: `/name` of the scene. */
export function definePrimitive<const P extends ParamTable>(description: {
  readonly id: string;
  readonly title: Message;
  readonly help: Message;
  /** Default prim name. */
  readonly name: string;
  readonly params: P;
  mesh(params: PrimitiveParams<P>, work: MeshContext): Mesh | Promise<Mesh>;
}) {
  const { id, title, help, name, params, mesh } = description;
  return defineNode({
    id,
    title,
    help,
    category: 'geometry',
    params: {
      name: { kind: 'text', title: msg`Name`, help: msg`Name in the scene: letters, digits and _.`, default: name },
      ...params,
    },
    inputs: {},
    outputs: { geometry: { type: 'geometry' } },
    async evaluate(_inputs, values, work) {
      const path = rootPrimPath(values.name as string, work.node);
      const object = makeObject({ path, mesh: await mesh(values as unknown as PrimitiveParams<P>, work) });
      return { geometry: { scene: makeScene({ name: path.slice(1), objects: [object] }) } };
    },
  });
}

/** A valid USD identifier: letters, digits and _, not starting with a digit. */
export function rootPrimPath(name: string, node: string): string {
  if (/^[\p{L}_][\p{L}\p{N}_]{0,63}$/u.test(name)) return `/${name}`;
  const message = msg`"${name}" cannot be a name: letters, digits and _ can, at most 64, and no digit first`;
  const remedy = { node, param: 'name', value: name.replace(/[^\p{L}\p{N}_]/gu, '_').replace(/^(?=\p{N}|$)/u, '_') };
  throw new NodeRefusal({ severity: 'error', code: 'primitive.name', place: `${node}.name`, message, remedy });
}
