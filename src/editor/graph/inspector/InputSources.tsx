import { Select, Stack } from '@mantine/core';
import { type ReactNode, useMemo, useState } from 'react';
import { inferTypes } from '../../../graph/analysis/inferTypes.ts';
import { type GraphLevel, socketsOf } from '../../../graph/analysis/sockets.ts';
import { edgeKey, type GraphNode, own } from '../../../graph/document/document.ts';
import { insideGroup } from '../../../graph/edits/fragment.ts';
import { msg } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditor } from '../../state/context.tsx';
import { cardModel, connectedSockets, NEW_SOCKET, type SocketModel } from '../cards/cardModel.ts';
import { connectionCheck, edgeBetween } from '../commands/connections.ts';
import { connectCommand } from '../commands/edits.ts';

interface InputSourcesProps {
  readonly id: string;
  readonly node: GraphNode;
  readonly level: GraphLevel;
}

/** The source of each input of a node, selectable from all outputs that fit. */
export function InputSources({ id, node, level }: InputSourcesProps): ReactNode {
  const inputs = useMemo(() => {
    const around = {
      level,
      types: inferTypes(level, nodeLibrary),
      edges: connectedSockets(level.graph.edges),
      resultOf: () => undefined,
      problemOf: () => undefined,
      pictures: false,
    };
    const card = cardModel(id, node, around);
    return card.rows.flatMap(({ input, title }) => (input && title === undefined ? [input] : []));
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
  readonly level: GraphLevel;
  readonly socket: SocketModel;
}

function InputSource({ id, level, socket }: InputSourceProps): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const [open, setOpen] = useState(false);
  const to = { node: id, input: socket.name };
  const from = own(level.graph.edges, edgeKey(to))?.from;
  const value = from ? `${from.node}.${from.output}` : null;
  const name = (node: string, output: string): string => {
    const held = own(level.graph.nodes, node);
    const title = held && socketsOf(level, held, nodeLibrary)?.outputs;
    const several = title && Object.keys(title).length > 1;
    const called = t(held?.title ?? nodeLibrary[held?.type ?? '']?.title ?? node);
    return several ? `${called} (${node}) · ${t(title[output]?.title ?? output)}` : `${called} (${node})`;
  };
  const sources = open ? compatibleSources(level, to) : from ? [from] : [];
  const take = (chosen: string | null) => {
    const [node, output] = chosen?.split('.') ?? [];
    if (node === undefined || output === undefined)
      editor.edit(insideGroup(level.group, { kind: 'disconnect', to }), msg`disconnect`);
    else {
      const edge = edgeBetween({ node: id, side: 'inputs', socket: socket.name }, node, output);
      editor.edit(connectCommand(level, edge), msg`connect`);
    }
  };
  return (
    <Select
      size="xs"
      label={`${t(socket.title)}${socket.number ? ` ${socket.number}` : ''}`}
      placeholder={t(msg`not connected`)}
      nothingFoundMessage={t(msg`No matching output`)}
      searchable
      clearable
      clearButtonProps={{ 'aria-label': t(msg`Disconnect`) }}
      value={value}
      data={sources.map(({ node, output }) => ({ value: `${node}.${output}`, label: name(node, output) }))}
      onDropdownOpen={() => setOpen(true)}
      onDropdownClose={() => setOpen(false)}
      onChange={take}
    />
  );
}

/** All outputs of the level that fit an input. */
function compatibleSources(level: GraphLevel, to: { readonly node: string; readonly input: string }) {
  const fits = connectionCheck(level, { node: to.node, side: 'inputs', socket: to.input });
  return Object.entries(level.graph.nodes).flatMap(([node, held]) =>
    Object.keys(socketsOf(level, held, nodeLibrary)?.outputs ?? {})
      .filter((output) => fits(node, output))
      .map((output) => ({ node, output })),
  );
}
