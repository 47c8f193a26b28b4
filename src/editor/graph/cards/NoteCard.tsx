import { type NodeProps, NodeResizer } from '@xyflow/react';
import { memo, type ReactNode } from 'react';
import type { GraphNote } from '../../../graph/document/document.ts';
import { insideGroup } from '../../../graph/edits/fragment.ts';
import { msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditor } from '../../state/context.tsx';
import type { Editor } from '../../state/editor.ts';
import { canvas, levelAt, useCanvas } from '../canvas/canvasState.ts';
import type { FrameNode, NoteNode } from '../canvas/flowElements.ts';
import { InlineEditor } from './InlineEditor.tsx';

const MIN_SIZE: readonly [width: number, height: number] = [100, 44];

function setNote(editor: Editor, note: string, value: GraphNote): void {
  const { group } = levelAt(editor.store.getState().history.document, canvas.getState().path);
  editor.edit(insideGroup(group, { kind: 'set-note', note, value }), msg`note`);
}

/** A note on the canvas. */
export const NoteCard = memo(function NoteCard({ data: { id, note }, selected }: NodeProps<NoteNode>): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const writing = useCanvas((state) => state.editing === `note:${id}`);
  return (
    <div className="sl-note" data-selected={selected || undefined}>
      <NodeResizer
        isVisible={selected}
        minWidth={MIN_SIZE[0]}
        minHeight={MIN_SIZE[1]}
        lineClassName="sl-resize-line"
        handleClassName="sl-resize"
        onResizeEnd={(_event, { x, y, width, height }) =>
          setNote(editor, id, {
            ...note,
            at: [Math.round(x), Math.round(y)],
            size: [Math.round(width), Math.round(height)],
          })
        }
      />
      {writing ? (
        <InlineEditor
          label={t(msg`Add a note`)}
          words={note.text}
          long
          take={(text) => setNote(editor, id, { ...note, text })}
        />
      ) : (
        <p>{note.text || <em>{t(msg`Empty note`)}</em>}</p>
      )}
    </div>
  );
});

/** A frame around nodes: fits itself to them, and moves them when its title is dragged. */
export const FrameBox = memo(function FrameBox({ data: { id, frame }, selected }: NodeProps<FrameNode>): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const writing = useCanvas((state) => state.editing === `frame:${id}`);
  const rename = (title: string) => {
    const { group } = levelAt(editor.store.getState().history.document, canvas.getState().path);
    editor.edit(insideGroup(group, { kind: 'set-frame', frame: id, value: { ...frame, title } }), msg`rename`);
  };
  return (
    <div className="sl-frame" data-selected={selected || undefined}>
      <div className="sl-frame-title">
        {writing ? (
          <InlineEditor label={t(msg`Title of the frame`)} words={frame.title} take={rename} />
        ) : (
          frame.title || <em>{t(msg`Frame`)}</em>
        )}
      </div>
    </div>
  );
});
