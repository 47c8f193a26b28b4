import { useComputedColorScheme } from '@mantine/core';
import {
  Background,
  BackgroundVariant,
  type EdgeTypes,
  MiniMap,
  type NodeTypes,
  ReactFlow,
  SelectionMode,
  useStore,
} from '@xyflow/react';
import { type CSSProperties, type FocusEvent, type ReactNode, useMemo } from 'react';
import { GROUP } from '../../graph/structure.ts';
import { useTexts } from '../i18n/i18n.ts';
import { useStudio } from '../state/context.tsx';
import { contextOf, enter } from './actions.ts';
import { canvas, choose } from './canvas.ts';
import { BARE, FarPixel, pixelAt } from './far.ts';
import { type FlowNode, thingOf, type WireEdge } from './flow.ts';
import { FARTHEST } from './framing.ts';
import { NodeCard, RerouteDot } from './NodeCard.tsx';
import { FrameBox, NoteCard } from './NoteCard.tsx';
import { useFlow } from './useFlow.ts';
import { useNodePictures } from './useNodePictures.ts';
import { useSight } from './useSight.ts';
import { useWiring } from './useWiring.ts';
import { Wire } from './Wire.tsx';

const NODE_TYPES: NodeTypes = { card: NodeCard, dot: RerouteDot, note: NoteCard, frame: FrameBox };
const EDGE_TYPES: EdgeTypes = { wire: Wire };
/** The nodes and edges of the level that is shown. */
export function Canvas({ panel }: { readonly panel: React.RefObject<HTMLElement | null> }): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
  const scheme = useComputedColorScheme('dark');
  const flow = useFlow();
  const pixel = useStore(({ transform }) => pixelAt(transform[2]));
  const wiring = useWiring(flow.faces, panel);
  useSight(flow, panel);
  useNodePictures(flow.faces);
  const labels = useMemo(() => ({ 'minimap.ariaLabel': t('graph.minimap') }), [t]);
  const onDoubleClick = (_event: unknown, { id, data }: FlowNode) => {
    const context = contextOf(studio);
    if (!context) return;
    const { kind, key } = thingOf(id);
    if (kind !== 'node') canvas.setState({ writing: id });
    else if ('face' in data && data.face.type === GROUP) enter(context, key);
    else studio.change({ inspecting: true });
  };
  return (
    <FarPixel value={pixel}>
      <ReactFlow<FlowNode, WireEdge>
        className="sl-flow"
        aria-label={t('graph.canvas')}
        tabIndex={-1}
        data-far={pixel === undefined ? undefined : pixel > BARE ? 'bare' : 'far'}
        style={{ '--sl-pixel': `${pixel ?? 1}px` } as CSSProperties}
        colorMode={scheme}
        nodes={flow.nodes}
        edges={flow.edges}
        nodeTypes={NODE_TYPES}
        edgeTypes={EDGE_TYPES}
        onNodesChange={flow.onNodesChange}
        onEdgesChange={flow.onEdgesChange}
        {...wiring}
        onMoveStart={() => panel.current?.toggleAttribute('data-moving', true)}
        onMoveEnd={() => panel.current?.toggleAttribute('data-moving', false)}
        onNodeDoubleClick={onDoubleClick}
        onFocus={chooseFocused}
        onPaneClick={() => panel.current?.querySelector<HTMLElement>('.sl-flow')?.focus({ preventScroll: true })}
        minZoom={FARTHEST}
        maxZoom={2.5}
        selectionOnDrag
        selectionMode={SelectionMode.Partial}
        panOnDrag={[1, 2]}
        zoomOnDoubleClick={false}
        elevateNodesOnSelect
        edgesFocusable={false}
        disableKeyboardA11y
        deleteKeyCode={null}
        selectionKeyCode={null}
        panActivationKeyCode={null}
        zoomActivationKeyCode={null}
        multiSelectionKeyCode={['Shift', 'Control', 'Meta']}
        connectionRadius={24}
        reconnectRadius={9}
        nodeDragThreshold={3}
        ariaLabelConfig={labels}
        attributionPosition="bottom-left"
      >
        <Background variant={BackgroundVariant.Dots} gap={20} size={1} />
        <MiniMap<FlowNode> pannable zoomable nodeClassName={minimapClass} nodeBorderRadius={12} />
      </ReactFlow>
    </FarPixel>
  );
}

const minimapClass = ({ data, type }: FlowNode): string =>
  'face' in data ? `sl-mini sl-mini-${data.face.category}` : `sl-mini sl-mini-${type}`;

/** Going to a node by Tab chooses it. */
function chooseFocused({ target }: FocusEvent<HTMLElement>): void {
  const id = target.classList.contains('react-flow__node') ? target.dataset.id : undefined;
  if (id === undefined || !target.matches(':focus-visible')) return;
  const { kind, key } = thingOf(id);
  const { chosen, sight } = canvas.getState();
  if (chosen[`${kind}s`].includes(key)) return;
  choose({ [`${kind}s`]: [key] });
  if (kind === 'node') sight?.show(key);
}
