import { diagramBodies } from './diagramLines.ts';
import { energyDiagram } from './energyDiagram.ts';
import type { Diagram } from './marks.ts';
import { type SpacetimeDiagram, type SpacetimeDiagramSpec, spacetimeDiagram } from './spacetimeDiagram.ts';

/** What a diagram is of. */
export const DIAGRAM_KINDS = ['spacetime', 'energy'] as const;
export type DiagramKind = (typeof DIAGRAM_KINDS)[number];

/** A diagram of either kind about an observer and world lines of a scene; that of energy needs no axes. */
export function sceneDiagram(kind: DiagramKind, spec: SpacetimeDiagramSpec): Diagram | SpacetimeDiagram {
  const { lines, observer, speedOfLight, width, height } = spec;
  if (kind === 'spacetime') return spacetimeDiagram(spec);
  return energyDiagram({ bodies: diagramBodies(lines, observer, speedOfLight), width, height });
}
