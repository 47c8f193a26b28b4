import { own, type ParamValue } from '../../graph/document/document.ts';
import { resolveParams } from '../../graph/nodeType.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { nearestToOutput } from '../../nodes/project/outputChain.ts';
import { FALSE_COLOR_QUANTITIES } from '../../spectrum/falseColor/falseColor.ts';
import type { Editor } from '../state/editor.ts';

const VIEWS = ['light-cone', 'simultaneity', 'galilean'] as const;

/** What keys and buttons do alike: where the project has no such node, nothing. */
export const nextView = (studio: Editor): void =>
  change(studio, 'relativity-console', 'view', (now) => next(VIEWS, now), 'param.view');

export const toggleGrid = (studio: Editor): void =>
  change(studio, 'relativity-rasterize', 'grid', (now) => now !== true, 'param.grid');

export const nextFalseColor = (studio: Editor): void =>
  change(studio, 'false-colour', 'of', (now) => next(['none', ...FALSE_COLOR_QUANTITIES], now), 'param.falseColor');

/** The observer leaves the camera that he rode on. */
export const leaveCamera = (studio: Editor): void => change(studio, 'scene-camera', 'ride', () => false, 'param.ride');

const next = (values: readonly string[], now: ParamValue | undefined): string =>
  values[(values.indexOf(String(now)) + 1) % values.length]!;

/** Of a type, the node that is nearest to the output. */
function change(
  studio: Editor,
  typeId: string,
  param: string,
  to: (now: ParamValue | undefined) => ParamValue,
  label: string,
): void {
  const node = nearestToOutput(studio.store.getState().history.document, typeId);
  const type = own(nodeLibrary, typeId);
  if (node && type) studio.set(node.id, param, to(resolveParams(type, node.params)[param]), label);
}
