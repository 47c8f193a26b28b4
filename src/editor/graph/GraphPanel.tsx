import '@xyflow/react/dist/base.css';
import './sockets.css';
import './graph.css';
import './pictures.css';
import { ReactFlowProvider } from '@xyflow/react';
import { type ReactNode, useRef } from 'react';
import { useTexts } from '../i18n/i18n.ts';
import { loadPreferences } from '../state/preferences.ts';
import { AddNode } from './AddNode.tsx';
import { Breadcrumb } from './Breadcrumb.tsx';
import { Canvas } from './Canvas.tsx';
import { canvas, useCanvas } from './canvas.ts';
import { Toolbar } from './Toolbar.tsx';
import { useCanvasKeys } from './useCanvasKeys.ts';
import { useKeptFocus } from './useKeptFocus.ts';

canvas.setState({ pictures: loadPreferences().nodePictures });

/** The document as a graph of nodes. */
export default function GraphPanel(): ReactNode {
  const { t } = useTexts();
  const panel = useRef<HTMLElement>(null);
  const adding = useCanvas((state) => state.adding);
  useCanvasKeys(panel);
  useKeptFocus(panel);
  return (
    <section ref={panel} className="sl-graph" aria-label={t('panel.graph')}>
      <ReactFlowProvider>
        <Canvas panel={panel} />
        <Breadcrumb />
        <Toolbar />
      </ReactFlowProvider>
      {adding && <AddNode key={`${adding.at}`} adding={adding} panel={panel.current} />}
    </section>
  );
}
