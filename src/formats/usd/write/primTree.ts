import { block, type Lines, primName } from './usdaText.ts';

/** What a prim is, apart from its children that have prims of their own. */
export interface PrimContent {
  readonly type: string;
  readonly metadata?: Lines;
  readonly properties: Lines;
  /** Prims written whole, such as subsets and shaders. */
  readonly inner?: readonly Lines[];
}

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
    const wanted = names.at(-1)!;
    let name = wanted;
    for (let n = 1; parent.children.get(name)?.content; n++) name = `${wanted}_${n}`;
    const claimed: PrimContent = { type: 'Xform', properties: [] };
    parent.children.set(name, { children: parent.children.get(name)?.children ?? new Map(), content: claimed });
    return `/${[...names.slice(0, -1), name].join('/')}`;
  }

  set(path: string, content: PrimContent): void {
    this.node(path.split('/').filter(Boolean)).content = content;
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

  rootNames(): string[] {
    return [...this.root.children.keys()];
  }

  lines(): Lines {
    return [...this.root.children].flatMap(([name, node]) => ['', ...nodeLines(name, node)]);
  }
}

function nodeLines(name: string, node: PrimTreeNode): Lines {
  const content = node.content ?? { type: holdsOnlyMaterials(node) ? 'Scope' : 'Xform', properties: [] };
  const inner = [
    ...(content.inner ?? []),
    ...[...node.children].map(([child, childNode]) => nodeLines(child, childNode)),
  ];
  const spaced = inner.flatMap((lines, i) => (i === 0 && content.properties.length === 0 ? lines : ['', ...lines]));
  return block(`def ${content.type} "${name}"`, [...content.properties, ...spaced], content.metadata);
}

const holdsOnlyMaterials = (node: PrimTreeNode): boolean =>
  [...node.children.values()].every((c) => (c.content ? c.content.type === 'Material' : holdsOnlyMaterials(c)));
