import { Select, Stack } from '@mantine/core';
import { type ReactNode, useMemo, useState } from 'react';
import { edgeKey, type GraphNode, own } from '../../graph/document.ts';
import { inside } from '../../graph/edits/fragment.ts';
import { typesIn } from '../../graph/infer.ts';
import { type Level, socketsOf } from '../../graph/sockets.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { useTexts } from '../i18n/i18n.ts';
import { useStudio } from '../state/context.tsx';
import { connecting } from './edits.ts';
import { endsIn, faceOf, NEW_SOCKET, type SocketFace } from './face.ts';
import { edgeTo, fitsOf } from './fit.ts';

interface InputSourcesProps {
  readonly id: string;
  readonly node: GraphNode;
  readonly level: Level;
}

/** What feeds each input of a node, to be chosen from all that fits. */
export function InputSources({ id, node, level }: InputSourcesProps): ReactNode {
  const inputs = useMemo(() => {
    const around = {
      level,
      types: typesIn(level, nodeLibrary),
      edges: endsIn(level.graph.edges),
      resultOf: () => undefined,
      problemOf: () => undefined,
      pictures: false,
    };
    const face = faceOf(id, node, around);
    return face.rows.flatMap(({ input, title }) => (input && title === undefined ? [input] : []));
  }, [id, node, level]);
  const shown = inputs.filter(({ name }) => name !== NEW_SOCKET);
  if (shown.length === 0) return null;
  return (
    <Stack gap={6}>
      {shown.map((socket) => (
        <InputSource key={socket.name} id={id} level={level} socket={socket} />
      ))}
    </Stack>
  );
}

interface InputSourceProps {
  readonly id: string;
  readonly level: Level;
  readonly socket: SocketFace;
}

function InputSource({ id, level, socket }: InputSourceProps): ReactNode {
  const { any, t } = useTexts();
  const studio = useStudio();
  const [open, setOpen] = useState(false);
  const to = { node: id, input: socket.name };
  const from = own(level.graph.edges, edgeKey(to))?.from;
  const value = from ? `${from.node}.${from.output}` : null;
  const name = (node: string, output: string): string => {
    const held = own(level.graph.nodes, node);
    const title = held && socketsOf(level, held, nodeLibrary)?.outputs;
    const several = title && Object.keys(title).length > 1;
    const called = any(held?.title ?? nodeLibrary[held?.type ?? '']?.title ?? node);
    return several ? `${called} (${node}) · ${any(title[output]?.title ?? output)}` : `${called} (${node})`;
  };
  const sources = open ? sourcesFor(level, to) : from ? [from] : [];
  const take = (chosen: string | null) => {
    const [node, output] = chosen?.split('.') ?? [];
    if (node === undefined || output === undefined)
      studio.edit(inside(level.group, { kind: 'disconnect', to }), 'edit.disconnect');
    else {
      const edge = edgeTo({ node: id, side: 'inputs', socket: socket.name }, node, output);
      studio.edit(connecting(level, edge), 'edit.connect');
    }
  };
  return (
    <Select
      size="xs"
      label={`${any(socket.title)}${socket.number ? ` ${socket.number}` : ''}`}
      placeholder={t('inspector.notConnected')}
      nothingFoundMessage={t('inspector.noSource')}
      searchable
      clearable
      clearButtonProps={{ 'aria-label': t('graph.disconnect') }}
      value={value}
      data={sources.map(({ node, output }) => ({ value: `${node}.${output}`, label: name(node, output) }))}
      onDropdownOpen={() => setOpen(true)}
      onDropdownClose={() => setOpen(false)}
      onChange={take}
    />
  );
}

/** Every output of the level that an input can be fed with. */
function sourcesFor(level: Level, to: { readonly node: string; readonly input: string }) {
  const fits = fitsOf(level, { node: to.node, side: 'inputs', socket: to.input });
  return Object.entries(level.graph.nodes).flatMap(([node, held]) =>
    Object.keys(socketsOf(level, held, nodeLibrary)?.outputs ?? {})
      .filter((output) => fits(node, output))
      .map((output) => ({ node, output })),
  );
}
