import type { ParamValue } from '../document/document.ts';
import type { NodeProblem, Outputs } from '../nodeType.ts';

export type NodeResult =
  /** `interim`: it is, or was made of, what work has given on its way. */
  | { readonly status: 'done'; readonly outputs: Outputs; readonly interim?: true }
  | { readonly status: 'failed'; readonly problem: NodeProblem }
  /** A node before it failed: the first that did. */
  | { readonly status: 'blocked'; readonly by: string };

/** What identifies the work of a node: the same content gives the same result. */
export type ContentKey = string;

/** What so many numbers make is told apart by value: a vector, a colour. What is longer, by being the same array. */
const MAX_BY_VALUE = 4;

/**
 * Results under the content that made them: the type, the parameters and the values of the inputs. Numbers and texts are told apart by
 * value, all else by identity, so that 2 + 3 and 4 + 1 lead to the same work. Those of the latest evaluation stay, and some before them.
 */
export class ResultCache {
  private readonly capacity: number;
  /** Least recently used first. */
  private readonly kept = new Map<ContentKey, { readonly result: NodeResult; readonly node: string }>();
  private readonly identities = new WeakMap<object, number>();
  private count = 0;

  /** `capacity`: how many are kept beside those in use. */
  constructor(capacity: number) {
    this.capacity = capacity;
  }

  keyOf(type: string, params: string, inputs: readonly (readonly [string, unknown])[]): ContentKey {
    return `${type} ${params} ${inputs.map(([name, value]) => `${name}:${this.identity(value)}`).join(' ')}`;
  }

  /** A problem that stood at the node which first had this content stands at the one that has it now. */
  get(content: ContentKey, node: string): NodeResult | undefined {
    const kept = this.kept.get(content);
    if (!kept) return undefined;
    this.kept.delete(content);
    this.kept.set(content, kept);
    return resultAtNode(kept.result, kept.node, node);
  }

  set(content: ContentKey, node: string, result: NodeResult): void {
    this.kept.delete(content);
    this.kept.set(content, { result, node });
  }

  /** Forgets the oldest; `used`: how many the evaluation needed that has just ended. */
  trim(used: number): void {
    for (const oldest of this.kept.keys()) {
      if (this.kept.size <= used + this.capacity) break;
      this.kept.delete(oldest);
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

/** −0 divides to −∞, so it is not 0. */
const primitiveKey = (value: unknown): string =>
  typeof value === 'string' ? JSON.stringify(value) : Object.is(value, -0) ? '-0' : String(value);

/** The same result, of another node. */
export function resultAtNode(result: NodeResult, before: string, node: string): NodeResult {
  if (result.status !== 'failed' || before === node) return result;
  const { problem } = result;
  const place = problem.place === before ? node : problem.place;
  const remedy = problem.remedy?.node === before ? { ...problem.remedy, node } : problem.remedy;
  return { status: 'failed', problem: { ...problem, place, ...(remedy && { remedy }) } };
}

export const failure = (
  code: string,
  place: string,
  message: string,
  remedy?: { readonly node: string; readonly param: string; readonly value: ParamValue },
): NodeResult => ({
  status: 'failed',
  problem: { severity: 'error', code, place, message, ...(remedy && { remedy }) },
});
