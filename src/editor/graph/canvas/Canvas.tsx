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
import { GROUP } from '../../../graph/document/structuralTypes.ts';
import { msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditor } from '../../state/context.tsx';
import { NodeCard, RerouteDot } from '../cards/NodeCard.tsx';
import { FrameBox, NoteCard } from '../cards/NoteCard.tsx';
import { CanvasPixelContext, canvasPixelSize, MAX_PICTURE_PIXEL } from '../cards/zoomedOutTitle.ts';
import { actionContext, enterGroup } from '../commands/actions.ts';
import { useNodePictures } from '../pictures/useNodePictures.ts';
import { canvas, selectItems } from './canvasState.ts';
import { MIN_ZOOM } from './fitView.ts';
import { type FlowNode, flowItem, type WireEdge } from './flowElements.ts';
import { useCanvasViewport } from './useCanvasViewport.ts';
import { useFlow } from './useFlow.ts';
import { useWiring } from './useWiring.ts';
import { Wire } from './Wire.tsx';

const NODE_TYPES: NodeTypes = { card: NodeCard, dot: RerouteDot, note: NoteCard, frame: FrameBox };
const EDGE_TYPES: EdgeTypes = { wire: Wire };
/** Nodes and edges of the shown level. */
export function GraphCanvas({ panel }: { readonly panel: React.RefObject<HTMLElement | null> }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const scheme = useComputedColorScheme('dark');
  const flow = useFlow();
  const pixel = useStore(({ transform }) => canvasPixelSize(transform[2]));
  const wiring = useWiring(flow.cards, panel);
  useCanvasViewport(flow, panel);
  useNodePictures(flow.cards);
  const labels = useMemo(
    () => ({
      'minimap.ariaLabel': t(msg`Overview of the graph`),
      'node.a11yDescription.default': t(msg`Arrow keys move the node, Enter opens the inspector, Delete removes it.`),
      'edge.a11yDescription.default': t(msg`A connection of two nodes.`),
    }),
    [t],
  );
  const onDoubleClick = (_event: unknown, { id, data }: FlowNode) => {
    const context = actionContext(editor);
    if (!context) return;
    const { kind, key } = flowItem(id);
    if (kind !== 'node') canvas.setState({ editing: id });
    else if ('card' in data && data.card.type === GROUP) enterGroup(context, key);
    else editor.update({ inspecting: true });
  };
  return (
    <CanvasPixelContext value={pixel}>
      <ReactFlow<FlowNode, WireEdge>
        className="sl-flow"
        aria-label={t(
          msg`Node graph. Tab goes from node to node, arrow keys move them, Shift A adds one, Enter opens the inspector, Ctrl K lists all commands.`,
        )}
        tabIndex={-1}
        data-far={pixel === undefined ? undefined : pixel > MAX_PICTURE_PIXEL ? 'bare' : 'far'}
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
        onFocus={selectFocused}
        onPaneClick={() => panel.current?.querySelector<HTMLElement>('.sl-flow')?.focus({ preventScroll: true })}
        minZoom={MIN_ZOOM}
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
    </CanvasPixelContext>
  );
}

const minimapClass = ({ data, type }: FlowNode): string =>
  'card' in data ? `sl-mini sl-mini-${data.card.category}` : `sl-mini sl-mini-${type}`;

/** Selects a node that gets the focus by Tab. */
function selectFocused({ target }: FocusEvent<HTMLElement>): void {
  const id = target.classList.contains('react-flow__node') ? target.dataset.id : undefined;
  if (id === undefined || !target.matches(':focus-visible')) return;
  const { kind, key } = flowItem(id);
  const { selection, viewport } = canvas.getState();
  if (selection[`${kind}s`].includes(key)) return;
  selectItems({ [`${kind}s`]: [key] });
  if (kind === 'node') viewport?.reveal(key);
}
