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
export function useNodePictures(faces: ReadonlyMap<string, CardModel>): void {
  const studio = useEditor();
  const { viewport: stage } = useServices();
  const flow = useStoreApi();
  const on = useCanvas((state) => state.pictures);
  const shown = useRef(faces);
  shown.current = faces;
  useEffect(() => {
    if (!on) return;
    const painter = new NodePictureRenderer();
    const patience = new PictureThrottle();
    let busy = false;
    const timer = setInterval(() => {
      const besides = document.hidden || busy ? undefined : stage.besides?.();
      if (!besides) return;
      const { made, inSight } = nodesWithPictures(shown.current, studio);
      const seen = new Map([...inSight].map((name) => [name, made.get(name)!]));
      if (!patience.shouldRender(seen, `${flow.getState().transform}`, besides, performance.now())) return;
      busy = true;
      const done = () => {
        busy = false;
      };
      // Pictures that failed because the device was lost are rendered after it is recreated.
      painter.render(made, inSight, besides).then(done, done);
    }, TICK);
    return () => {
      clearInterval(timer);
      painter.stop();
    };
  }, [on, studio, stage, flow]);
}

/** Results of the shown level's nodes by evaluation id, and which of them are visible. */
function nodesWithPictures(faces: ReadonlyMap<string, CardModel>, studio: Editor) {
  const { history, results } = studio.store.getState();
  const { path, viewport: sight } = canvas.getState();
  const way = existingPath(history.document, path);
  const made = new Map<string, ImageSpec | GBufferSpec>();
  const inSight = new Set<string>();
  for (const face of faces.values()) {
    const { id, picture, rows, collapsed } = face;
    const name = flatNodeId(way, id);
    const output = rows.find((row) => row.output)?.output?.name;
    const result = picture && nodeResultOf(results, history.document, name, face);
    const value = result && output !== undefined ? previewedImage(result, output) : undefined;
    if (!value) continue;
    made.set(name, value);
    if (!collapsed && sight?.isVisible(id)) inSight.add(name);
  }
  return { made, inSight };
}
