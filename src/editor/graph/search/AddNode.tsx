import { Paper } from '@mantine/core';
import { type ReactNode, useEffect, useMemo, useRef } from 'react';
import { msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditor, useEditorState } from '../../state/context.tsx';
import type { Editor } from '../../state/editor.ts';
import { type AddNodeRequest, canvas, levelAt, selectItems } from '../canvas/canvasState.ts';
import { NODE_WIDTH } from '../cards/cardGeometry.ts';
import { edgeBetween, socketOptions } from '../commands/connections.ts';
import { addNodeCommand as addCommand, connectCommand } from '../commands/edits.ts';
import { findFreePosition } from '../layout/freePosition.ts';
import { addableNodes } from './addableNodes.ts';
import { QuickPick } from './QuickPick.tsx';
import { useNodeItems } from './useNodeItems.ts';

const WIDTH = 320;
const HEIGHT = 360;

/** The list of nodes that can be added, at the requested place. */
export function AddNode({
  adding,
  panel,
}: {
  readonly adding: AddNodeRequest;
  readonly panel: HTMLElement | null;
}): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const host = useRef<HTMLDivElement>(null);
  const close = () => canvas.setState({ adding: undefined });
  const back = () => {
    close();
    canvas.getState().viewport?.focus();
  };
  useEffect(() => {
    host.current?.querySelector('input')?.focus({ preventScroll: true });
    const onPointerDown = (event: PointerEvent) => {
      if (event.target instanceof Node && !host.current?.contains(event.target)) canvas.setState({ adding: undefined });
    };
    addEventListener('pointerdown', onPointerDown, true);
    return () => removeEventListener('pointerdown', onPointerDown, true);
  }, []);
  const items = useItems(adding);
  const [x, y] = adding.from;
  const left = Math.max(8, Math.min(x, (panel?.clientWidth ?? WIDTH) - WIDTH - 8));
  const top = Math.max(8, Math.min(y, (panel?.clientHeight ?? HEIGHT) - HEIGHT - 8));
  return (
    <Paper ref={host} withBorder shadow="md" className="sl-adding" style={{ left, top }}>
      <QuickPick
        label={t(adding.onto === undefined ? msg`Add a node…` : msg`Connect to…`)}
        items={items}
        onChoose={({ id }) => {
          close();
          take(editor, adding, id);
        }}
        onClose={back}
      />
    </Paper>
  );
}

function useItems(adding: AddNodeRequest) {
  const { t } = useTexts();
  const document = useEditorState((state) => state.history.document);
  const level = useMemo(() => levelAt(document, canvas.getState().path), [document]);
  const nodes = useNodeItems(level, adding.pending);
  const { pending, onto } = adding;
  return useMemo(() => {
    if (!pending || onto === undefined) return nodes;
    const group = t(msg`Inputs`);
    return socketOptions(level, pending, onto).map(({ socket, title }) => {
      const number = /\.(\d+)$/.exec(socket)?.[1];
      return { id: socket, label: number ? `${t(title)} ${number}` : t(title), group };
    });
  }, [nodes, level, pending, onto, t]);
}

function take(editor: Editor, { at, pending, onto }: AddNodeRequest, id: string): void {
  const level = levelAt(editor.store.getState().history.document, canvas.getState().path);
  if (pending && onto !== undefined) {
    editor.edit(connectCommand(level, edgeBetween(pending, onto, id)), msg`connect`);
    canvas.getState().viewport?.focus(onto);
    return;
  }
  const addition = addableNodes(level, pending).find((each) => each.id === id);
  if (!addition) return;
  // Aligned by its sockets at the edge's end; otherwise centered.
  const shift = pending ? (pending.side === 'outputs' ? 0 : -NODE_WIDTH) : -NODE_WIDTH / 2;
  const place = findFreePosition(level, addition, [at[0] + shift, at[1] - 40]);
  const { node, command } = addCommand(level, addition, place, pending);
  editor.edit(command, msg`add a node`);
  selectItems({ nodes: [node] });
  canvas.getState().viewport?.focus(node);
}
