import { useStoreApi } from '@xyflow/react';
import { useEffect, useRef } from 'react';
import type { GBufferSpec, ImageSpec } from '../../../nodes/socketValues.ts';
import { useServices } from '../../services.tsx';
import { useEditor } from '../../state/context.tsx';
import type { Editor } from '../../state/editor.ts';
import { canvas, existingPath, flatNodeId, useCanvas } from '../canvas/canvasState.ts';
import type { CardModel } from '../cards/cardModel.ts';
import { nodeResultOf } from '../cards/nodeResult.ts';
import { previewedImage } from '../cards/resultPreview.ts';
import { NodePictureRenderer } from './nodePictures.ts';
import { PictureThrottle } from './pictureThrottle.ts';

/** Polling interval [ms]. */
const TICK = 200;

/** Keeps the pictures of visible nodes up to date. */
export function useNodePictures(cards: ReadonlyMap<string, CardModel>): void {
  const editor = useEditor();
  const { viewport: stage } = useServices();
  const flow = useStoreApi();
  const on = useCanvas((state) => state.pictures);
  const shown = useRef(cards);
  shown.current = cards;
  useEffect(() => {
    if (!on) return;
    const previewRenderer = new NodePictureRenderer();
    const throttle = new PictureThrottle();
    let busy = false;
    const timer = setInterval(() => {
      const previewContext = document.hidden || busy ? undefined : stage.besides?.();
      if (!previewContext) return;
      const { made, inSight: visible } = nodesWithPictures(shown.current, editor);
      const seen = new Map([...visible].map((name) => [name, made.get(name)!]));
      if (!throttle.shouldRender(seen, `${flow.getState().transform}`, previewContext, performance.now())) return;
      busy = true;
      const done = () => {
        busy = false;
      };
      // Pictures that failed because the device was lost are rendered after it is recreated.
      previewRenderer.render(made, visible, previewContext).then(done, done);
    }, TICK);
    return () => {
      clearInterval(timer);
      previewRenderer.stop();
    };
  }, [on, editor, stage, flow]);
}

/** Results of the shown level's nodes by evaluation id, and which of them are visible. */
function nodesWithPictures(cards: ReadonlyMap<string, CardModel>, editor: Editor) {
  const { history, results } = editor.store.getState();
  const { path, viewport } = canvas.getState();
  const way = existingPath(history.document, path);
  const made = new Map<string, ImageSpec | GBufferSpec>();
  const visible = new Set<string>();
  for (const card of cards.values()) {
    const { id, picture, rows, collapsed } = card;
    const name = flatNodeId(way, id);
    const output = rows.find((row) => row.output)?.output?.name;
    const result = picture && nodeResultOf(results, history.document, name, card);
    const value = result && output !== undefined ? previewedImage(result, output) : undefined;
    if (!value) continue;
    made.set(name, value);
    if (!collapsed && viewport?.isVisible(id)) visible.add(name);
  }
  return { made, inSight: visible };
}
