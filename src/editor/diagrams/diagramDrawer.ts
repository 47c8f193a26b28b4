import type { DiagramLine } from '../../diagrams/diagramLines.ts';
import { type DiagramKind, sceneDiagram } from '../../diagrams/sceneDiagram.ts';
import type { DiagramFrame } from '../../diagrams/spacetimeDiagram.ts';
import { cross, type Vec3 } from '../../math/vec3.ts';
import type { DrawDiagram } from './DiagramView.tsx';
import { keptAxis } from './observerMoves.ts';

export interface DrawerOptions {
  readonly kind: DiagramKind;
  readonly frame: DiagramFrame;
  /** Whether there are two dimensions of space. */
  readonly plane: boolean;
  readonly lines: readonly DiagramLine[];
  /** [m/s] */
  readonly speedOfLight: number;
}

/** Draws the chosen diagram for an observer. The sense of its axis stays while he moves along it. */
export function diagramDrawer({ kind, frame, plane, lines, speedOfLight }: DrawerOptions): DrawDiagram {
  let axis: Vec3 | undefined;
  return (observer, size, span) => {
    axis = keptAxis(axis, observer.u);
    return sceneDiagram(kind, {
      observer,
      speedOfLight,
      lines,
      frame,
      ...(axis && { axis }),
      ...(plane && { secondAxis: besides(axis) }),
      ...(span !== undefined && { span }),
      ...size,
    });
  };
}

/** A second axis, level where there is one: x, or z for what moves along x. */
const besides = (axis: Vec3 = [0, 0, 1]): Vec3 =>
  Math.hypot(...cross(axis, [1, 0, 0])) > 0.3 ? [1, 0, 0] : [0, 0, -1];
