import { type Message, msg } from '../../messages/message.ts';
import { type GraphDocument, type GraphEdge, own } from '../document/document.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupKeyOf } from '../document/structuralTypes.ts';
import { ANY, type Registry } from '../nodeType.ts';
import { conversion } from './conversion.ts';
import { type GraphLevel, inputSocket, levelOf, type NodeSockets, socketsOf } from './sockets.ts';

/** One end of an edge with its type. */
interface TypedEndpoint {
  /** `node.socket`, for messages. */
  readonly place: string;
  readonly type: string;
  /** For a generic socket: the type variable shared by all sockets that must have the same type. */
  readonly variable?: string;
}

interface TypeConflict {
  readonly edge: GraphEdge;
  readonly message: Message;
}

/** Types of a level's sockets, with generic ones inferred from connections, and the edges that do not fit. */
export interface LevelTypes {
  /** `any` if connections do not determine the type; undefined if there is no such socket. */
  typeOf(node: string, side: 'inputs' | 'outputs', socket: string): string | undefined;
  readonly conflicts: readonly TypeConflict[];
}

/** `more`: a tentative edge; it replaces the one that feeds the same input. */
export function inferTypes(level: GraphLevel, registry: Registry, more?: GraphEdge): LevelTypes {
  if (more) return inferLevelTypes(level, registry, more);
  const levels = cachedTypes(level.document, registry);
  const known = levels.get(level.group);
  if (known) return known;
  // While a group is being inferred, instances of itself have no types.
  levels.set(level.group, NO_TYPES);
  const found = inferLevelTypes(level, registry);
  levels.set(level.group, found);
  return found;
}

const NO_TYPES: LevelTypes = { typeOf: () => ANY, conflicts: [] };

type TypesByGroup = Map<string | undefined, LevelTypes>;
const inferredTypesCache = new WeakMap<Registry, WeakMap<GraphDocument, TypesByGroup>>();

function cachedTypes(document: GraphDocument, registry: Registry): TypesByGroup {
  const documents = inferredTypesCache.get(registry) ?? new WeakMap<GraphDocument, TypesByGroup>();
  const levels = documents.get(document) ?? new Map();
  inferredTypesCache.set(registry, documents.set(document, levels));
  return levels;
}

function inferLevelTypes(level: GraphLevel, registry: Registry, more?: GraphEdge): LevelTypes {
  const edges = edgesIncluding(Object.values(level.graph.edges), more);
  const variables = new TypeVariables();
  const conflicts: TypeConflict[] = [];
  const typed = edges.flatMap((edge) => {
    const from = endpointOf(level, registry, edge.from.node, 'outputs', edge.from.output);
    const to = endpointOf(level, registry, edge.to.node, 'inputs', edge.to.input);
    return from && to ? [{ edge, from, to }] : [];
  });
  for (const { from, to } of typed) if (from.variable && to.variable) variables.unify(from.variable, to.variable);
  // Sources determine a type; only without any, the sinks do.
  for (const { edge, from, to } of typed) {
    if (from.variable || !to.variable) continue;
    // Of several sources' types, the one that the others convert to.
    const effective = variables.assign(to.variable, from, (other) => conversion(other.type, from.type) !== undefined);
    if (!conversion(from.type, effective.type)) conflicts.push({ edge, message: typeMismatch(from, effective) });
  }
  const sourced = variables.assignedRoots();
  for (const { edge, from, to } of typed) {
    if (to.variable) continue;
    const source = from.variable ? sinkType(variables, sourced, from.variable, to) : from;
    if (!conversion(source.type, to.type)) conflicts.push({ edge, message: typeMismatch(source, to) });
  }
  return {
    conflicts,
    typeOf: (node, side, socket) => {
      const end = endpointOf(level, registry, node, side, socket);
      return end?.variable ? (variables.typeOf(end.variable)?.type ?? ANY) : end?.type;
    },
  };
}

/** Type of a generic output: that of the source, or else one that converts to all sinks. */
function sinkType(
  variables: TypeVariables,
  sourced: ReadonlySet<string>,
  variable: string,
  to: TypedEndpoint,
): TypedEndpoint {
  const effective = variables.typeOf(variable);
  if (effective && sourced.has(variables.find(variable))) return effective;
  return variables.assign(variable, to, (other) => conversion(to.type, other.type) !== undefined);
}

const typeMismatch = (from: TypedEndpoint, to: TypedEndpoint): Message =>
  msg`${from.type} (${from.place}) does not fit ${to.type} (${to.place})`;

const edgesIncluding = (edges: readonly GraphEdge[], more: GraphEdge | undefined): readonly GraphEdge[] =>
  more ? [...edges.filter(({ to }) => to.node !== more.to.node || to.input !== more.to.input), more] : edges;

function endpointOf(
  level: GraphLevel,
  registry: Registry,
  id: string,
  side: keyof NodeSockets,
  name: string,
): TypedEndpoint | undefined {
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
  const type = typeInsideGroup(level, registry, groupKeyOf(node), side, name);
  return type === ANY ? { place, type, variable: `${id}.${side}.${name}` } : { place, type };
}

/** Type of a group's generic socket, inferred inside the group. */
function typeInsideGroup(
  { document }: GraphLevel,
  registry: Registry,
  group: string,
  side: keyof NodeSockets,
  name: string,
): string {
  const inside = levelOf(document, group);
  if (!inside) return ANY;
  const carrier = side === 'inputs' ? GROUP_INPUT : GROUP_OUTPUT;
  const entry = Object.entries(inside.graph.nodes).find(([, { type }]) => type === carrier);
  if (!entry) return ANY;
  return inferTypes(inside, registry).typeOf(entry[0], side === 'inputs' ? 'outputs' : 'inputs', name) ?? ANY;
}

/** Type variables with union–find, and the socket that first determined each type. */
class TypeVariables {
  private readonly parents = new Map<string, string>();
  private readonly known = new Map<string, TypedEndpoint>();

  unify(a: string, b: string): void {
    const [first, second] = [this.find(a), this.find(b)];
    if (first !== second) this.parents.set(first, second);
  }

  /** Assigns a type unless one is assigned that does not give way; returns the effective one. */
  assign(variable: string, end: TypedEndpoint, givesWay: (effective: TypedEndpoint) => boolean): TypedEndpoint {
    const root = this.find(variable);
    const effective = this.known.get(root);
    if (effective && !givesWay(effective)) return effective;
    this.known.set(root, end);
    return end;
  }

  typeOf(variable: string): TypedEndpoint | undefined {
    return this.known.get(this.find(variable));
  }

  /** Roots of all variables with a type. */
  assignedRoots(): ReadonlySet<string> {
    return new Set(this.known.keys());
  }

  find(variable: string): string {
    let root = variable;
    for (let up = this.parents.get(root); up !== undefined; up = this.parents.get(root)) root = up;
    // Path compression.
    for (let at = variable; at !== root; ) {
      const up = this.parents.get(at)!;
      this.parents.set(at, root);
      at = up;
    }
    return root;
  }
}
