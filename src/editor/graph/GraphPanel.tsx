import { msg } from '../../messages/message.ts';
import '@xyflow/react/dist/base.css';
import './cards/sockets.css';
import './graph.css';
import './pictures/pictures.css';
import { ReactFlowProvider } from '@xyflow/react';
import { type ReactNode, useRef } from 'react';
import { useTexts } from '../language/languageStore.ts';
import { loadPreferences } from '../state/preferences.ts';
import { Breadcrumb } from './Breadcrumb.tsx';
import { GraphCanvas } from './canvas/Canvas.tsx';
import { canvas, useCanvas } from './canvas/canvasState.ts';
import { useCanvasKeys } from './canvas/useCanvasKeys.ts';
import { useFocusRestore } from './canvas/useFocusRestore.ts';
import { Toolbar } from './commands/Toolbar.tsx';
import { AddNode } from './search/AddNode.tsx';

canvas.setState({ pictures: loadPreferences().nodePictures });

/** The document as a node graph. */
export default function GraphPanel(): ReactNode {
  const { t } = useTexts();
  const panel = useRef<HTMLElement>(null);
  const adding = useCanvas((state) => state.adding);
  useCanvasKeys(panel);
  useFocusRestore(panel);
  return (
    <section ref={panel} className="sl-graph" aria-label={t(msg`Graph`)}>
      <ReactFlowProvider>
        <GraphCanvas panel={panel} />
        <Breadcrumb />
        <Toolbar />
      </ReactFlowProvider>
      {adding && <AddNode key={`${adding.at}`} adding={adding} panel={panel.current} />}
    </section>
  );
}
