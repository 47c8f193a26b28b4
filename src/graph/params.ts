import type { GraphNode, ParamValue } from './document.ts';
import { own } from './document.ts';
import { type NodeType, type ParamSpec, refuseValue, resolveParams } from './nodeType.ts';
import { failure, type NodeResult } from './results.ts';

export type Params = Readonly<Record<string, ParamValue | undefined>>;

/** The parameters of a node without what edges drive. */
export interface OwnParams {
  readonly values: Params;
  /** What tells them from others. */
  readonly key: string;
  readonly refusal?: { readonly param: string; readonly message: string };
}

const known = new WeakMap<NodeType, WeakMap<GraphNode['params'], OwnParams>>();

/** Worked out once for each set of parameters, which nobody changes in place. */
export function ownParams(type: NodeType, set: GraphNode['params']): OwnParams {
  const ofType = known.get(type) ?? new WeakMap<GraphNode['params'], OwnParams>();
  known.set(type, ofType);
  const before = ofType.get(set);
  if (before) return before;
  const values = resolveParams(type, set);
  const found = { values, key: JSON.stringify(values), ...refusalOf(type, set) };
  ofType.set(set, found);
  return found;
}

function refusalOf(type: NodeType, set: GraphNode['params']): Pick<OwnParams, 'refusal'> {
  for (const [param, value] of Object.entries(set)) {
    const spec = own(type.params, param);
    const message = spec ? refuseValue(spec, value) : 'there is no such parameter';
    if (message) return { refusal: { param, message } };
  }
  return {};
}

/** A parameter's value as an edge brings it: what is not 0 switches on. */
export const drivenValue = (spec: ParamSpec, value: unknown): ParamValue =>
  spec.kind === 'boolean' && typeof value === 'number' ? value !== 0 : (value as ParamValue);

/** A value that cannot stand for a parameter, with the default as remedy. */
export function paramFailure(node: string, type: NodeType, param: string, message: string): NodeResult {
  const spec = own(type.params, param);
  return failure('graph.param', `${node}.${param}`, message, spec && { node, param, value: spec.default });
}
