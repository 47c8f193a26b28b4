import { ActionIcon, Group, Paper, Stack, Tooltip } from '@mantine/core';
import { IconPlaneDeparture, IconTrash } from '@tabler/icons-react';
import { type ReactNode, useMemo, useState } from 'react';
import type { FlatNode } from '../../../graph/analysis/flatten.ts';
import type { GraphDocument } from '../../../graph/document/document.ts';
import { resolveParams } from '../../../graph/nodeType.ts';
import { msg } from '../../../messages/message.ts';
import { nodeLibrary } from '../../../nodes/library.ts';
import { nearestToOutput, nodesFeedingOutput } from '../../../nodes/project/outputChain.ts';
import { flyCommand, flyNodesIn, removeFlightCommand } from '../../../nodes/project/projectCommands.ts';
import type { PictureSpec } from '../../../nodes/socketValues.ts';
import { isStatic, sampleTimes } from '../../../scene/motion/motion.ts';
import type { Scene } from '../../../scene/types.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useServices } from '../../services.tsx';
import { useEditor, useEditorState } from '../../state/context.tsx';
import { ObjectSelect } from '../ObjectSelect.tsx';
import { ParamControl } from '../ParamControl.tsx';
import { Section } from './Section.tsx';
import { wholes } from './wholes.ts';

/** Time mapping of the file's animation, and a motion added to an object. */
export function MotionSection({ picture }: { readonly picture: PictureSpec }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { observerController } = useServices();
  const document = useEditorState(({ history }) => history.document);
  const things = useMovablePrims(picture.scene);
  const flights = flyNodesIn(document);
  const [search, setSearch] = useState('');
  const add = (path: string | null) => {
    if (!path) return;
    setSearch('');
    const at = Math.round(observerController.observer.t * 1000) / 1000;
    editor.edit(flyCommand(document, path, at), msg`make it fly`);
  };
  return (
    <Section title={t(msg`Motion`)}>
      {moves(picture.scene) && <NearestParams type="retime" />}
      {sampled(picture.scene) && <NearestParams type="read" only="interpolation" />}
      {flights.map((node) => (
        <FlyParams key={node} node={node} things={things} />
      ))}
      <ObjectSelect
        label={t(msg`Make something fly`)}
        disabled={!nearestToOutput(document, 'scene-camera')}
        leftSection={<IconPlaneDeparture size={15} />}
        searchValue={search}
        onSearchChange={setSearch}
        value={null}
        data={things}
        onChange={add}
      />
    </Section>
  );
}

const nodeAt = (document: GraphDocument, id: string): FlatNode | undefined =>
  nodesFeedingOutput(document).find((node) => node.id === id);

const moves = ({ objects, cameras, lights }: Scene): boolean =>
  [...objects, ...cameras].some(({ motion }) => !isStatic(motion)) ||
  lights.some((light) => 'motion' in light && !isStatic(light.motion)) ||
  objects.some(({ lifetime }) => Number.isFinite(lifetime.birth) || Number.isFinite(lifetime.death));

const sampled = ({ objects, cameras }: Scene): boolean =>
  [...objects, ...cameras].some(({ motion }) => sampleTimes(motion) !== undefined);

interface MovablePrim {
  readonly value: string;
  readonly label: string;
}

/** Objects, and groups of several objects, by prim path. What consists of pieces is one object. */
function useMovablePrims({ objects }: Scene): readonly MovablePrim[] {
  const { t } = useTexts();
  const paths = useMemo(() => [...wholes(objects)].join('\n'), [objects]);
  return useMemo(() => {
    const counts = new Map<string, number>();
    for (const path of paths.split('\n')) {
      for (let at = path.length; at > 0; at = path.lastIndexOf('/', at - 1)) {
        const above = path.slice(0, at);
        counts.set(above, (counts.get(above) ?? 0) + 1);
      }
    }
    return [...counts]
      .sort(([a], [b]) => (a < b ? -1 : 1))
      .map(([value, count]) => ({ value, label: count > 1 ? t(msg`${value} (${count} objects)`) : value }));
  }, [paths, t]);
}

function FlyParams({ node, things }: { readonly node: string; readonly things: readonly MovablePrim[] }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const object = useEditorState(({ history }) => String(nodeAt(history.document, node)?.params.object ?? ''));
  const land = () =>
    editor.edit(removeFlightCommand(editor.store.getState().history.document, node), msg`end the flight`);
  return (
    <Paper withBorder p="xs" component="fieldset" aria-label={`${t(msg`Flight`)}: ${object}`} className="sl-flight">
      <Stack gap={10}>
        <Group gap={6} wrap="nowrap" align="end">
          <ObjectSelect
            flex={1}
            label={t(msg`What flies`)}
            allowDeselect={false}
            value={object}
            data={things.some(({ value }) => value === object) ? things : [{ value: object, label: object }, ...things]}
            onChange={(path) => path && editor.set(node, 'object', path, msg`make it fly`)}
          />
          <Tooltip label={t(msg`Move as in the file again`)} openDelay={400}>
            <ActionIcon
              variant="subtle"
              color="gray"
              size={30}
              aria-label={t(msg`Move as in the file again`)}
              onClick={land}
            >
              <IconTrash size={16} />
            </ActionIcon>
          </Tooltip>
        </Group>
        <MotionParams node={node} />
      </Stack>
    </Paper>
  );
}

/** Parameters of the node of a type that is nearest to the output, if there is one. */
function NearestParams({ type, only }: { readonly type: string; readonly only?: string }): ReactNode {
  const node = useEditorState(({ history }) => nearestToOutput(history.document, type)?.id);
  return node === undefined ? null : <MotionParams node={node} only={only} />;
}

/**
 * Controls of a node's parameters except text parameters, which have controls of their own here; or of a single one.
 */
function MotionParams({ node: id, only }: { readonly node: string; readonly only?: string }): ReactNode {
  const editor = useEditor();
  const node = useEditorState(({ history }) => nodeAt(history.document, id));
  const type = node && nodeLibrary[node.type];
  if (!type) return null;
  const resolved = resolveParams(type, node.params);
  const shown = Object.entries(type.params).filter(([name, { kind }]) =>
    only === undefined ? kind !== 'text' : name === only,
  );
  return shown.map(([name, spec]) => (
    <ParamControl
      key={name}
      spec={spec}
      set={node.params[name]}
      value={resolved[name] ?? spec.default}
      onChange={(value, gesture) => editor.set(id, name, value, spec.title, gesture)}
      onGestureEnd={editor.endGesture}
    />
  ));
}
