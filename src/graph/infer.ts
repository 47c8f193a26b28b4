import { conversion } from './convert.ts';
import { type GraphDocument, type GraphEdge, own } from './document.ts';
import { ANY, type Registry } from './nodeType.ts';
import { inputSocket, type Level, levelOf, type Sockets, socketsOf } from './sockets.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupOf } from './structure.ts';

/** One end of an edge. */
interface End {
  /** `node.socket`, for people. */
  readonly place: string;
  readonly type: string;
  /** Of a generic socket: what all sockets share that must be of one type with it. */
  readonly variable?: string;
}

interface Conflict {
  readonly edge: GraphEdge;
  readonly message: string;
}

/** The types of a level's sockets, the generic ones by what is connected to them, and the edges that do not fit. */
export interface LevelTypes {
  /** `any` where nothing is connected that tells; undefined where there is no such socket. */
  typeOf(node: string, side: 'inputs' | 'outputs', socket: string): string | undefined;
  readonly conflicts: readonly Conflict[];
}

/** `more`: an edge that is tried; it takes the place of the one that feeds the same input. */
export function typesIn(level: Level, registry: Registry, more?: GraphEdge): LevelTypes {
  if (more) return inferred(level, registry, more);
  const levels = knownTypes(level.document, registry);
  const known = levels.get(level.group);
  if (known) return known;
  // While it is looked into, a group that would hold itself tells nothing.
  levels.set(level.group, NOTHING);
  const found = inferred(level, registry);
  levels.set(level.group, found);
  return found;
}

const NOTHING: LevelTypes = { typeOf: () => ANY, conflicts: [] };

type Known = Map<string | undefined, LevelTypes>;
const ofRegistries = new WeakMap<Registry, WeakMap<GraphDocument, Known>>();

function knownTypes(document: GraphDocument, registry: Registry): Known {
  const documents = ofRegistries.get(registry) ?? new WeakMap<GraphDocument, Known>();
  const levels = documents.get(document) ?? new Map();
  ofRegistries.set(registry, documents.set(document, levels));
  return levels;
}

function inferred(level: Level, registry: Registry, more?: GraphEdge): LevelTypes {
  const edges = edgesWith(Object.values(level.graph.edges), more);
  const variables = new Variables();
  const conflicts: Conflict[] = [];
  const typed = edges.flatMap((edge) => {
    const from = endOf(level, registry, edge.from.node, 'outputs', edge.from.output);
    const to = endOf(level, registry, edge.to.node, 'inputs', edge.to.input);
    return from && to ? [{ edge, from, to }] : [];
  });
  for (const { from, to } of typed) if (from.variable && to.variable) variables.join(from.variable, to.variable);
  // What flows in tells the type; only where nothing does, what it flows to.
  for (const { edge, from, to } of typed) {
    if (from.variable || !to.variable) continue;
    // Of what flows in, that which the rest can become.
    const held = variables.tell(to.variable, from, (other) => conversion(other.type, from.type) !== undefined);
    if (!conversion(from.type, held.type)) conflicts.push({ edge, message: misfit(from, held) });
  }
  const sourced = variables.told();
  for (const { edge, from, to } of typed) {
    if (to.variable) continue;
    const source = from.variable ? wanted(variables, sourced, from.variable, to) : from;
    if (!conversion(source.type, to.type)) conflicts.push({ edge, message: misfit(source, to) });
  }
  return {
    conflicts,
    typeOf: (node, side, socket) => {
      const end = endOf(level, registry, node, side, socket);
      return end?.variable ? (variables.of(end.variable)?.type ?? ANY) : end?.type;
    },
  };
}

/** What flows out of a generic socket: what flows in, or else what can become all that is wanted of it. */
function wanted(variables: Variables, sourced: ReadonlySet<string>, variable: string, to: End): End {
  const held = variables.of(variable);
  if (held && sourced.has(variables.root(variable))) return held;
  return variables.tell(variable, to, (other) => conversion(to.type, other.type) !== undefined);
}

const misfit = (from: End, to: End): string => `${from.type} (${from.place}) does not fit ${to.type} (${to.place})`;

const edgesWith = (edges: readonly GraphEdge[], more: GraphEdge | undefined): readonly GraphEdge[] =>
  more ? [...edges.filter(({ to }) => to.node !== more.to.node || to.input !== more.to.input), more] : edges;

function endOf(level: Level, registry: Registry, id: string, side: keyof Sockets, name: string): End | undefined {
  const node = own(level.graph.nodes, id);
  const sockets = node && socketsOf(level, node, registry);
  const socket = sockets && (side === 'inputs' ? inputSocket(sockets, name) : own(sockets.outputs, name));
  if (!socket) return undefined;
  const place = `${id}.${name}`;
  if (socket.type !== ANY) return { place, type: socket.type };
  if (node.type !== GROUP) {
    const carries = node.type === GROUP_INPUT || node.type === GROUP_OUTPUT;
    return { place, type: ANY, variable: carries ? `${node.type}.${name}` : id };
  }
  const type = typeInside(level, registry, groupOf(node), side, name);
  return type === ANY ? { place, type, variable: `${id}.${side}.${name}` } : { place, type };
}

/** What the inside of a group tells of one of its generic sockets. */
function typeInside({ document }: Level, registry: Registry, group: string, side: keyof Sockets, name: string): string {
  const inside = levelOf(document, group);
  if (!inside) return ANY;
  const carrier = side === 'inputs' ? GROUP_INPUT : GROUP_OUTPUT;
  const entry = Object.entries(inside.graph.nodes).find(([, { type }]) => type === carrier);
  if (!entry) return ANY;
  return typesIn(inside, registry).typeOf(entry[0], side === 'inputs' ? 'outputs' : 'inputs', name) ?? ANY;
}

/** Type variables, of which some have been found equal, with the first socket that told what each is. */
class Variables {
  readonly #parents = new Map<string, string>();
  readonly #known = new Map<string, End>();

  join(a: string, b: string): void {
    const [first, second] = [this.root(a), this.root(b)];
    if (first !== second) this.#parents.set(first, second);
  }

  /** Says what a variable is, where nothing has before, or where what has gives way; returns what holds. */
  tell(variable: string, end: End, givesWay: (held: End) => boolean): End {
    const root = this.root(variable);
    const held = this.#known.get(root);
    if (held && !givesWay(held)) return held;
    this.#known.set(root, end);
    return end;
  }

  of(variable: string): End | undefined {
    return this.#known.get(this.root(variable));
  }

  /** The roots of all of which something is known. */
  told(): ReadonlySet<string> {
    return new Set(this.#known.keys());
  }

  root(variable: string): string {
    let root = variable;
    for (let up = this.#parents.get(root); up !== undefined; up = this.#parents.get(root)) root = up;
    // Next time the way is short.
    for (let at = variable; at !== root; ) {
      const up = this.#parents.get(at)!;
      this.#parents.set(at, root);
      at = up;
    }
    return root;
  }
}
