import type { ReactNode } from 'react';
import { own } from '../../graph/document.ts';
import { groupOf } from '../../graph/structure.ts';
import { useTexts } from '../i18n/i18n.ts';
import { useStudio, useStudioState } from '../state/context.tsx';
import { contextOf, leave } from './actions.ts';
import { levelAt, pathIn, useCanvas } from './canvas.ts';

/** In which group the canvas is, and the way out. */
export function Breadcrumb(): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
  const document = useStudioState((state) => state.history.document);
  const path = pathIn(
    document,
    useCanvas((state) => state.path),
  );
  if (path.length === 0) return null;
  const titles = path.map((node, i) => {
    const held = own(levelAt(document, path.slice(0, i)).graph.nodes, node);
    return held?.title || (held && own(document.groups, groupOf(held))?.title) || t('node.group');
  });
  const go = (depth: number) => {
    const context = contextOf(studio);
    if (context) leave(context, depth);
  };
  return (
    <nav className="sl-breadcrumb" aria-label={t('graph.where')}>
      {[t('graph.project'), ...titles].map((title, depth) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: levels are told apart by their depth
        <span key={depth}>
          {depth > 0 && <span aria-hidden> › </span>}
          {depth < path.length ? (
            <button type="button" onClick={() => go(depth)}>
              {title}
            </button>
          ) : (
            <strong aria-current="page">{title}</strong>
          )}
        </span>
      ))}
    </nav>
  );
}
