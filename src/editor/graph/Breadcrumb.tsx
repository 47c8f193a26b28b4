import type { ReactNode } from 'react';
import { own } from '../../graph/document/document.ts';
import { groupKeyOf } from '../../graph/document/structuralTypes.ts';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import { existingPath, levelAt, useCanvas } from './canvas/canvasState.ts';
import { actionContext, leaveGroup } from './commands/actions.ts';

/** Path of entered groups, with buttons to leave them. */
export function Breadcrumb(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const document = useEditorState((state) => state.history.document);
  const path = existingPath(
    document,
    useCanvas((state) => state.path),
  );
  if (path.length === 0) return null;
  const titles = path.map((node, i) => {
    const held = own(levelAt(document, path.slice(0, i)).graph.nodes, node);
    return held?.title || (held && own(document.groups, groupKeyOf(held))?.title) || t(msg`Group`);
  });
  const go = (depth: number) => {
    const context = actionContext(editor);
    if (context) leaveGroup(context, depth);
  };
  return (
    <nav className="sl-breadcrumb" aria-label={t(msg`Groups that are open`)}>
      {[t(msg`Project`), ...titles].map((title, depth) => (
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
