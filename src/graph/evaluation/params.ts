import { type Message, msg } from '../../messages/message.ts';
import type { GraphNode, ParamValue } from '../document/document.ts';
import { own } from '../document/document.ts';
import { type NodeType, type ParamSpec, resolveParams, valueError } from '../nodeType.ts';
import { failure, type NodeResult } from './resultCache.ts';

export type ParamValues = Readonly<Record<string, ParamValue | undefined>>;

/** The parameters of a node, excluding driven ones. */
export interface StoredParams {
  readonly values: ParamValues;
  /** Identifies their values. */
  readonly key: string;
  readonly refusal?: { readonly param: string; readonly message: Message };
}

const storedParamsCache = new WeakMap<NodeType, WeakMap<GraphNode['params'], StoredParams>>();

/** Memoized per params object, which is never mutated. */
export function storedParams(type: NodeType, set: GraphNode['params']): StoredParams {
  const ofType = storedParamsCache.get(type) ?? new WeakMap<GraphNode['params'], StoredParams>();
  storedParamsCache.set(type, ofType);
  const before = ofType.get(set);
  if (before) return before;
  const values = resolveParams(type, set);
  const found = { values, key: JSON.stringify(values), ...findInvalidParam(type, set) };
  ofType.set(set, found);
  return found;
}

function findInvalidParam(type: NodeType, set: GraphNode['params']): Pick<StoredParams, 'refusal'> {
  for (const [param, value] of Object.entries(set)) {
    const spec = own(type.params, param);
    const message = spec ? valueError(spec, value) : msg`there is no such parameter`;
    if (message) return { refusal: { param, message } };
  }
  return {};
}

/** The value of a driven parameter; for switches, non-zero is on. */
export const drivenValue = (spec: ParamSpec, value: unknown): ParamValue =>
  spec.kind === 'boolean' && typeof value === 'number' ? value !== 0 : (value as ParamValue);

/** A value that is not valid for a parameter, with the default as remedy. */
export function paramFailure(node: string, type: NodeType, param: string, message: Message): NodeResult {
  const spec = own(type.params, param);
  return failure('graph.param', `${node}.${param}`, message, spec && { node, param, value: spec.default });
}
