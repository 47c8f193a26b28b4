import { Button } from '@mantine/core';
import type { ReactNode } from 'react';
import { graphIn } from '../../graph/document/document.ts';
import { locateNode } from '../../graph/edits/locateNode.ts';
import type { NodeProblem } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { formatNumber } from '../format.ts';
import { useTexts } from '../language/languageStore.ts';
import { useEditor, useEditorState } from '../state/context.tsx';

/** Button that applies a problem's suggested fix. */
export function Remedy({ remedy }: { readonly remedy: NonNullable<NodeProblem['remedy']> }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const type = useEditorState(({ history: { document } }) => {
    const place = locateNode(document, remedy.node);
    return (place && graphIn(document, place.group)?.nodes[place.node]?.type) ?? '';
  });
  const spec = nodeLibrary[type]?.params[remedy.param];
  const unit = spec?.kind === 'number' ? ` ${spec.unit ?? ''}` : '';
  const shown = typeof remedy.value === 'number' ? formatNumber(remedy.value) : String(remedy.value);
  return (
    <Button
      size="compact-xs"
      variant="light"
      className="sl-remedy"
      onClick={() => editor.set(remedy.node, remedy.param, remedy.value, msg`the suggested remedy`)}
    >
      {shown === ''
        ? t(msg`Clear ${t(spec?.title ?? remedy.param)}`)
        : t(msg`Set ${t(spec?.title ?? remedy.param)} to ${`${shown}${unit}`.trim()}`)}
    </Button>
  );
}
