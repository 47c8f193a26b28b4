import type { GraphNode } from './document.ts';

/**
 * Node types that the engine itself knows, since they structure a graph and compute nothing: flattening removes them.
 * Their titles and help are in the node library like those of all others.
 */
/** An instance of a group: `params.group` is the id of its definition. */
export const GROUP = 'group';
/** Inside a group: its outputs are the group's inputs. */
export const GROUP_INPUT = 'group-input';
/** Inside a group: its inputs are the group's outputs. */
export const GROUP_OUTPUT = 'group-output';
/** A bend in an edge: `in` → `out`. */
export const REROUTE = 'reroute';

/** Id of the definition that a group node uses; empty if none is chosen. */
export const groupKeyOf = ({ params }: GraphNode): string => (typeof params.group === 'string' ? params.group : '');
