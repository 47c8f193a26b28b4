import { resolveParams } from '../../graph/nodeType.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { FALSE_COLORS } from '../../spectrum/falseColor.ts';
import type { Studio } from '../state/studio.ts';

const VIEWS = ['light-cone', 'simultaneity', 'galilean'] as const;

/** What keys and buttons do alike. */
export function nextView(studio: Studio): void {
  const now = VIEWS.map(String).indexOf(String(paramOf(studio, 'console', 'view')));
  studio.set('console', 'view', VIEWS[(now + 1) % VIEWS.length], 'param.view');
}

export function toggleGrid(studio: Studio): void {
  studio.set('rasterize', 'grid', paramOf(studio, 'rasterize', 'grid') !== true, 'param.grid');
}

export function nextFalseColor(studio: Studio): void {
  const kinds = ['none', ...FALSE_COLORS];
  const now = kinds.indexOf(String(paramOf(studio, 'falseColour', 'of')));
  studio.set('falseColour', 'of', kinds[(now + 1) % kinds.length], 'param.falseColor');
}

function paramOf(studio: Studio, node: string, param: string) {
  const held = studio.store.getState().history.document.nodes[node];
  const type = held && nodeLibrary[held.type];
  return type && resolveParams(type, held.params)[param];
}
