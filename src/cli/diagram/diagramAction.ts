import { type DiagramLine, diagramLine } from '../../diagrams/diagramLines.ts';
import { sceneDiagram } from '../../diagrams/sceneDiagram.ts';
import type { SpacetimeDiagramSpec } from '../../diagrams/spacetimeDiagram.ts';
import { diagramSvg } from '../../diagrams/svg.ts';
import { cross, length } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import type { Scene } from '../../scene/types.ts';
import { validate } from '../../scene/validation/validate.ts';
import type { ProbeObserver } from '../../scene/views/viewRecord.ts';
import { writeFileAtomically } from '../files/outputFile.ts';
import { observerPath } from '../flags/observerPath.ts';
import { speedOfLight } from '../flags/viewFlags.ts';
import { openSceneOrProject, thingsOf } from '../project/sceneOrProject.ts';
import { reportDiagnostics } from '../terminal/diagnostics.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { localized } from '../terminal/language.ts';
import type { DiagramFlags } from './diagramFlags.ts';

/** Of one picture. */
const MAX_LINES = 2000;

export async function diagram(path: string, given: DiagramFlags, names: ReadonlySet<string>): Promise<void> {
  checkFlags(given);
  const { scene, flags } = await openSceneOrProject(path, given, names);
  const c = speedOfLight(scene, flags.c);
  reportDiagnostics([...scene.diagnostics, ...validate(scene, c)]);
  const t = flags.time ?? scene.hints.openAt ?? scene.startTime;
  const observer = observerPath(scene, flags, c, t)(t);
  const drawn = sceneDiagram(flags.of, specOf(flags, diagramLines(scene, flags, c), observer, c));
  writeFileAtomically(flags.output, new TextEncoder().encode(diagramSvg(drawn, flags.theme, localized)));
  console.log(flags.output);
}

function checkFlags({ output, axis, secondAxis }: DiagramFlags): void {
  if (!output.toLowerCase().endsWith('.svg'))
    throw usageError(msg`-o ${output}: diagrams are written as .svg; the page also saves them as .png`);
  if (axis && length(axis) === 0) throw usageError(msg`--axis 0,0,0 is no direction`);
  if (secondAxis && length(secondAxis) === 0) throw usageError(msg`--second-axis 0,0,0 is no direction`);
  if (axis && secondAxis && length(cross(axis, secondAxis)) < 1e-9 * length(axis) * length(secondAxis))
    throw usageError(msg`--second-axis lies along --axis: give another direction`);
}

function diagramLines(scene: Scene, { prim }: DiagramFlags, c: number): readonly DiagramLine[] {
  const objects = thingsOf(scene, prim, c);
  if (objects.length > MAX_LINES)
    throw usageError(msg`${objects.length} world lines are too many; choose up to ${MAX_LINES} by --prim`);
  return objects.map((object) => diagramLine(object, c));
}

function specOf(
  { axis, secondAxis, span, frame, size }: DiagramFlags,
  lines: readonly DiagramLine[],
  observer: ProbeObserver,
  c: number,
): SpacetimeDiagramSpec {
  return {
    observer,
    speedOfLight: c,
    lines,
    frame,
    ...(axis && { axis }),
    ...(secondAxis && { secondAxis }),
    ...(span !== undefined && { span }),
    ...size,
  };
}
