import { Divider, ScrollArea, Stack, Text, Tooltip } from '@mantine/core';
import { Fragment, type ReactNode } from 'react';
import { type GraphDocument, own } from '../../graph/document.ts';
import type { FlatNode } from '../../graph/flatten.ts';
import type { NodeType } from '../../graph/nodeType.ts';
import { chainOf } from '../../nodes/chain.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { useTexts } from '../i18n/i18n.ts';
import { useStudioState } from '../state/context.tsx';
import { feedersIn } from './driven.ts';
import { NodeParams, shownParams } from './NodeParams.tsx';
import { nodeTitle } from './nodeTitle.ts';

/** What a person reaches for most comes first; other nodes follow, the nearest to the output first. */
const ORDER = [
  'relativity-console',
  'relativity-rasterize',
  'deferred-lighting',
  'tone-map',
  'false-colour',
  'scene-camera',
  'scene',
];

interface Section {
  readonly node: FlatNode;
  readonly type: NodeType;
  /** What a person calls the node. */
  readonly title?: string;
}

/** The parameters of the nodes that make the picture. It is made from their descriptions and knows none of them. */
export function ControlsPanel(): ReactNode {
  const document = useStudioState((state) => state.history.document);
  const sections = sectionsOf(document);
  return (
    <ScrollArea h="100%" type="auto" scrollbarSize={8} className="sl-panel">
      <Stack gap="md" p="md">
        {sections.map((section, i) => (
          <Fragment key={section.node.id}>
            {i > 0 && <Divider />}
            <NodeSection section={section} feeders={feedersIn(document, section.node.id)} />
          </Fragment>
        ))}
      </Stack>
    </ScrollArea>
  );
}

interface NodeSectionProps {
  readonly section: Section;
  readonly feeders: Readonly<Record<string, string>>;
}

function NodeSection({ section, feeders }: NodeSectionProps): ReactNode {
  const { any } = useTexts();
  const { node, type, title } = section;
  const shown = shownParams(type, node.params);
  return (
    <Stack gap={10} component="section" aria-label={title ?? any(type.title)}>
      <Tooltip label={any(type.help)} position="top-start" openDelay={400}>
        <Text component="h2" size="xs" fw={600} c="dimmed" className="sl-section-title">
          {title ?? any(type.title)}
        </Text>
      </Tooltip>
      <NodeParams node={node.id} type={type} set={node.params} shown={shown} feeders={feeders} />
    </Stack>
  );
}

function sectionsOf(document: GraphDocument): Section[] {
  const place = (type: NodeType) => (ORDER.includes(type.id) ? ORDER.indexOf(type.id) : ORDER.length);
  return chainOf(document)
    .flatMap((node): Section[] => {
      const type = own(nodeLibrary, node.type);
      const title = nodeTitle(document, node.id);
      return type && isShown(type, title) ? [{ node, type, title }] : [];
    })
    .sort((a, b) => place(a.type) - place(b.type));
}

/** What is in the scene and how it moves is the Scene panel's; of what only computes, what a person has given a name is a control. */
const isShown = (type: NodeType, title: string | undefined): boolean =>
  type.category !== 'geometry' &&
  (type.category !== 'utility' || title !== undefined) &&
  Object.values(type.params).some((spec) => spec.kind !== 'text' || spec.choices);
