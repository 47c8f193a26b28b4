import type { CSSProperties, ReactNode } from 'react';
import { useTexts } from '../../language/languageStore.ts';
import { useEditorState } from '../../state/context.tsx';
import { STAGE_TITLES } from '../../state/editor.ts';
import { flatNodeId, useCanvas } from '../canvas/canvasState.ts';

/** Progress of a node's work, or of the work inside a group. */
export function NodeProgress({ id }: { readonly id: string }): ReactNode {
  const { t } = useTexts();
  const name = useCanvas(({ path }) => flatNodeId(path, id));
  const work = useEditorState(({ loading }) =>
    loading && (loading.node === name || loading.node.startsWith(`${name}/`)) ? loading : undefined,
  );
  if (!work) return null;
  const percent = work.part === undefined ? undefined : Math.round(100 * work.part);
  return (
    <span
      className="sl-node-work"
      role="progressbar"
      aria-label={t(STAGE_TITLES[work.stage])}
      aria-valuenow={percent}
      style={{ '--sl-part': `${percent ?? 100}%` } as CSSProperties}
    >
      {percent === undefined ? '…' : `${percent}\u202f%`}
    </span>
  );
}
