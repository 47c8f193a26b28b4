import type { LocalizedText, Message } from '../../messages/message.ts';
import type { ParamValue } from '../document/document.ts';
import type { NodeProblem, Outputs } from '../nodeType.ts';

/** What became of a node: its outputs, its problem, or the node upstream that failed. */
export type NodeResult =
  /** `interim`: whether it is, or depends on, an interim result. */
  | { readonly status: 'done'; readonly outputs: Outputs; readonly interim?: true }
  | { readonly status: 'failed'; readonly problem: NodeProblem }
  /** An upstream node failed: the first that did. */
  | { readonly status: 'blocked'; readonly by: string };

/** Identifies the work of a node: equal content gives equal results. */
export type ContentKey = string;

/** Arrays up to this length (vectors, colours) are compared by value, longer ones by identity. */
const MAX_BY_VALUE = 4;

/**
 * Results by the content that made them: type, parameters and input values. Numbers and texts are compared by value,
 * all else by identity, so that 2 + 3 and 4 + 1 lead to the same work downstream. Keeps those of the latest evaluation
 * and some older ones.
 */
export class ResultCache {
  private readonly capacity: number;
  /** Least recently used first. */
  private readonly entries = new Map<ContentKey, { readonly result: NodeResult; readonly node: string }>();
  private readonly identities = new WeakMap<object, number>();
  private count = 0;

  /** `capacity`: number kept beyond those in use. */
  constructor(capacity: number) {
    this.capacity = capacity;
  }

  keyOf(type: string, params: string, inputs: readonly (readonly [string, unknown])[]): ContentKey {
    return `${type} ${params} ${inputs.map(([name, value]) => `${name}:${this.identity(value)}`).join(' ')}`;
  }

  /** A cached problem is reported at the node that has the content now. */
  get(content: ContentKey, node: string): NodeResult | undefined {
    const entries = this.entries.get(content);
    if (!entries) return undefined;
    this.entries.delete(content);
    this.entries.set(content, entries);
    return resultAtNode(entries.result, entries.node, node);
  }

  set(content: ContentKey, node: string, result: NodeResult): void {
    this.entries.delete(content);
    this.entries.set(content, { result, node });
  }

  /** Evicts the oldest; `used`: number of results that the last evaluation needed. */
  trim(used: number): void {
    for (const oldest of this.entries.keys()) {
      if (this.entries.size <= used + this.capacity) break;
      this.entries.delete(oldest);
    }
  }

  private identity(value: unknown): string {
    if (Array.isArray(value) && value.length <= MAX_BY_VALUE && value.every(isPrimitive))
      return `[${value.map(primitiveKey).join()}]`;
    if (typeof value !== 'object' || value === null) return primitiveKey(value);
    const known = this.identities.get(value) ?? ++this.count;
    this.identities.set(value, known);
    return `#${known}`;
  }
}

const isPrimitive = (value: unknown): boolean => typeof value === 'number' || typeof value === 'string';

/** −0 differs from 0, since division by it gives −∞. */
const primitiveKey = (value: unknown): string =>
  typeof value === 'string' ? JSON.stringify(value) : Object.is(value, -0) ? '-0' : String(value);

/** The same result, attributed to another node. */
export function resultAtNode(result: NodeResult, before: string, node: string): NodeResult {
  if (result.status !== 'failed' || before === node) return result;
  const { problem } = result;
  const place = problem.place === before ? node : problem.place;
  const remedy = problem.remedy?.node === before ? { ...problem.remedy, node } : problem.remedy;
  return { status: 'failed', problem: { ...problem, place, ...(remedy && { remedy }) } };
}

export const failure = (
  code: string,
  place: LocalizedText,
  message: Message,
  remedy?: { readonly node: string; readonly param: string; readonly value: ParamValue },
): NodeResult => ({
  status: 'failed',
  problem: { severity: 'error', code, place, message, ...(remedy && { remedy }) },
});
