import type { GraphNode } from './document.ts';

/**
 * The node types that the engine itself knows, for they hold a graph together and compute nothing: flattening takes them out.
 * Their titles and words are in the node library like all others'.
 */
/** A subgraph in place: `params.group` is the key of its definition. */
export const GROUP = 'group';
/** Inside a group: its outputs are the group's inputs. */
export const GROUP_INPUT = 'group-input';
/** Inside a group: its inputs are the group's outputs. */
export const GROUP_OUTPUT = 'group-output';
/** A bend in an edge: `in` → `out`. */
export const REROUTE = 'reroute';

/** The key of the definition that a group node uses; empty where none is chosen. */
export const groupKeyOf = ({ params }: GraphNode): string => (typeof params.group === 'string' ? params.group : '');
