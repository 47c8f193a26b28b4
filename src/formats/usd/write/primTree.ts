import type { PrimSpec } from '../layer/layer.ts';
import { type PrimContent, primSpec } from '../layer/specs.ts';

interface PrimTreeNode {
  content?: PrimContent;
  readonly children: Map<string, PrimTreeNode>;
}

/** Prims by path, to be written as they nest. */
export class PrimTree {
  private readonly root: PrimTreeNode = { children: new Map() };

  /** Claims a path for a prim: names become valid and the last one unique. Returns the path that is written. */
  claim(path: string): string {
    const names = path.split('/').filter(Boolean).map(primName);
    if (names.length === 0) names.push('Prim');
    const parent = this.node(names.slice(0, -1));
    const name = freeName(names.at(-1)!, (taken) => parent.children.get(taken)?.content !== undefined);
    const claimed: PrimContent = { type: 'Xform', properties: [] };
    parent.children.set(name, { children: parent.children.get(name)?.children ?? new Map(), content: claimed });
    return `/${[...names.slice(0, -1), name].join('/')}`;
  }

  set(path: string, content: PrimContent): void {
    this.node(path.split('/').filter(Boolean)).content = content;
  }

  /** A name for a prim that is written with that at `path`, besides those that have paths of their own. */
  innerName(path: string, wanted: string): string {
    const { children } = this.node(path.split('/').filter(Boolean));
    return freeName(wanted, (taken) => children.has(taken));
  }

  private node(names: readonly string[]): PrimTreeNode {
    let node = this.root;
    for (const name of names) {
      const child = node.children.get(name) ?? { children: new Map() };
      node.children.set(name, child);
      node = child;
    }
    return node;
  }

  rootPrims(): Map<string, PrimSpec> {
    return primsOf('', this.root);
  }
}

function freeName(wanted: string, isTaken: (name: string) => boolean): string {
  let name = wanted;
  for (let n = 1; isTaken(name); n++) name = `${wanted}_${n}`;
  return name;
}

const primsOf = (path: string, { children }: PrimTreeNode): Map<string, PrimSpec> =>
  new Map([...children].map(([name, node]) => [name, primOf(`${path}/${name}`, node)]));

function primOf(path: string, node: PrimTreeNode): PrimSpec {
  const content = node.content ?? { type: holdsOnlyMaterials(node) ? 'Scope' : 'Xform', properties: [] };
  return primSpec(path, content, primsOf(path, node));
}

const holdsOnlyMaterials = (node: PrimTreeNode): boolean =>
  [...node.children.values()].every((c) => (c.content ? c.content.type === 'Material' : holdsOnlyMaterials(c)));

/** A name that USD allows for a prim: letters, digits and _, not first a digit. */
export function primName(name: string): string {
  const safe = name.replaceAll(/[^\p{L}\p{N}_]/gu, '_');
  return /^[\p{L}_]/u.test(safe) ? safe : `_${safe}`;
}
