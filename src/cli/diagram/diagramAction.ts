import { chosenObjects, type DiagramLine, diagramLine, suggestedPaths } from '../../diagrams/diagramLines.ts';
import { sceneDiagram } from '../../diagrams/sceneDiagram.ts';
import type { SpacetimeDiagramSpec } from '../../diagrams/spacetimeDiagram.ts';
import { diagramSvg } from '../../diagrams/svg.ts';
import { cross, length } from '../../math/vec3.ts';
import { listed, msg } from '../../messages/message.ts';
import { initialBeta } from '../../nodes/pictures/renderSettings.ts';
import type { Scene } from '../../scene/types.ts';
import { validate } from '../../scene/validation/validate.ts';
import type { ProbeObserver } from '../../scene/views/viewRecord.ts';
import { writeFileAtomically } from '../files/outputFile.ts';
import { observerPath } from '../flags/observerPath.ts';
import { openSceneWithFlags } from '../flags/openScene.ts';
import { speedOfLight } from '../flags/viewFlags.ts';
import { isProject, openProjectPicture, refuseSets } from '../project/project.ts';
import { reportDiagnostics } from '../terminal/diagnostics.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { localized } from '../terminal/language.ts';
import { Progress } from '../terminal/progress.ts';
import type { DiagramFlags } from './diagramFlags.ts';

/** Things that are drawn unless they are chosen, and lines of one picture. */
const [SUGGESTED, MAX_LINES] = [12, 2000];

export async function diagram(path: string, given: DiagramFlags, names: ReadonlySet<string>): Promise<void> {
  checkFlags(given);
  const { scene, flags } = await openDiagramScene(path, given, names);
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

/** A scene file, or a project's scene with its picture's observer and speed of light where the flags do not say them. */
async function openDiagramScene(
  path: string,
  flags: DiagramFlags,
  given: ReadonlySet<string>,
): Promise<{ readonly scene: Scene; readonly flags: DiagramFlags }> {
  if (!(await isProject(path))) {
    refuseSets(flags.set);
    return { scene: await openSceneWithFlags(path, flags), flags };
  }
  const progress = new Progress();
  const picture = await openProjectPicture(path, flags.set ?? [], given, progress.node);
  progress.clear();
  const { scene, speedOfLight: c, camera, course } = picture;
  const beta = flags.position ? undefined : initialBeta(picture, false);
  const cameraPath = given.has('cameraPath') || course ? flags.cameraPath : 'straight';
  return { scene, flags: { c, ...(camera && { camera }), ...(beta && { beta }), ...flags, cameraPath } };
}

function diagramLines(scene: Scene, { prim }: DiagramFlags, c: number): readonly DiagramLine[] {
  for (const path of prim ?? []) {
    if (chosenObjects(scene, [path]).length > 0) continue;
    const near = scene.objects.map((object) => object.path).slice(0, 8);
    throw usageError(msg`--prim ${path}: the scene has no such thing; it has ${listed(near) || msg`none`}`);
  }
  const objects = chosenObjects(scene, prim ?? suggestedPaths(scene, SUGGESTED));
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
