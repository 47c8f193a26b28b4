import { useStoreApi } from '@xyflow/react';
import { useEffect, useRef } from 'react';
import type { GBuffer, Image } from '../../nodes/define.ts';
import { useServices } from '../services.tsx';
import { useStudio } from '../state/context.tsx';
import type { Studio } from '../state/studio.ts';
import { canvas, flatName, pathIn, useCanvas } from './canvas.ts';
import type { Face } from './face.ts';
import { NodePainter } from './nodePictures.ts';
import { outcomeOf } from './outcome.ts';
import { Patience } from './patience.ts';
import { pictured } from './preview.ts';

/** Between two looks at whether there is something to be drawn [ms]. */
const TICK = 200;

/** Keeps the pictures of the nodes in sight those of what they make now. */
export function useNodePictures(faces: ReadonlyMap<string, Face>): void {
  const studio = useStudio();
  const { stage } = useServices();
  const flow = useStoreApi();
  const on = useCanvas((state) => state.pictures);
  const shown = useRef(faces);
  shown.current = faces;
  useEffect(() => {
    if (!on) return;
    const painter = new NodePainter();
    const patience = new Patience();
    let busy = false;
    const timer = setInterval(() => {
      const besides = document.hidden || busy ? undefined : stage.besides?.();
      if (!besides) return;
      const { made, inSight } = nodesWithPictures(shown.current, studio);
      const seen = new Map([...inSight].map((name) => [name, made.get(name)!]));
      if (!patience.allows(seen, `${flow.getState().transform}`, besides, performance.now())) return;
      busy = true;
      const done = () => {
        busy = false;
      };
      // What a lost device cannot draw is drawn in the next life.
      painter.paint(made, inSight, besides).then(done, done);
    }, TICK);
    return () => {
      clearInterval(timer);
      painter.stop();
    };
  }, [on, studio, stage, flow]);
}

/** Of the level that is shown, what its nodes made, by their names in the evaluation; and which of them are in sight. */
function nodesWithPictures(faces: ReadonlyMap<string, Face>, studio: Studio) {
  const { history, results } = studio.store.getState();
  const { path, sight } = canvas.getState();
  const way = pathIn(history.document, path);
  const made = new Map<string, Image | GBuffer>();
  const inSight = new Set<string>();
  for (const face of faces.values()) {
    const { id, picture, rows, collapsed } = face;
    const name = flatName(way, id);
    const output = rows.find((row) => row.output)?.output?.name;
    const result = picture && outcomeOf(results, history.document, name, face);
    const value = result && output !== undefined ? pictured(result, output) : undefined;
    if (!value) continue;
    made.set(name, value);
    if (!collapsed && sight?.sees(id)) inSight.add(name);
  }
  return { made, inSight };
}
