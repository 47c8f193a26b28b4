import { Divider, ScrollArea, Stack, Text, Tooltip } from '@mantine/core';
import { Fragment, type ReactNode } from 'react';
import type { FlatNode } from '../../graph/analysis/flatten.ts';
import { type GraphDocument, own } from '../../graph/document/document.ts';
import type { NodeType } from '../../graph/nodeType.ts';
import type { LocalizedText } from '../../messages/message.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { nodesFeedingOutput } from '../../nodes/project/outputChain.ts';
import { useTexts } from '../language/languageStore.ts';
import { useEditorState } from '../state/context.tsx';
import { drivenInputTitlesOf } from './drivenInputs.ts';
import { NodeParams, visibleParams } from './NodeParams.tsx';
import { userTitle } from './nodeTitle.ts';

/** Most used sections first; other nodes follow, nearest to the output first. */
const SECTION_ORDER = [
  'relativity-console',
  'relativity-rasterize',
  'deferred-lighting',
  'tone-map',
  'false-colour',
  'scene-camera',
  'scene',
];

interface ParamSection {
  readonly node: FlatNode;
  readonly type: NodeType;
  /** The user's title of the node. */
  readonly title?: string;
}

/** Parameters of the nodes that contribute to the picture, generated from their descriptions. */
export default function ControlsPanel(): ReactNode {
  const document = useEditorState((state) => state.history.document);
  const sections = sectionsOf(document);
  return (
    <ScrollArea h="100%" type="auto" scrollbarSize={8} className="sl-panel">
      <Stack gap="md" p="md">
        {sections.map((section, i) => (
          <Fragment key={section.node.id}>
            {i > 0 && <Divider />}
            <NodeSection section={section} inputTitles={drivenInputTitlesOf(document, section.node.id)} />
          </Fragment>
        ))}
      </Stack>
    </ScrollArea>
  );
}

interface NodeSectionProps {
  readonly section: ParamSection;
  readonly inputTitles: Readonly<Record<string, LocalizedText>>;
}

function NodeSection({ section, inputTitles: feeders }: NodeSectionProps): ReactNode {
  const { t } = useTexts();
  const { node, type, title } = section;
  const shown = visibleParams(type, node.params);
  return (
    <Stack gap={10} component="section" aria-label={title ?? t(type.title)}>
      <Tooltip label={t(type.help)} position="top-start" openDelay={400}>
        <Text component="h2" size="xs" fw={600} c="dimmed" className="sl-section-title">
          {title ?? t(type.title)}
        </Text>
      </Tooltip>
      <NodeParams node={node.id} type={type} set={node.params} visible={shown} inputTitles={feeders} />
    </Stack>
  );
}

function sectionsOf(document: GraphDocument): ParamSection[] {
  const place = (type: NodeType) =>
    SECTION_ORDER.includes(type.id) ? SECTION_ORDER.indexOf(type.id) : SECTION_ORDER.length;
  return nodesFeedingOutput(document)
    .flatMap((node): ParamSection[] => {
      const type = own(nodeLibrary, node.type);
      const title = userTitle(document, node.id);
      return type && isListed(type, title) ? [{ node, type, title }] : [];
    })
    .sort((a, b) => place(a.type) - place(b.type));
}

/** Scene content and motion are in the Scene panel; utility nodes are listed only if the user has titled them. */
const isListed = (type: NodeType, title: string | undefined): boolean =>
  type.category !== 'geometry' &&
  (type.category !== 'utility' || title !== undefined) &&
  Object.values(type.params).some((spec) => spec.kind !== 'text' || spec.choices);
