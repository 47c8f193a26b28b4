import { msg } from '../../../../messages/message.ts';
import type { CrateSource, Cursor } from './crateSource.ts';
import { readInt32s } from './integerCompression.ts';

/** Maximum depth of prims and variants, as in text. */
const MAX_DEPTH = 256;

/** A path and its spec. */
export class PathNode {
  /** Last path element: the name of a prim or property, `{set=variant}`, `[target]`. */
  readonly element: string;
  readonly isProperty: boolean;
  readonly parent: PathNode | undefined;
  readonly depth: number;
  /** Of the path as text. */
  readonly length: number;
  readonly children: PathNode[] = [];
  /** 0 where there is no spec. */
  specType = 0;
  /** Where its set of fields begins. */
  fieldSet = -1;
  /** Whether the spec has been added to the layer. */
  isBuilt = false;
  private text: string | undefined;

  constructor(element: string, isProperty: boolean, parent: PathNode | undefined) {
    this.element = element;
    this.isProperty = isProperty;
    this.parent = parent;
    this.depth = parent ? parent.depth + 1 : 0;
    this.length = parent ? parent.length + 1 + element.length : 1;
  }

  /** `/A/B.x`, `/A{set=variant}B`. */
  get path(): string {
    const { parent, element } = this;
    if (!parent) return '/';
    this.text ??= parent.path + separator(parent, element, this.isProperty) + element;
    return this.text;
  }
}

function separator(parent: PathNode, element: string, isProperty: boolean): string {
  if (isProperty) return '.';
  return !parent.parent || parent.element.endsWith('}') || /^[{[]/.test(element) ? '' : '/';
}

const A_PATH = msg`a path`;

/** Memory of a path besides its characters [bytes]. */
const NODE_BYTES = 128;

/**
 * The tree of paths, depth first. Of each there is its index, the token of its last part (negative for a property),
 * and a jump: −2 neither child nor sibling, −1 a child, 0 a sibling, else a child and a sibling so many further.
 */
export function readPaths(cursor: Cursor, tokens: readonly string[]): (PathNode | undefined)[] {
  const { source, at } = cursor;
  const count = cursor.i64(msg`the number of paths`);
  const encoded = cursor.i64(msg`the number of encoded paths`);
  if (count < 0 || encoded < 0 || encoded > count) source.fail(msg`it says ${encoded} encoded paths of ${count}`, at);
  source.spend(8 * count, msg`${count} paths`, at);
  const tree: PathTree = {
    indices: readInt32s(cursor, encoded, msg`indices of paths`),
    elements: readInt32s(cursor, encoded, msg`elements of paths`),
    jumps: readInt32s(cursor, encoded, msg`jumps between paths`),
  };
  const paths = new Array<PathNode | undefined>(count).fill(undefined);
  if (encoded > 0) walk(source, tree, tokens, paths, at);
  return paths;
}

interface PathTree {
  readonly indices: Int32Array;
  readonly elements: Int32Array;
  readonly jumps: Int32Array;
}

function walk(
  source: CrateSource,
  { indices, elements, jumps }: PathTree,
  tokens: readonly string[],
  paths: (PathNode | undefined)[],
  at: number,
): void {
  const waiting: [next: number, parent: PathNode | undefined][] = [];
  let parent: PathNode | undefined;
  for (let current = 0, steps = 0; ; steps++) {
    if (current >= indices.length || steps === indices.length)
      source.fail(msg`a jump between paths leads to path ${current} of ${indices.length}, or round in a circle`, at);
    const index = indices[current];
    if (!(index >= 0 && index < paths.length)) source.fail(msg`a path has index ${index} of ${paths.length}`, at);
    if (paths[index]) source.fail(msg`two paths have index ${index}`, at);
    const node = newNode(source, parent, elements[current], tokens, at);
    paths[index] = node;
    const jump = jumps[current];
    if (jump < -2) source.fail(msg`the jump after path ${current} is ${jump}`, at);
    if (jump > 0) waiting.push([current + jump, parent]);
    if (jump > 0 || jump === -1) parent = node;
    if (jump !== -2) {
      current++;
      continue;
    }
    const next = waiting.pop();
    if (!next) return;
    [current, parent] = next;
  }
}

function newNode(
  source: CrateSource,
  parent: PathNode | undefined,
  signed: number,
  tokens: readonly string[],
  at: number,
): PathNode {
  if (!parent) return new PathNode('', false, undefined);
  const element = tokens[Math.abs(signed)];
  if (element === undefined)
    return source.fail(msg`an element of a path is token ${Math.abs(signed)} of ${tokens.length}`, at);
  if (parent.depth === MAX_DEPTH) source.fail(msg`paths are nested more than ${MAX_DEPTH} deep`, at);
  const node = new PathNode(element, signed < 0, parent);
  source.spend(NODE_BYTES + node.length, A_PATH, at);
  parent.children.push(node);
  return node;
}
