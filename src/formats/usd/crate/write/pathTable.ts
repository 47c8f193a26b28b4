import { type Message, msg } from '../../../../messages/message.ts';
import type { ByteSink } from './byteSink.ts';
import { writeInt32s } from './integers.ts';
import type { TokenTable } from './tokenTable.ts';

/** A path in the tree; the root has no parent. */
interface PathEntry {
  readonly index: number;
  /** Its last part as a token, negative for a property. */
  readonly element: number;
  readonly children: Map<string, PathEntry>;
}

/** Parts of a path: `/name`, `{set=variant}`, `.property`, `[target]`; a name follows a variant without a slash. */
const PART = /\/?([^/.{}[\]]+)|(\{[^{}]*\})|\.([^/.{}[\]]+)|(\[[^[\]]*\])/y;

/** All paths of a layer with their indices: a path comes after its parent. Index 0 is the empty path. */
export class PathTable {
  private readonly tokens: TokenTable;
  private readonly root: PathEntry;
  private count = 1;
  private readonly known = new Map<string, PathEntry>();
  private readonly fail: (message: Message) => never;

  constructor(tokens: TokenTable, fail: (message: Message) => never) {
    this.tokens = tokens;
    this.fail = fail;
    this.root = this.entry(0);
    this.known.set('/', this.root);
  }

  private entry(element: number): PathEntry {
    return { index: this.count++, element, children: new Map() };
  }

  index(path: string): number {
    return path === '' ? 0 : (this.known.get(path) ?? this.add(path)).index;
  }

  private add(path: string): PathEntry {
    let at = this.root;
    let from = path.startsWith('/') ? 0 : this.fail(msg`<${path}> is not an absolute path`);
    while (from < path.length) {
      PART.lastIndex = from;
      const part = PART.exec(path);
      if (!part) return this.fail(msg`<${path}> is not the path of a prim or a property`);
      at = this.child(at, part);
      from = PART.lastIndex;
    }
    this.known.set(path, at);
    return at;
  }

  private child(parent: PathEntry, [whole, name, variant, property, target]: RegExpExecArray): PathEntry {
    const key = name ?? whole;
    const known = parent.children.get(key);
    if (known) return known;
    const token = this.tokens.index(name ?? variant ?? property ?? target);
    const child = this.entry(property === undefined ? token : -token);
    parent.children.set(key, child);
    return child;
  }

  /**
   * The tree, depth first: of each path its index, its element, and a jump: −2 neither child nor sibling follows, −1 a
   * child, 0 a sibling, else a child, and a sibling so many further.
   */
  write(sink: ByteSink): void {
    const encoded = this.count - 1;
    const [indices, elements, jumps] = [0, 1, 2].map(() => new Int32Array(encoded));
    let at = 0;
    const visit = (entry: PathEntry, isLast: boolean): void => {
      const here = at++;
      [indices[here], elements[here]] = [entry.index, entry.element];
      let left = entry.children.size;
      for (const child of entry.children.values()) visit(child, --left === 0);
      const hasChild = entry.children.size > 0;
      jumps[here] = hasChild ? (isLast ? -1 : at - here) : isLast ? -2 : 0;
    };
    visit(this.root, true);
    sink.u64(this.count);
    sink.u64(encoded);
    for (const column of [indices, elements, jumps]) writeInt32s(sink, column);
  }
}
