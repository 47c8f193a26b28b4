import { msg } from '../../messages/message.ts';
import { localized } from '../terminal/language.ts';

interface PathTreeNode {
  note?: string;
  readonly children: Map<string, PathTreeNode>;
}

/** Formats paths like `/World/Cube` as an indented tree with notes. */
export function treeLines(entries: readonly { path: string; note: string }[]): string[] {
  const root: PathTreeNode = { children: new Map() };
  for (const { path, note } of entries) {
    let node = root;
    for (const name of path.split('/').filter(Boolean)) node = childOf(node, name);
    node.note = note;
  }
  return linesOf(root, '');
}

function childOf(node: PathTreeNode, name: string): PathTreeNode {
  const child = node.children.get(name) ?? { children: new Map() };
  node.children.set(name, child);
  return child;
}

function linesOf(node: PathTreeNode, indent: string): string[] {
  return [...node.children].flatMap(([name, child], i) => {
    const last = i === node.children.size - 1;
    const line = `${indent}${last ? '└─ ' : '├─ '}${name}${child.note ? localized(msg`  (${child.note})`) : ''}`;
    return [line, ...linesOf(child, indent + (last ? '   ' : '│  '))];
  });
}
