import { Alert, Divider, ScrollArea, Stack, Text, TextInput } from '@mantine/core';
import { IconAlertTriangle } from '@tabler/icons-react';
import { type ReactNode, useEffect, useMemo, useRef } from 'react';
import type { GraphLevel } from '../../../graph/analysis/sockets.ts';
import { type GraphNode, own } from '../../../graph/document/document.ts';
import { GROUP, GROUP_INPUT, GROUP_OUTPUT, groupKeyOf } from '../../../graph/document/structuralTypes.ts';
import { insideGroup } from '../../../graph/edits/fragment.ts';
import type { NodeProblem, NodeType } from '../../../graph/nodeType.ts';
import { msg } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { isFileNode } from '../../../nodes/project/fileNodes.ts';
import { useTexts } from '../../language/languageStore.ts';
import { drivenInputTitles } from '../../panels/drivenInputs.ts';
import { NodeParams, visibleParams } from '../../panels/NodeParams.tsx';
import { Remedy } from '../../panels/Remedy.tsx';
import { SaveFileButton } from '../../saving/SaveFileButton.tsx';
import { useEditor, useEditorState } from '../../state/context.tsx';
import { existingPath, flatNodeId, levelAt, prunedSelection, useCanvas } from '../canvas/canvasState.ts';
import { problemsByNode } from '../cards/problems.ts';
import { GroupSockets } from './GroupSockets.tsx';
import { InputSources } from './InputSources.tsx';

/** The selected node: type, problem, inputs and parameters. */
export default function Inspector(): ReactNode {
  const { t } = useTexts();
  const document = useEditorState((state) => state.history.document);
  const path = useCanvas((state) => state.path);
  const chosen = useCanvas((state) => state.selection);
  const level = useMemo(() => levelAt(document, path), [document, path]);
  const { nodes } = prunedSelection(level, chosen);
  const id = nodes.at(-1);
  const node = id === undefined ? undefined : own(level.graph.nodes, id);
  return (
    <ScrollArea h="100%" type="auto" scrollbarSize={8} className="sl-panel">
      {id !== undefined && node ? (
        <NodeInspector key={id} id={id} node={node} level={level} flat={flatNodeId(existingPath(document, path), id)} />
      ) : (
        <Text size="sm" c="dimmed" p="md">
          {t(msg`Select a node in the graph to see its parameters here.`)}
        </Text>
      )}
    </ScrollArea>
  );
}

interface InspectedProps {
  readonly id: string;
  readonly node: GraphNode;
  readonly level: GraphLevel;
  /** Its id in evaluation results. */
  readonly flat: string;
}

function NodeInspector({ id, node, level, flat }: InspectedProps): ReactNode {
  const { t } = useTexts();
  const type = own(nodeLibrary, node.type);
  const problem = useEditorState((state) => problemsByNode(state.results).get(flat));
  const isCarrier = node.type === GROUP_INPUT || node.type === GROUP_OUTPUT;
  return (
    <Stack gap="sm" p="md" component="section" aria-label={t(node.title ?? type?.title ?? node.type)}>
      <div>
        <Text component="h2" size="sm" fw={600}>
          {t(type?.title ?? node.type)}
        </Text>
        {type && (
          <Text size="xs" c="dimmed" lh={1.5}>
            {t(type.help)}
          </Text>
        )}
      </div>
      <Title id={id} node={node} level={level} type={type} />
      {problem && <ProblemNote problem={problem} />}
      {!node.muted && isFileNode(node.type) && <SaveFileButton node={flat} />}
      <InputSources id={id} node={node} level={level} />
      {type && node.type !== GROUP && <Params id={id} node={node} level={level} type={type} flat={flat} />}
      {isCarrier && level.group !== undefined && (
        <GroupSockets level={level} side={node.type === GROUP_INPUT ? 'inputs' : 'outputs'} />
      )}
    </Stack>
  );
}

/** Title of the node, or of its group; focused when the inspector is opened by a command. */
function Title({ id, node, level, type }: Omit<InspectedProps, 'flat'> & { readonly type?: NodeType }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const field = useRef<HTMLInputElement>(null);
  const inspecting = useEditorState((state) => state.inspecting);
  useEffect(() => {
    if (!inspecting) return;
    editor.update({ inspecting: false });
    // Focus after the panel has come to the front.
    requestAnimationFrame(() => field.current?.focus());
  }, [inspecting, editor]);
  const group = node.type === GROUP ? own(level.document.groups, groupKeyOf(node)) : undefined;
  const held = group ? group.title : (node.title ?? '');
  const take = (title: string) => {
    if (title === held) return;
    if (group) editor.edit({ kind: 'set-group', group: groupKeyOf(node), value: { ...group, title } }, msg`rename`);
    else editor.edit(insideGroup(level.group, { kind: 'rename', node: id, title }), msg`rename`);
  };
  return (
    <TextInput
      key={held}
      ref={field}
      size="xs"
      label={t(msg`Name`)}
      placeholder={t(type?.title ?? node.type)}
      defaultValue={held}
      maxLength={200}
      onBlur={(event) => take(event.currentTarget.value)}
      onKeyDown={(event) => {
        if (event.key === 'Enter') take(event.currentTarget.value);
      }}
    />
  );
}

function ProblemNote({ problem: { message, place, remedy } }: { readonly problem: NodeProblem }): ReactNode {
  const { t } = useTexts();
  return (
    <Alert color="red" variant="light" p="xs" icon={<IconAlertTriangle size={16} />} role="status">
      <Stack gap={6}>
        <Text size="xs" ff="monospace" className="sl-place">
          {t(place)}
        </Text>
        <Text size="sm">{t(message)}</Text>
        {remedy && <Remedy remedy={remedy} />}
      </Stack>
    </Alert>
  );
}

function Params({ id, node, level, type, flat }: InspectedProps & { readonly type: NodeType }): ReactNode {
  const feeders = drivenInputTitles(level.graph, id);
  const shown = visibleParams(type, node.params, feeders);
  if (shown.length === 0) return null;
  return (
    <>
      <Divider />
      <NodeParams node={flat} type={type} set={node.params} visible={shown} inputTitles={feeders} />
    </>
  );
}
