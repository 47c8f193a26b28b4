import { Paper } from '@mantine/core';
import { type ReactNode, useEffect, useMemo, useRef } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import { useStudio, useStudioState } from '../state/context.tsx';
import type { Studio } from '../state/studio.ts';
import { additionsFor } from './additions.ts';
import { type Adding, canvas, choose, levelAt } from './canvas.ts';
import { adding as addCommand, connecting } from './edits.ts';
import { Finder } from './Finder.tsx';
import { edgeTo, offersOf } from './fit.ts';
import { freePlaceIn } from './room.ts';
import { NODE_WIDTH } from './shape.ts';
import { useNodeItems } from './useNodeItems.ts';

const WIDTH = 320;
const HEIGHT = 360;

/** The list of nodes that can be added, at the place where they are wanted. */
export function AddNode({ adding, panel }: { readonly adding: Adding; readonly panel: HTMLElement | null }): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
  const host = useRef<HTMLDivElement>(null);
  const close = () => canvas.setState({ adding: undefined });
  const back = () => {
    close();
    canvas.getState().sight?.focus();
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
      <Finder
        label={t(adding.onto === undefined ? 'graph.add' : 'graph.connectTo')}
        items={items}
        onChoose={({ id }) => {
          close();
          take(studio, adding, id);
        }}
        onClose={back}
      />
    </Paper>
  );
}

function useItems(adding: Adding) {
  const { any, t } = useTexts();
  const document = useStudioState((state) => state.history.document);
  const level = useMemo(() => levelAt(document, canvas.getState().path), [document]);
  const nodes = useNodeItems(level, adding.loose);
  const { loose, onto } = adding;
  return useMemo(() => {
    if (!loose || onto === undefined) return nodes;
    const group = t('graph.sockets');
    return offersOf(level, loose, onto).map(({ socket, title }) => {
      const number = /\.(\d+)$/.exec(socket)?.[1];
      return { id: socket, label: number ? `${any(title)} ${number}` : any(title), group };
    });
  }, [nodes, level, loose, onto, any, t]);
}

function take(studio: Studio, { at, loose, onto }: Adding, id: string): void {
  const level = levelAt(studio.store.getState().history.document, canvas.getState().path);
  if (loose && onto !== undefined) {
    studio.edit(connecting(level, edgeTo(loose, onto, id)), 'edit.connect');
    canvas.getState().sight?.focus(onto);
    return;
  }
  const addition = additionsFor(level, loose).find((each) => each.id === id);
  if (!addition) return;
  // By its sockets where the edge ends; else with its middle where it is wanted.
  const shift = loose ? (loose.side === 'outputs' ? 0 : -NODE_WIDTH) : -NODE_WIDTH / 2;
  const place = freePlaceIn(level, addition, [at[0] + shift, at[1] - 40]);
  const { node, command } = addCommand(level, addition, place, loose);
  studio.edit(command, 'edit.add');
  choose({ nodes: [node] });
  canvas.getState().sight?.focus(node);
}
