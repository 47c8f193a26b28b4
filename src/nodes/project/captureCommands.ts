import { type GraphDocument, type GraphEdge, graphIn, own } from '../../graph/document/document.ts';
import type { Command } from '../../graph/edits/commands.ts';
import { insideGroup } from '../../graph/edits/fragment.ts';
import { FreshKeys } from '../../graph/edits/freshKeys.ts';
import { locateNode, type NodeLocation } from '../../graph/edits/locateNode.ts';
import { nearestToOutput, nodesFeedingOutput } from './outputChain.ts';
import { oneByOne, removeLinkCommand } from './projectCommands.ts';

/** Whether what a project shows is taken from captures. */
export const isCaptured = (document: GraphDocument): boolean => nearestToOutput(document, 'capture') !== undefined;

/** Takes what a project shows from captures: a Capture node before the rasterizers, one for those that draw the same view. */
export function captureCommand(document: GraphDocument): Command {
  const fed = new Map<string, { place: NodeLocation; edges: GraphEdge[] }>();
  for (const place of placesOf(document, 'relativity-rasterize')) {
    const edge = own(graphIn(document, place.group)?.edges ?? {}, `${place.node}.view`);
    if (!edge) continue;
    const source = JSON.stringify([place.group, edge.from]);
    const known = fed.get(source);
    if (known) known.edges.push(edge);
    else fed.set(source, { place, edges: [edge] });
  }
  const taken = new Map<string | undefined, FreshKeys>();
  const commands = [...fed.values()].map(({ place: { group, node: rasterizer }, edges }): Command => {
    const level = graphIn(document, group)!;
    const keys = taken.get(group) ?? new FreshKeys(level.nodes);
    taken.set(group, keys);
    const node = keys.next('capture');
    const [x, y] = level.layout[rasterizer] ?? [0, 0];
    const inserted: readonly Command[] = [
      { kind: 'add-node', node, type: 'capture', at: [x - 120, y + 240] },
      { kind: 'connect', edge: { from: edges[0]!.from, to: { node, input: 'view' } } },
      ...edges.map(({ to }): Command => ({ kind: 'connect', edge: { from: { node, output: 'view' }, to } })),
    ];
    return insideGroup(group, { kind: 'batch', commands: inserted });
  });
  return { kind: 'batch', commands };
}

/** Removes every Capture node of what a project shows: it is drawn again. */
export const removeCaptureCommand = (document: GraphDocument): Command => ({
  kind: 'batch',
  commands: oneByOne(document, (left) => {
    const capture = nearestToOutput(left, 'capture');
    return capture && removeLinkCommand(left, capture.id, 'view');
  }),
});

/** Where the nodes of a type are that feed the output, each once, whatever uses its group has. */
function placesOf(document: GraphDocument, type: string): readonly NodeLocation[] {
  const places = nodesFeedingOutput(document)
    .filter((node) => node.type === type)
    .flatMap(({ id }) => locateNode(document, id) ?? []);
  return [...new Map(places.map((place) => [JSON.stringify(place), place])).values()];
}
